#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// Says whether a text begins like a Harwell-Boeing file. `third_line` begins with its type: "RSA".
bool is_harwell_boeing(std::string_view third_line);

/// Reads a matrix that Ansys writes by HBMAT in ASCII: types RSA (one triangle by columns) and RUA (both). Its title
/// names its role. Throws `Error` (input) for other types, for pointers that do not rise (Ansys 9 wrote such ones for
/// superelements), for rows beyond its rows, and for a truncated file.
ListedMatrix read_harwell_boeing(const StructureInput& input);

/// Says whether a line looks like the head of Ansys' mapping file.
bool is_ansys_mapping(std::string_view first_line);

/// Reads the labels of the rows in the mapping file that HBMAT writes: equation, node, UX to ROTZ.
std::vector<reduction::RowLabel> read_ansys_mapping(const StructureInput& input);

}  // namespace stridor::io::structure
