#pragma once

#include "stridor/sweep/store/chart_state.hpp"
#include "stridor/sweep/store/merge.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace stridor::io {

/// A chart to be computed on a cluster with Slurm.
struct SlurmJob {
    std::string program;     // absolute path
    std::string folder;      // absolute path; holds chart.toml
    std::size_t shares = 1;  // [1] tasks of the array
    int threads = 1;         // [1] of each
    std::string time;        // limit of each, as Slurm writes it: "2:00:00"; empty: the partition's
};

/// Most rounds of such a job: a refined chart takes two to four, and tasks whose time runs out go on in the next one.
inline constexpr int most_slurm_rounds = 10;

/// Returns a script for `sbatch`, or for `bash` if jobs may not submit jobs: an array of shares that may be requeued at
/// any time, then the merge, again and again until nothing is missing, then the figures.
///
/// Throws `Error` (input) for a time that Slurm does not read, and for a path with a line end.
std::string slurm_script(const SlurmJob& job);

/// Returns how far a chart is: its cells, the process that fills each store, and the shares that lack cells.
std::string status_text(const sweep::Study& study, const sweep::ChartState& state);

/// Returns the numbers of those of `count` shares that lack cells, as sbatch's --array takes them: "0,3,7-9"; all of
/// them if none was begun, empty if none lacks any.
std::string lacking_text(const sweep::ChartState& state, std::size_t count);

/// Returns the content of `status_text` as JSON, schema "stridor.chart-status/1".
std::string status_json(const sweep::Study& study, const sweep::ChartState& state);

/// Returns the gaps of a merge, "15 of 16 shares, 3124 cells missing", with the shares; empty if nothing is missing.
std::string missing_text(const sweep::Study& study, const sweep::MergeReport& report);

}  // namespace stridor::io
