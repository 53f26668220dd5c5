#pragma once

#include "stridor/analysis/friction/fit.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace stridor::analysis {

/// What runs at one condition say about friction.
struct FrictionAtCondition {
    std::string condition;  // "at 23 degC", for errors and reasons
    FrictionPoints data;
};

/// A law of friction whose numbers follow conditions.
struct FrictionOverConditions {
    std::vector<std::string> conditions;
    std::vector<double> temperatures;  // [degC] rising, shape [condition]; empty where it is not they that differ
    // criteria, deviations and counts of numbers over all conditions, by law; the numbers stand in `fits`
    FrictionFit whole;
    std::array<std::vector<FrictionFit>, 2> fits;  // with delta 1 and 2, shape [condition]
    std::vector<std::size_t> exponents;            // place in `fits` of each law of `whole`
    // [1] by how much Akaike's criterion of one law for all conditions is larger; NaN: not known
    double gain = std::numeric_limits<double>::quiet_NaN();
};

/// Fits one law to runs at several conditions: its kind and delta are common, its numbers are those of each condition.
///
/// Runs at different conditions are independent, so the criteria of a law add up, and the least sum decides. Whether
/// the conditions matter is asked of the same points: one law for all of them, with fewer numbers, against the laws of
/// each. Slips have friction of their own each, and are not asked. Throws `Error` (input) for no condition, and what
/// `friction_fit` throws.
FrictionOverConditions friction_over_conditions(const std::vector<FrictionAtCondition>& runs,
                                                const std::optional<MeasuringRig>& rig = {});

/// What runs at one temperature say about friction.
struct FrictionAtTemperature {
    double temperature = 0.0;  // [degC]
    FrictionPoints data;
};

/// Fits one law to runs at several temperatures, in any order. Throws `Error` (input) for fewer than two, and what
/// `friction_over_conditions` throws.
FrictionOverConditions friction_over_temperature(std::vector<FrictionAtTemperature> runs,
                                                 const std::optional<MeasuringRig>& rig = {});

/// Returns a law of `whole` as it is at a condition, both by their places.
const FittedLaw& law_at(const FrictionOverConditions& over, std::size_t law, std::size_t condition);

/// Returns what the data say of the laws, and of the temperature if it is that, in sentences.
std::string words_of(const FrictionOverConditions& over);

}  // namespace stridor::analysis
