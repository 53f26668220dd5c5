#pragma once

#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace stridor::app {

/// Computes a study in its store, with progress on stderr, or goes on with it. Returns all cells.
///
/// Throws `Error` (interrupted) after SIGINT or SIGTERM, with the way to go on, and the store's errors.
sweep::SweepResult compute(const sweep::Study& study, const std::filesystem::path& store_file, int threads);

/// Runs a sweep with progress on stderr, until SIGINT or SIGTERM stops it. It sets its options' stop and progress.
sweep::RunReport fill(const sweep::Study& study, sweep::CellKeeper& keeper, sweep::RunOptions options,
                      const Interrupt& interrupt);

/// Returns the error (interrupted) of a sweep that was stopped: how far it came, and how to go on.
Error stopped(const sweep::RunReport& report, const std::filesystem::path& store_file);

/// Says on stderr whose store was taken over, if it was.
void say_takeover(const sweep::Store& store);

/// Returns the diagram of a study over one axis, kept in `file` while it is computed. Throws `Error` (interrupted)
/// after SIGINT or SIGTERM.
std::vector<sweep::DiagramCell> compute_diagram(const sweep::SweepResult& result, const std::filesystem::path& file,
                                                int threads);

/// Computes one share of a chart into its own store, and says what to do next. `share` is "3/16" or "auto": the task of
/// a Slurm array. Throws `Error` (input) if the folder holds another chart, and the errors of `compute`.
void compute_share(const sweep::Study& study, const std::filesystem::path& folder, const std::string& share,
                   int threads);

/// Throws `Error` (input) if shares of the chart in this folder hold cells that its own store lacks: they would be
/// computed anew.
void expect_merged(const sweep::Study& study, const std::filesystem::path& folder);

/// The options of a chart that Slurm computes.
struct SlurmOptions {
    std::size_t shares = 0;  // 0: without Slurm
    std::string time;
};

/// Prints the job script; writes the chart's file, which the job reads, and nothing else.
void print_slurm_script(const sweep::Study& study, const std::filesystem::path& folder, const SlurmOptions& options,
                        int threads);

}  // namespace stridor::app
