#pragma once

#include "stridor/advice/design_space.hpp"
#include "stridor/classification/verdict.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Verdicts in the words of who does not know the model.
namespace stridor::report {

/// "While the plate is going (V > 0) the contact squeals: ..." One sentence with what happens, how often and how loud.
std::string plain_words(const classification::Verdict& verdict);

/// Names the phase of a verdict: "going".
std::string phase_name(const classification::Verdict& verdict);

/// Lists starts: "rest, sliding, stuck".
std::string start_words(const std::vector<parameters::Initial>& starts);

/// Lists the motions a design is judged by: "going, coming, from rest, sliding, stuck".
std::string judged_words(const advice::DesignSpace& space);

/// Writes a quantity with its unit: "0.12 kg".
std::string measured(std::string_view key, double value);

}  // namespace stridor::report
