#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Says whether a file begins as a binary OUTPUT4 file does: with a Fortran record of 24 or 48 bytes.
bool is_output4_binary(std::string_view beginning);

/// Reads the matrices of a binary OUTPUT4 file of Nastran or OptiStruct: either order of bytes, words of 4 or 8 bytes,
/// dense, sparse or sparse with BIGMAT, single or double; with role by name. They have no labels: those come from a
/// table. Rectangular matrices and loads are left out.
///
/// Throws `Error` (input) for a complex matrix of a structure, a row beyond its rows, records that do not fit, a
/// truncated file.
std::vector<ListedMatrix> read_output4_binary(const StructureInput& input);

}  // namespace stridor::io::structure
