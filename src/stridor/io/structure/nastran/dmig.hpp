#pragma once

#include "stridor/io/structure/listed_matrix.hpp"

namespace stridor::io::structure {

/// The content of a punch or bulk data file of Nastran or OptiStruct about a reduced part.
struct DmigFile {
    std::vector<ListedMatrix> matrices;                // with role by name
    std::map<std::string, Eigen::Vector3d> positions;  // of GRID cards
};

/// Says whether a text begins as bulk data with DMIG or GRID cards.
bool is_dmig(std::string_view beginning);

/// Reads DMIG and GRID cards in fields of 8 or 16 columns, or separated by commas and then of any length; other cards
/// are ignored. Component 0 or blank is a scalar point: a modal coordinate. Rectangular matrices have no entries.
///
/// Throws `Error` (input) at the line: a complex stiffness, mass or damping, a name that comes twice, an entry of a
/// matrix without a header or without its value, text behind column 80, a component beyond 6, and a node whose
/// displacements (field CD) or place (field CP) are in another system of coordinates.
DmigFile read_dmig(const StructureInput& input);

}  // namespace stridor::io::structure
