#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace stridor::base {

/// 64-bit FNV-1a hash of bytes (Fowler, Noll, Vo), for naming and change detection; not for security.
std::uint64_t fnv1a(std::string_view bytes);

/// The hash as 16 hexadecimal digits.
std::string hash_text(std::string_view bytes);

}  // namespace stridor::base
