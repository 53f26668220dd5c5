#pragma once

#include "stridor/verification/check.hpp"

#include <array>
#include <utility>
#include <vector>

/// The paper's system at Table 1's squeal: its modes, and where steady sliding loses its stability. Solved by an
/// independent program, to the digits that stand here.
namespace stridor::verification {

/// [Hz] natural frequencies of each contact state, without friction and damping.
inline constexpr std::array slip_frequencies{429.17, 916.36};
inline constexpr std::array stick_frequencies{709.88};
inline constexpr std::array open_frequencies{251.65, 503.29, 1591.55};  // plate, joint flexural, joint axial

/// [1] kinetic friction at which steady sliding changes, going.
inline constexpr double damped_flutter_onset = 0.44942;
inline constexpr double undamped_flutter_onset = 0.48554;
inline constexpr double undamped_divergence_onset = 2.576;
inline constexpr double locking_onset = 4.167;  // sprag-slip: no sliding equilibrium from there on

inline constexpr double undamped_flutter_frequency = 607.99;  // [Hz] at its onset

/// At the squeal case's friction, 0.6.
inline constexpr double squeal_growth = 736.65;    // [1/s]
inline constexpr double squeal_frequency = 592.0;  // [Hz]

/// Kinetic friction at which flutter begins, by the incidence angle [deg]; the case's own 70 deg stands above.
inline constexpr std::array<std::pair<double, double>, 5> flutter_onsets{
    {{60, .641}, {65, .5385}, {75, .378}, {80, .337}, {85, .404}}};

/// Natural frequencies of the paper's squeal case in each contact state, within 1e-4 of themselves.
std::vector<Check> natural_frequency_checks();

/// Onsets, growth and frequency of flutter, and what follows it, for the same case.
std::vector<Check> stability_checks();

}  // namespace stridor::verification
