#pragma once

#include "stridor/classification/verdict.hpp"

#include <string>
#include <vector>

/// Verdicts in the words of who does not know the model.
namespace stridor::report {

/// "While the plate is going (V > 0) the contact squeals: ..." One sentence with what happens, how often and how loud.
std::string plain_words(const classification::Verdict& verdict);

/// What it comes to for the design: "It makes noise while going and is quiet while coming."
std::string summary(const std::vector<classification::Verdict>& verdicts);

}  // namespace stridor::report
