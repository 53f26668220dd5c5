#pragma once

#include "stridor/parameters/case.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

namespace stridor::binding {

/// A case as Python holds it: never changed, so that runs may share it. Who changes a case gets another one.
struct CaseHandle {
    std::shared_ptr<const parameters::Case> of;
};

/// Numbers as an array that nobody may write, without a copy: the array owns them.
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
