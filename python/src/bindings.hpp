#pragma once

#include <pybind11/pybind11.h>

/// The module `stridor._stridor`: what Python cannot do by itself, and nothing else. Names, units, sentences and
/// checks come from the library's tables; what a user sees is made of it in python/stridor.
namespace stridor::binding {

namespace py = pybind11;

/// Cases and the field table.
void bind_case(py::module_& module);
/// One run and what it leaves behind.
void bind_simulation(py::module_& module);
/// Stability, advice, sounds and the noise library: answers that are documents.
void bind_answers(py::module_& module);
/// Many runs: points anywhere, and charts.
void bind_charts(py::module_& module);

}  // namespace stridor::binding
