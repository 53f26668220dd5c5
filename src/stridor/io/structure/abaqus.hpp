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

/// Does the first line that is no comment open a linear user element of Abaqus?
bool is_user_element(std::string_view first_data_line);

/// The matrices of a substructure as Abaqus writes them by *SUBSTRUCTURE MATRIX OUTPUT, OUTPUT FILE=USER DEFINED: nodes
/// in a comment, degrees of freedom of each, then lower triangles row by row, or all entries. Matrices that are neither
/// stiffness, mass nor damping are left out: loads, recovery.
///
/// Throws `Error` (input) at the line, and for a file without mass: CalculiX condenses the stiffness alone.
std::vector<ListedMatrix> read_user_element(const StructureInput& input);

}  // namespace stridor::io::structure
