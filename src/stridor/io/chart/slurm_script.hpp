#pragma once

#include <cstddef>
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

}  // namespace stridor::io
