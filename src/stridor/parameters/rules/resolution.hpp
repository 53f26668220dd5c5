#pragma once

#include "stridor/parameters/rules/check.hpp"

#include <vector>

namespace stridor::parameters {

/// Most reversals of a drive in one run, and most samples of a sampled one: what is prepared for each is kept in
/// memory.
///
/// 200,000 reversals take 20 MB, four million samples 300 MB. Slower drives than 27 Hz have an hour.
inline constexpr double most_reversals = 2e5;
inline constexpr double most_samples = 4e6;

/// Largest magnitude of any number of a case, in its SI unit: products of larger ones leave double precision.
inline constexpr double largest_number = 1e75;

/// Largest ratio of two numbers that are added up: beyond it less than four digits of the smaller one are left.
inline constexpr double most_apart = 1e12;

/// Adds what double precision cannot follow: numbers whose products leave it, rates far beyond the run's length,
/// stiffnesses and masses of which the smaller one drowns in the rounding of the larger, more reversals than fit into
/// memory.
///
/// Looks at each number by itself first; a case with findings there is not looked at further.
void find_unresolvable(CaseView at, std::vector<Finding>& found);

}  // namespace stridor::parameters
