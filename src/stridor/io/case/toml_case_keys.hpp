#pragma once

#include "stridor/io/case/complaints.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <string>
#include <vector>

/// Which keys a case may have, must have, and has for nothing. The values stand in `toml_case`.
namespace stridor::io {

/// Complains of unknown sections and keys, and of sections that are values. Returns the keys that misspelt ones stand
/// for, so that these are not called missing, too.
std::vector<std::string> check_known(const DocumentView& view, Complaints& complaints);

/// Complains of what must be there for this case and is not, apart from keys that are there and could not be read.
/// Returns what is missing.
std::vector<std::string> check_complete(const parameters::Case& c, const DocumentView& view,
                                        const std::vector<std::string>& unread, Complaints& complaints);

/// Says whether a key stands in the file for nothing, and without harm. It means nothing for the kinds that the file
/// itself chooses (`of_file`), and its value is the default or the one that a case to start from has: who changes a
/// kind by hand leaves such keys behind.
bool is_idle(parameters::CaseView of_file, const parameters::Field& field, const TomlEntry& entry);

/// Complains of keys that mean nothing for this case and are not idle. A key of the file is held against the file's own
/// choices, an override against those that count in the end.
void check_belonging(const parameters::Case& of_file, const parameters::Case& c, const DocumentView& view,
                     Complaints& complaints);

}  // namespace stridor::io
