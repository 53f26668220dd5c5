#pragma once

#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>

namespace stridor::io {

/// Returns a case as bytes for another process on such a machine: whole, bit for bit, and however large. What a file
/// says stands in it as in a file; samples of a drive and matrices that no builder made stand beside that as numbers.
std::string packed_case(const parameters::Case& c);

/// Returns the case of such bytes. Throws `Error` (input) for bytes that are none, and whatever `read_case` refuses.
parameters::Case unpacked_case(std::string_view bytes);

}  // namespace stridor::io
