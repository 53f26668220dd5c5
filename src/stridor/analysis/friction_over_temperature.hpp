#pragma once

#include "stridor/analysis/friction_fit.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace stridor::analysis {

/// What runs at one temperature say about friction.
struct FrictionAtTemperature {
    double temperature = 0.0;  // [degC]
    FrictionPoints data;
};

/// A law of friction whose numbers follow the temperature.
struct FrictionOverTemperature {
    std::vector<double> temperatures;  // [degC] rising
    // criteria, deviations and counts of numbers over all temperatures, by law; the numbers stand in `fits`
    FrictionFit whole;
    std::array<std::vector<FrictionFit>, 2> fits;  // with delta 1 and 2, shape [temperature]
    std::vector<std::size_t> exponents;            // place in `fits` of each law of `whole`
    // [1] by how much Akaike's criterion of one law for all temperatures is larger; NaN: not known
    double gain = std::numeric_limits<double>::quiet_NaN();
};

/// Fits one law to runs at several temperatures: its kind and delta are common, its numbers are those of each
/// temperature.
///
/// Runs at different temperatures are independent, so the criteria of a law add up, and the least sum decides. Whether
/// the temperature matters is asked of the same points: one law for all of them, with fewer numbers, against the laws
/// of each. Slips have friction of their own each, and are not asked. Throws `Error` (input) for fewer than two
/// temperatures, and what `friction_fit` throws.
FrictionOverTemperature friction_over_temperature(std::vector<FrictionAtTemperature> runs,
                                                  const std::optional<MeasuringRig>& rig = {});

/// Returns a law of `whole` as it is at a temperature, both by their places.
const FittedLaw& law_at(const FrictionOverTemperature& over, std::size_t law, std::size_t temperature);

/// Returns what the data say of the laws, and of the temperature, in sentences.
std::string words_of(const FrictionOverTemperature& over);

}  // namespace stridor::analysis
