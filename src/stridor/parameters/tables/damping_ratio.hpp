#pragma once

#include "stridor/parameters/case.hpp"

#include <optional>
#include <string>
#include <string_view>

/// Damping of a spring as a share of critical: zeta = c / (2 sqrt(k m)), k and m its own spring and mass, the others at
/// rest.
namespace stridor::parameters {

/// Largest share that is taken [1]; a spring with ten times its critical damping creeps.
inline constexpr double most_damping_ratio = 10.0;

/// Returns the share that a text says: "15 %" and "damping ratio 0.15" are 0.15, and so is "loss factor 0.3" (eta = 2
/// zeta at the natural frequency, c = eta sqrt(k m)). Nothing for any other text.
std::optional<double> parse_damping_ratio(std::string_view text);

/// Returns "damping ratio 0.15", which reads back as the same number.
std::string damping_ratio_text(double ratio);

/// Returns where a case keeps the ratio of the damping with that key; nullptr for any other key.
std::optional<double>* damping_ratio_of(CaseToSet at, std::string_view key);
const std::optional<double>* damping_ratio_of(CaseView at, std::string_view key);

/// Makes every damping that is known as a share what it is with the present stiffnesses and masses:
/// c = 2 zeta sqrt(k m).
void keep_damping_ratios(Case& c);

}  // namespace stridor::parameters
