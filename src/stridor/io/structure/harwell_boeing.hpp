#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Do the lines of a text look like the head of a Harwell-Boeing file? `third_line` begins with its type: "RSA".
bool is_harwell_boeing(std::string_view third_line);

/// A matrix that Ansys writes by HBMAT in ASCII: types RSA (one triangle by columns) and RUA (both). Its title tells
/// what it is. Throws `Error` (input) for other types, for pointers that do not rise (Ansys 9 wrote such ones for
/// superelements), for rows beyond its rows, and for a file that is cut off.
ListedMatrix read_harwell_boeing(const StructureInput& input);

/// Does a line look like the head of Ansys' mapping file?
bool is_ansys_mapping(std::string_view first_line);

/// The labels of the rows in the mapping file that HBMAT writes: equation, node, UX to ROTZ.
std::vector<reduction::RowLabel> read_ansys_mapping(const StructureInput& input);

}  // namespace stridor::io::structure
