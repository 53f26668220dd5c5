#pragma once

#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study.hpp"

#include <filesystem>
#include <vector>

namespace stridor::app {

/// Computes a study in its store, with progress on stderr, or goes on with it; all cells when it returns.
///
/// Throws `Error` (interrupted) after SIGINT or SIGTERM, saying how to go on, and what the store throws.
sweep::SweepResult compute(const sweep::Study& study, const std::filesystem::path& store_file, int threads);

/// Runs a sweep with progress on stderr, until SIGINT or SIGTERM stops it. Its options' stop and progress are set here.
sweep::RunReport fill(const sweep::Study& study, sweep::CellKeeper& keeper, sweep::RunOptions options,
                      const Interrupt& interrupt);

/// The error (interrupted) of a sweep that was stopped: how far it came, and how to go on.
Error stopped(const sweep::RunReport& report, const std::filesystem::path& store_file);

/// Says on stderr whose store was taken over, if anybody's.
void say_takeover(const sweep::Store& store);

/// The diagram of a study over one axis, kept in `file` while it is computed. Throws `Error` (interrupted) likewise.
std::vector<sweep::DiagramCell> compute_diagram(const sweep::SweepResult& result, const std::filesystem::path& file,
                                                int threads);

}  // namespace stridor::app
