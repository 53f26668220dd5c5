#pragma once

#include "stridor/hearing/heard_recordings.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// The table of a folder of recordings: `expected.csv`, else the first table of `README.md` that has the columns `file`
/// and `expected`; other columns are not looked at.
///
/// "squeak or creak" accepts both; what stands behind a comma is a remark ("squeal, near squeak" accepts squeal only).
/// The name "scrape_01 .. 04.ogg" stands for four files. Throws `Error`: input for a folder without such a table, a row
/// that cannot be read, a file that is not there; io for what cannot be read.
std::vector<hearing::Expectation> read_expectations(const std::string& folder);

}  // namespace stridor::io
