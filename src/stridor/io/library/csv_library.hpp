#pragma once

#include "stridor/noise_library/entry.hpp"

#include <span>
#include <string>

namespace stridor::io {

/// "stridor.library/1" as CSV text: a row per entry that was read with its figures; its id, its fields without
/// documents, and a column for each figure that any of them has. What is unknown is an empty field.
std::string library_csv(std::span<const noise_library::Entry> entries);

}  // namespace stridor::io
