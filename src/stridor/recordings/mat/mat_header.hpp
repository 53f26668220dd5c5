#pragma once

// What a MAT file says of itself before anything is unpacked. Private to this folder.

#include "stridor/recordings/raw_signal.hpp"

#include <optional>
#include <string_view>

namespace stridor::recordings::mat {

/// Versions of the format.
enum class Version { four, five, seven_three };  // five is MATLAB's "-v6" and, packed, "-v7"

/// The version of the file that begins so; nothing where it is no MAT file.
std::optional<Version> version_of(std::string_view beginning);

/// Follows the lengths of a file's variables from one to the next: the library fills with zeros what is cut off. HDF5
/// looks itself. Throws `Error` (input) where they do not end with the file.
void check_length(const SignalInput& input, Version version);

}  // namespace stridor::recordings::mat
