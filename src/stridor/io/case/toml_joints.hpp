#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_document.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// A file with `[[joint]]` tables as if it had one joint: its keys are "joint.mass", "contact.preload". What is about
/// one joint alone has the number of that (`TomlEntry::joint`). Places are those of the file.
struct JointsDocument {
    std::vector<std::string> names;
    TomlDocument document;
};

/// Says whether a file lists its joints, as `[[joint]]`.
bool lists_joints(const TomlDocument& document);

/// Takes such a file apart. An override of "joint.NAME.key" is that joint's; one of "joint.key" or "contact.key" is
/// everyone's. So are a list "temperature.joint.NAME.key" and one of "temperature.key". Adds what is wrong with names
/// and sections to the complaints.
JointsDocument joints_document(const TomlDocument& document, Complaints& complaints);

}  // namespace stridor::io
