#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace stridor::binding {

/// Text of the library as a Python string; bytes that are no UTF-8 become replacement characters.
inline pybind11::str python_text(std::string_view text) {
    PyObject* object = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (object == nullptr) throw pybind11::error_already_set();
    return pybind11::reinterpret_steal<pybind11::str>(object);
}

}  // namespace stridor::binding
