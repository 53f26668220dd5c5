#pragma once

#include "stridor/advice/design_space.hpp"
#include "stridor/classification/verdict.hpp"

#include <string>
#include <string_view>
#include <vector>

/// Verdicts in words for readers who do not know the model.
namespace stridor::report {

/// Returns a verdict in one sentence, with how often and how loud: "While the plate is going (V > 0) the contact
/// squeals: ..."
std::string plain_words(const classification::Verdict& verdict);

/// Returns the phase of a verdict: "going".
std::string phase_name(const classification::Verdict& verdict);

/// Returns starts as a list: "rest, sliding, stuck".
std::string start_words(const std::vector<parameters::Initial>& starts);

/// Returns the motions by which a design is judged: "going, coming, from rest, sliding, stuck".
std::string judged_words(const advice::DesignSpace& space);

/// Returns a quantity with its unit: "0.12 kg".
std::string measured(std::string_view key, double value);

}  // namespace stridor::report
