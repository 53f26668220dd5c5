#pragma once

#include "stridor/io/case/own_structure/structure_contacts.hpp"
#include "stridor/io/case/own_structure/toml_section.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/reduction/part.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What stands before the number of a table of a spring.
inline constexpr std::string_view spring_opening = "structure.spring.";

/// Returns what may stand in a table of a spring: where it is, and its fields (`parameters::spring_fields`).
std::span<const std::string_view> spring_keys();

/// Reads the [[structure.spring]] tables of a document; the CSV files of force that they name are opened. Springs go
/// between rows of a part and the ground, or between two nodes. The
/// contacts of `own` say whether a preload presses it.
///
/// Throws `Error` (input) at the place for a node or row that is not there, a direction that is zero or has another
/// number of components, two springs of one name, what `parameters::problem_of` says, and a share of the preload where
/// there is none.
std::vector<parameters::OwnSpring> springs_in(const TomlDocument& document, const reduction::ElasticPart& part,
                                              const parameters::OwnStructure& own);

}  // namespace stridor::io
