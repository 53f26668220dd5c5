#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Says whether a line looks like the header of an ASCII OUTPUT4 matrix: four integers of eight columns, then a name.
bool is_output4(std::string_view first_line);

/// Reads the matrices of an ASCII OUTPUT4 file of Nastran or OptiStruct, dense, sparse or sparse with BIGMAT, with role
/// by name. They have no labels: those come from a table. Rectangular matrices and loads are left out.
///
/// Throws `Error` (input) at the line: a complex matrix of a structure, a row beyond its rows, a truncated file.
std::vector<ListedMatrix> read_output4(const StructureInput& input);

}  // namespace stridor::io::structure
