#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

#include <functional>
#include <optional>
#include <string>

namespace stridor::io::structure {

/// Opens a file that a deck includes; nothing where it is not to be had.
using IncludeOpener = std::function<std::optional<StructureInput>(const std::string& name, const std::string& from)>;

/// The files that CalculiX writes for `*FREQUENCY, SOLVER=MATRIXSTORAGE`, and its deck.
struct CalculixFiles {
    StructureInput stiffness;            // job.sti: row, column, value of the upper triangle
    StructureInput mass;                 // job.mas: likewise
    StructureInput labels;               // job.dof: a line "node.component" for each row
    std::optional<StructureInput> deck;  // job.inp: places and sets of nodes
    IncludeOpener open_include = nullptr;
};

/// A part as CalculiX stores it. Throws `Error` (input) for labels that repeat (beams and shells are expanded to
/// solids), components other than 1 to 3, matrices of another run, a deck with contact pairs, and rotations of a rigid
/// body whose node the deck does not name. Rotations of a named ROT NODE become components 4 to 6.
reduction::ElasticPart read_calculix(const CalculixFiles& files);

/// Labels of a .dof file.
std::vector<reduction::RowLabel> read_calculix_labels(const StructureInput& input);

/// A .sti or .mas file.
ListedMatrix read_calculix_matrix(const StructureInput& input, MatrixRole role);

}  // namespace stridor::io::structure
