#pragma once

// The header of a MAT file, read before anything is unpacked. Private to this folder.

#include "stridor/recordings/raw_signal.hpp"

#include <optional>
#include <string_view>

namespace stridor::recordings::mat {

/// Versions of the format.
enum class Version { four, five, seven_three };  // five is MATLAB's "-v6" and, packed, "-v7"

/// Returns the version of the file with this beginning, or `std::nullopt` if it is not a MAT file.
std::optional<Version> version_of(std::string_view beginning);

/// Follows the lengths of a file's variables from one to the next, since the library fills a truncated end with zeros.
/// HDF5 checks that itself. Throws `Error` (input) if they do not end with the file.
void check_length(const SignalInput& input, Version version);

}  // namespace stridor::recordings::mat
