#pragma once

#include "stridor/io/structure/calculix.hpp"

#include <set>

namespace stridor::io::structure {

/// An element of a deck: what it is, "C3D8", and its nodes.
struct DeckElement {
    std::string type;
    std::vector<std::string> nodes;
};

/// What a deck of CalculiX tells of nodes, and of the elements between them. Materials and steps are passed over.
struct CalculixDeck {
    std::map<std::string, Eigen::Vector3d> positions;
    std::vector<reduction::NodeSet> sets;  // in the order of their first mention
    std::set<std::string> rotation_nodes;  // whose displacements are rotations of a rigid body
    std::vector<DeckElement> elements;
    std::set<std::string> held;  // nodes of *BOUNDARY
    std::vector<std::string> notes;
};

/// Reads *NODE, *ELEMENT, *NSET (GENERATE too), *BOUNDARY, *INCLUDE and *RIGID BODY. Throws `Error` (input) at the line
/// that is wrong: a contact pair (its springs would stand in the matrices), a file that is not there, includes deeper
/// than eight.
CalculixDeck read_calculix_deck(const StructureInput& input, const IncludeOpener& open_include);

}  // namespace stridor::io::structure
