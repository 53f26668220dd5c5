#pragma once

#include "stridor/noise_library/check.hpp"

namespace stridor::noise_library {

/// What the database of a library holds, read from a copy where it is: a page without its checksum is read as it
/// stands, and each entry is held against its digest. A first page that lost its checksum is replaced by that of a new
/// library, whose tables begin at the same pages. Throws `Error` where it is no library, or in use.
Saved saved_from(const std::filesystem::path& file, const LibraryOptions& options);

}  // namespace stridor::noise_library
