#pragma once

#include "stridor/sweep/store/chart_state.hpp"
#include "stridor/sweep/store/merge.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace stridor::io {

/// A chart to be computed on a cluster that Slurm manages.
struct SlurmJob {
    std::string program;     // absolute path
    std::string folder;      // absolute path; holds chart.toml
    std::size_t shares = 1;  // [1] tasks of the array
    int threads = 1;         // [1] of each
    std::string time;        // limit of each, as Slurm writes it: "2:00:00"; empty: the partition's
};

/// Most rounds of such a job: a refined chart takes two to four, and tasks whose time runs out go on in the next one.
inline constexpr int most_slurm_rounds = 10;

/// A script for `sbatch`, or for `bash` where jobs may not submit jobs: an array of shares that may be requeued at any
/// time, then the merge, again and again until nothing is missing, then the figures.
///
/// Throws `Error` (input) for a time that Slurm does not read, and for a path with a line end.
std::string slurm_script(const SlurmJob& job);

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
