#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// What a table says of the rows of matrices that have no labels of their own.
struct RowTable {
    std::vector<reduction::RowLabel> labels;
    std::map<std::string, Eigen::Vector3d> positions;  // in the units of the table, or in m where its names have units
    std::vector<reduction::NodeSet> sets;
};

/// A component by name: 1 to 6, UX, UY, UZ, ROTX, ROTY, ROTZ, x, y, z; 0 for "", "0" and "none". Nothing for others.
std::optional<int> component_in(std::string_view text);

/// Does a text begin with the names of such a table?
bool is_row_table(std::string_view first_line);

/// Reads a CSV whose lines are the rows of the matrices, in their order: `node`, `component`, and, if they are there,
/// `x`, `y`, `z` and `set` (several with blanks between). Parted by commas, semicolons or tabs. Throws `Error` (input).
RowTable read_row_table(const StructureInput& input);

}  // namespace stridor::io::structure
