#pragma once

#include "stridor/sweep/following.hpp"

#include <string>

namespace stridor::io {

/// Returns the runs of a motion that was followed as a table: a row for each run and direction, with all figures of a
/// cell.
std::string following_csv(const sweep::Following& following);

/// Returns them as one JSON document, "stridor.following/1".
std::string following_json(const sweep::Following& following);

}  // namespace stridor::io
