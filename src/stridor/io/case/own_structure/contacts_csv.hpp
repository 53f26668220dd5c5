#pragma once

#include "stridor/io/case/own_structure/structure_contacts.hpp"
#include "stridor/io/structure/field_scanner.hpp"

#include <vector>

namespace stridor::io {

/// Reads contacts from a CSV, a contact or set in each line. Columns by name: normal and tangent, and as they are
/// needed name, node, set, against, interface, second_tangent, initial_gap, static_friction, kinetic_friction,
/// preload_share, drive_share, second_drive_share; a unit of lengths stands in brackets (`initial_gap [mm]`). Parted by
/// commas, semicolons or tabs. Throws `Error` (input).
std::vector<NamedContact> read_contacts_csv(const structure::StructureInput& input);

}  // namespace stridor::io
