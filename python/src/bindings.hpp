#pragma once

#include <pybind11/pybind11.h>

/// The module `stridor._stridor`: only the functions that Python cannot provide by itself. Names, units, sentences and
/// checks come from the library's tables; python/stridor makes the user's view of them.
namespace stridor::binding {

namespace py = pybind11;

/// Binds cases and the field table.
void bind_case(py::module_& module);
/// Binds one run and its results.
void bind_simulation(py::module_& module);
/// Binds stability, advice, sounds and the noise library: answers that are documents.
void bind_answers(py::module_& module);
/// Binds many runs: points anywhere, and charts.
void bind_charts(py::module_& module);

}  // namespace stridor::binding
