#pragma once

#include "stridor/io/structure/field_scanner.hpp"

#include <map>
#include <string>
#include <string_view>

namespace stridor::io::structure {

/// Says whether a file begins as a zip archive does.
bool is_zip(std::string_view beginning);

/// Returns the files of a zip archive by name, stored or deflated, read by libarchive.
///
/// Throws `Error` (input) for a damaged archive, two files of one name, more than 100 files, other compressions,
/// passwords, and files that together grow beyond 2 GiB.
std::map<std::string, std::string> read_zip(const StructureInput& input);

}  // namespace stridor::io::structure
