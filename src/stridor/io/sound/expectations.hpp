#pragma once

#include "stridor/classification/category.hpp"

#include <string>
#include <vector>

namespace stridor::io {

/// What somebody says a recording is.
struct Expectation {
    std::string file;                                    // with its folder
    std::string words;                                   // as they stand in the table: "squeak or creak"
    std::vector<classification::Category> categories{};  // any of these is right; never empty
};

/// The table of a folder of recordings: `expected.csv`, else the first table of `README.md` that has the columns `file`
/// and `expected`; other columns are not looked at.
///
/// "squeak or creak" accepts both; what stands behind a comma is a remark ("squeal, near squeak" accepts squeal only).
/// The name "scrape_01 .. 04.ogg" stands for four files. Throws `Error`: input for a folder without such a table, a row
/// that cannot be read, a file that is not there; io for what cannot be read.
std::vector<Expectation> read_expectations(const std::string& folder);

}  // namespace stridor::io
