#pragma once

#include "stridor/analysis/rates.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/check.hpp"

#include <array>
#include <utility>
#include <vector>

/// Table 1 of Elmaian et al. (2012): the four columns under their sinusoidal drive, 1 s. Irregular motions depend on
/// every rounding, so these are the exact engine's own digits, which every build repeats.
namespace stridor::verification {

/// One column of Table 1.
struct Table1Column {
    parameters::PaperCase which;
    /// [1] error of a share of time, against the exact engine: the largest of beta_2 at h = 1, 1/2, 1/4 and 1/8 us. It
    /// does not fall with h: a step moves the instants of impacts, irregular motion forgets them within milliseconds,
    /// and the spread of shares over 1 s remains. Halving h changes the shares by up to 0.0150 (quiet, which takes one
    /// of two courses), 0.0064 (squeal), 0.0128 (squeak) and 0.0105 (creak).
    double beta_2_error;
    std::array<analysis::Rates, 2> rates;  // [1] going, coming; of the whole phase
};

inline constexpr std::array<Table1Column, 4> table_1{{
    {parameters::PaperCase::quiet,
     .0150,
     {{{.slip = .8807455, .stick = .0731810, .separation = .0460735},
       {.slip = .9491487, .stick = .0502807, .separation = .0005706}}}},
    {parameters::PaperCase::squeal,
     .0205,
     {{{.slip = .1487222, .stick = .1726952, .separation = .6785826},
       {.slip = .8492444, .stick = .0565966, .separation = .0941591}}}},
    {parameters::PaperCase::squeak,
     .0151,
     {{{.slip = .4280422, .stick = .4367432, .separation = .1352146},
       {.slip = .5641435, .stick = .4358565, .separation = .0}}}},
    {parameters::PaperCase::creak,
     .0071,
     {{{.slip = .1294289, .stick = .8687976, .separation = .0017736},
       {.slip = .0772079, .stick = .9227921, .separation = .0}}}},
}};

/// [1] the digits are stored to seven places.
inline constexpr double table_1_exact_tolerance = 1e-6;

/// Returns a quarter more than the measured error of beta_2 [1].
constexpr double beta_2_tolerance(const Table1Column& column) {
    return 1.25 * column.beta_2_error;
}

/// Returns the checks of the shares of both engines.
std::vector<Check> table_1_checks();

/// Stick-slip of Table 1's squeak on a plate that moves with -0.1257 m/s, started stuck: a periodic motion, whose exact
/// piecewise linear solution converged to all digits that stand here (docs/methods/physics.md).
struct StickSlip {
    double preload = 0.0;         // [N]
    double stick_fraction = 0.0;  // [1] between 1 s and 2 s, no whole number of periods
    double period = 0.0;          // [s]
};

inline constexpr std::array<StickSlip, 3> stick_slips{{
    {200.0, .247471, 1.0374406e-3},
    {1000.0, .749445, 2.4849233e-3},
    {2000.0, .880442, 5.2618757e-3},
}};

/// Returns the checks of shares and periods of the exact engine.
std::vector<Check> constant_drive_checks();

// The paper's system at Table 1's squeal: its modes, and where steady sliding loses its stability. Solved by an
// independent program, to the digits given here.

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

/// Returns the checks of the natural frequencies of the paper's squeal case in each contact state, within 1e-4 of
/// themselves.
std::vector<Check> natural_frequency_checks();

/// Returns the checks of onsets, growth and frequency of flutter, and of the states beyond it, for the same case.
std::vector<Check> stability_checks();

}  // namespace stridor::verification
