#pragma once

#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <string>

namespace stridor::app {

/// Computes one share of a chart into its own store, and says what to do next. `share` is "3/16" or "auto": the task of
/// a Slurm array. Throws `Error` (input) where the folder holds another chart, and like `compute`.
void compute_share(const sweep::Study& study, const std::filesystem::path& folder, const std::string& share,
                   int threads);

/// Throws `Error` (input) where shares of the chart in this folder hold cells that its own store lacks: they would be
/// computed anew.
void expect_merged(const sweep::Study& study, const std::filesystem::path& folder);

/// How a chart is computed by Slurm.
struct SlurmOptions {
    std::size_t shares = 0;  // 0: it is not
    std::string time;
};

/// Prints the job script; writes the chart's file, which the job reads, and nothing else.
void print_slurm_script(const sweep::Study& study, const std::filesystem::path& folder, const SlurmOptions& options,
                        int threads);

}  // namespace stridor::app
