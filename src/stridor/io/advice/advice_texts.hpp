#pragma once

#include "stridor/advice/advice.hpp"

#include <string>
#include <vector>

namespace stridor::io {

// The request for advice, as a command line writes it.

/// Reads "preload" or "preload=1:40 N": a quantity, within its usual range or this one. Throws `Error` (input), placed
/// at `--over`.
advice::AskedRange read_asked_range(const parameters::Case& c, const std::string& text);

/// Reads "preload=10%", "preload=10 % normal", "preload=2 N". Throws `Error` (input), placed at `--tolerance`.
advice::AskedTolerance read_asked_tolerance(const parameters::Case& c, const std::string& text);

/// Reads "going" and "sliding": the directions and starts by which a design is judged, each one empty for all. Throws
/// `Error` (input), placed at `--direction` or `--start`.
advice::AskedRuns read_asked_runs(const std::vector<std::string>& directions, const std::vector<std::string>& starts);

/// Returns "stridor.design/1": the headline of a design, its verdict each way and the changes of verdict close to it.
std::string standing_json(const advice::DesignStanding& design);

/// Returns "stridor.advice/1": the headline, the present verdict, the margin of each parameter with its scan, the
/// ranking, the nearest design of the other kind, the verified quieting changes, and the chance of noise within
/// tolerances.
std::string advice_json(const advice::Advice& advice);

}  // namespace stridor::io
