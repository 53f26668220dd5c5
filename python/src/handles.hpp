#pragma once

#include "stridor/parameters/case.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::binding {

/// A case as Python holds it. It never changes, so that runs may share it; a changed case is another object.
struct CaseHandle {
    std::shared_ptr<const parameters::Case> of;
};

/// Returns text of the library as a Python string; bytes that are not UTF-8 become replacement characters.
inline pybind11::str python_text(std::string_view text) {
    PyObject* object = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (object == nullptr) throw pybind11::error_already_set();
    return pybind11::reinterpret_steal<pybind11::str>(object);
}

/// Returns numbers as a read-only array without a copy: the array owns them.
template <typename Number>
pybind11::array_t<Number> array_of(std::vector<Number> numbers, const std::vector<pybind11::ssize_t>& shape) {
    auto owned = std::make_unique<std::vector<Number>>(std::move(numbers));
    const Number* data = owned->data();
    const pybind11::capsule owner(owned.release(), [](void* kept) { delete static_cast<std::vector<Number>*>(kept); });
    pybind11::array_t<Number> array(shape, data, owner);
    array.attr("flags").attr("writeable") = false;
    return array;
}

}  // namespace stridor::binding
