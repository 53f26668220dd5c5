#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_document.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// One joint of a file with `[[joint]]` tables: the file as it would be with this joint alone.
struct JointDocument {
    std::string name;
    TomlDocument document;  // its keys are "joint.mass", "contact.preload"; places are those of the file
};

/// Does a file list its joints, as `[[joint]]`?
bool lists_joints(const TomlDocument& document);

/// The joints of such a file in their order. An override of "joint.NAME.key" is that joint's; one of "joint.key" or
/// "contact.key" is everyone's. Likewise a list "temperature.joint.NAME.key" and one of "temperature.key". Adds what is
/// wrong with names and sections to the complaints.
std::vector<JointDocument> joint_documents(const TomlDocument& document, Complaints& complaints);

}  // namespace stridor::io
