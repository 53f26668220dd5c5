#pragma once

#include "stridor/base/csv_text.hpp"
#include "stridor/parameters/case.hpp"

#include <string>
#include <string_view>

namespace stridor::io {

/// Returns the first facts of a table about a case: schema "stridor.WHAT/1", version, commit, and the title if it has
/// one.
base::csv_text::Facts csv_opening(std::string_view what, const parameters::Case& c);

/// Adds each line "key = value" of a canonical text as a fact.
void add_lines(base::csv_text::Facts& facts, const std::string& canonical);

}  // namespace stridor::io
