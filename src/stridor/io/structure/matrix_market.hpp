#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Says whether a text begins as a Matrix Market file.
bool is_matrix_market(std::string_view beginning);

/// Reads a real matrix in Matrix Market format (NIST, Boisvert, Pozo and Remington, 1996): coordinate or array, general
/// or symmetric. Throws `Error` (input) for complex, pattern, skew-symmetric and rectangular ones, and if the number of
/// entries differs from the stated one.
ListedMatrix read_matrix_market(const StructureInput& input);

}  // namespace stridor::io::structure
