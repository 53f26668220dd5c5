#pragma once

#include "stridor/analysis/stability_scan.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/cell.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string_view>
#include <vector>

/// A motion that is followed along a quantity, up and then down: each run begins where the one before has ended. Where
/// the ways up and down differ the system has hysteresis: several motions, and its history says which.
namespace stridor::sweep {

/// Which way the quantity goes.
enum class FollowedWay { up, down };

inline constexpr std::array<std::string_view, 2> way_names{"up", "down"};

/// One run on the way.
struct FollowedRun {
    FollowedWay way = FollowedWay::up;
    double value = 0.0;         // of the quantity, in its unit
    std::vector<Cell> cells;    // shape [direction]
    bool is_continued = false;  // it begins where another run ended, not from the case's own start
};

/// Both ways, in the order in which they were run.
struct Following {
    parameters::Case base;
    analysis::ScanRange over;
    std::vector<parameters::Direction> directions;  // that of a constant drive; else going and coming
    std::vector<FollowedRun> runs;                  // up, then down from the last value but one
};

/// How a motion is followed.
struct FollowingOptions {
    std::stop_token stop;
    std::function<void(std::size_t done, std::size_t all)> progress{};
};

/// Follows the motion of a case along a quantity, from the first value to the last one and back.
///
/// The first run begins as the case says. The state goes on to the next value as it is: displacements from the
/// preloaded rest, velocities, contact states, the phase of the drive. A run without a result hands nothing on: the
/// next one begins where the last good one ended. Throws `Error`: input for a key that is no quantity, for ends outside
/// its range, and for a drive by force, whose ramp would begin anew; interrupted after a stop request.
Following follow(const parameters::Case& base, const analysis::ScanRange& over, const FollowingOptions& options = {});

/// Returns the values at which the ways up and down have other verdicts in one direction; rising.
std::vector<double> hysteresis(const Following& following, std::size_t direction);

}  // namespace stridor::sweep
