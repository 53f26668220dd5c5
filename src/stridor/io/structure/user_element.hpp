#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Does the first line that is no comment open a linear user element of Abaqus?
bool is_user_element(std::string_view first_data_line);

/// The matrices of a substructure as Abaqus writes them by *SUBSTRUCTURE MATRIX OUTPUT, OUTPUT FILE=USER DEFINED: nodes
/// in a comment, degrees of freedom of each, then lower triangles row by row, or all entries. Matrices that are neither
/// stiffness, mass nor damping are left out: loads, recovery.
///
/// Throws `Error` (input) at the line, and for a file without mass: CalculiX condenses the stiffness alone.
std::vector<ListedMatrix> read_user_element(const StructureInput& input);

}  // namespace stridor::io::structure
