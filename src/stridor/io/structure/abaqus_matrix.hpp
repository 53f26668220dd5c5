#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Does a line look like one of Abaqus' MATRIX INPUT: node, component, node, component, value? Commas part them, or
/// blanks.
bool is_abaqus_matrix(std::string_view first_data_line);

/// A matrix that Abaqus writes by *MATRIX OUTPUT, FORMAT=MATRIX INPUT (its default), or FORMAT=LABELS where that has
/// the same five numbers in a line. Upper, lower or both triangles.
/// Nodes with a negative number are internal, and stay as they are. Throws `Error` (input).
ListedMatrix read_abaqus_matrix(const StructureInput& input);

/// One in FORMAT=COORDINATE: row, column, value without labels, which must come from a table.
ListedMatrix read_coordinate_matrix(const StructureInput& input);

}  // namespace stridor::io::structure
