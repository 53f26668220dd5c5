#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Says whether a line looks like one of Abaqus' MATRIX INPUT: node, component, node, component, value, separated by
/// commas or blanks.
bool is_abaqus_matrix(std::string_view first_data_line);

/// Reads a matrix that Abaqus writes by *MATRIX OUTPUT, FORMAT=MATRIX INPUT (its default), or by FORMAT=LABELS if a
/// line has the same five numbers. Upper, lower or both triangles. Nodes with a negative number are internal, and stay
/// as they are. Throws `Error` (input).
ListedMatrix read_abaqus_matrix(const StructureInput& input);

/// Reads a matrix in FORMAT=COORDINATE: row, column, value without labels, which must come from a table.
ListedMatrix read_coordinate_matrix(const StructureInput& input);

/// Says whether the first line that is not a comment opens a linear user element of Abaqus.
bool is_user_element(std::string_view first_data_line);

/// Reads the matrices of a substructure as Abaqus writes them by *SUBSTRUCTURE MATRIX OUTPUT, OUTPUT FILE=USER DEFINED:
/// nodes in a comment, degrees of freedom of each, then lower triangles row by row, or all entries. Matrices other than
/// stiffness, mass and damping (loads, recovery) are left out.
///
/// Throws `Error` (input) at the line, and for a file without mass: CalculiX condenses only the stiffness.
std::vector<ListedMatrix> read_user_element(const StructureInput& input);

}  // namespace stridor::io::structure
