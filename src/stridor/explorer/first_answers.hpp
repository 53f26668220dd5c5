#pragma once

#include "stridor/explorer/page_file.hpp"

#include <string>

/// What the page in one file asks first, answered beforehand: it shows these answers while its module still begins.
namespace stridor::explorer {

/// Returns the page (`page_with_case`) with the answers to what it asks first, of this case or, if null, of the paper's
/// squeal. The page stays as it is where its module is of another commit than this program, where the case leans on
/// files, and where it has no result: then it asks its module.
std::string page_with_first_answers(std::string page, const StandingCase* standing);

}  // namespace stridor::explorer
