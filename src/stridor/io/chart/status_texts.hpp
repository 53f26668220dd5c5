#pragma once

#include "stridor/sweep/store/chart_state.hpp"
#include "stridor/sweep/store/merge.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace stridor::io {

/// How far a chart is: its cells, who fills which store, and the shares that lack cells.
std::string status_text(const sweep::Study& study, const sweep::ChartState& state);

/// Names those of `count` shares that lack cells by their numbers, as sbatch's --array takes them: "0,3,7-9"; all of
/// them where none was begun, empty where none lacks any.
std::string lacking_text(const sweep::ChartState& state, std::size_t count);

/// Tells what `status_text` does as JSON, schema "stridor.chart-status/1".
std::string status_json(const sweep::Study& study, const sweep::ChartState& state);

/// What a merge left open: "15 of 16 shares, 3124 cells missing", and of which shares; empty if nothing is missing.
std::string missing_text(const sweep::Study& study, const sweep::MergeReport& report);

}  // namespace stridor::io
