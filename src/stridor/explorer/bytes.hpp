#pragma once

#include "stridor/base/base64.hpp"

#include <bit>
#include <cstddef>
#include <span>
#include <string>

/// Arrays as bytes, little endian as every browser's typed arrays are, and as text for JSON.
namespace stridor::explorer {

static_assert(std::endian::native == std::endian::little, "arrays are handed over as they lie in memory");

/// Numbers as they lie in memory, lowest byte first.
template <typename T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// The same bytes in base 64.
template <typename T>
std::string base64_of(std::span<const T> values) {
    return base::base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace stridor::explorer
