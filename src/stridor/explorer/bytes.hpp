#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

/// Arrays as bytes, little endian as every browser's typed arrays are, and as text for JSON.
namespace stridor::explorer {

static_assert(std::endian::native == std::endian::little, "arrays are handed over as they lie in memory");

template <typename T>
std::string bytes_of(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// Base64 (RFC 4648, section 4).
std::string base64(std::string_view bytes);

template <typename T>
std::string base64_of(std::span<const T> values) {
    return base64({reinterpret_cast<const char*>(values.data()), values.size_bytes()});
}

}  // namespace stridor::explorer
