#pragma once

#include "stridor/io/structure/field_scanner.hpp"

#include <map>
#include <string>

namespace stridor::io::structure {

/// Does a file begin as a zip archive does?
bool is_zip(std::string_view beginning);

/// The files of a zip archive by name, stored or deflated, read by libarchive.
///
/// Throws `Error` (input) for a damaged archive, one of the same name twice, more than 100 files, other compressions,
/// passwords, and files that together grow beyond 2 GiB; `Error` (io) where libarchive is not on this machine.
std::map<std::string, std::string> read_zip(const StructureInput& input);

}  // namespace stridor::io::structure
