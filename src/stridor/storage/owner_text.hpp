#pragma once

#include "stridor/storage/owner_file.hpp"

#include <cstddef>
#include <string>
#include <string_view>

/// The text of an owner's file: lines of "key = value".
namespace stridor::storage {

/// No owner's file is longer.
inline constexpr std::size_t longest_owner_text = 1024;  // [bytes]

/// Of the same length whatever the count.
std::string owner_text(const Owner& owner);

/// Reads it; what is not there stays empty.
Owner read_owner(std::string_view text);

}  // namespace stridor::storage
