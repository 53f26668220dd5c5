#pragma once

#include "stridor/hearing/heard_recordings.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// Returns the table of a folder of recordings: the file `labels`, or, where that is empty, `expected.csv`, else the
/// first table of `README.md` that has the columns `file` and `expected`. The columns `source` or `repository`, and
/// `confidence` ("low" is not sure), are read where they are; others are not looked at.
///
/// "squeak or creak" and "squeak|creak" accept both; what stands behind a comma is a remark ("squeal, near squeak"
/// accepts squeal only). The name "scrape_01 .. 04.ogg" stands for four files. Throws `Error`: input for a folder
/// without such a table, a row that cannot be read, a file that is not there; io for what cannot be read.
std::vector<hearing::Expectation> read_expectations(const std::string& folder, const std::string& labels = {});

}  // namespace stridor::io
