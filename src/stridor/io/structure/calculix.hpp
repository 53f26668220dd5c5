#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

#include <functional>
#include <optional>
#include <set>
#include <string>

namespace stridor::io::structure {

/// Opens a file that a deck includes; returns `std::nullopt` if it is not available.
using IncludeOpener = std::function<std::optional<StructureInput>(const std::string& name, const std::string& from)>;

/// The files that CalculiX writes for `*FREQUENCY, SOLVER=MATRIXSTORAGE`, and its deck.
struct CalculixFiles {
    StructureInput stiffness;            // job.sti: row, column, value of the upper triangle
    StructureInput mass;                 // job.mas: row, column, value of the upper triangle
    StructureInput labels;               // job.dof: a line "node.component" for each row
    std::optional<StructureInput> deck;  // job.inp: places and sets of nodes
    IncludeOpener open_include = nullptr;
};

/// Reads a part as CalculiX stores it. Throws `Error` (input) for labels that repeat (beams and shells are expanded to
/// solids), components other than 1 to 3, matrices of another run, a deck with contact pairs, and rotations of a rigid
/// body whose node the deck does not name. Rotations of a named ROT NODE become components 4 to 6.
reduction::ElasticPart read_calculix(const CalculixFiles& files);

/// Reads the labels of a .dof file.
std::vector<reduction::RowLabel> read_calculix_labels(const StructureInput& input);

/// Reads a .sti or .mas file.
ListedMatrix read_calculix_matrix(const StructureInput& input, MatrixRole role);

/// An element of a deck: its type, "C3D8", and its nodes.
struct DeckElement {
    std::string type;
    std::vector<std::string> nodes;
};

/// The nodes and elements in a deck of CalculiX. Materials and steps are ignored.
struct CalculixDeck {
    std::map<std::string, Eigen::Vector3d> positions;
    std::vector<reduction::NodeSet> sets;  // in the order of their first mention
    std::set<std::string> rotation_nodes;  // whose displacements are rotations of a rigid body
    std::vector<DeckElement> elements;
    std::set<std::string> held;  // nodes of *BOUNDARY
    std::vector<std::string> notes;
};

/// Reads *NODE, *ELEMENT, *NSET (GENERATE too), *BOUNDARY, *INCLUDE and *RIGID BODY. Throws `Error` (input) at the
/// wrong line: a contact pair (its springs would stand in the matrices), a missing file, includes deeper than eight.
CalculixDeck read_calculix_deck(const StructureInput& input, const IncludeOpener& open_include);

}  // namespace stridor::io::structure
