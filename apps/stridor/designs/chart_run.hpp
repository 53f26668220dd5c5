#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/diagram.hpp"
#include "stridor/sweep/study.hpp"

#include <filesystem>
#include <vector>

namespace stridor::app {

/// Computes a study in its store, with progress on stderr, or goes on with it; all cells when it returns.
///
/// Throws `Error` (interrupted) after SIGINT or SIGTERM, saying how to go on, and what the store throws.
sweep::SweepResult compute(const sweep::Study& study, const std::filesystem::path& store_file, int threads);

/// The diagram of a study over one axis, kept in `file` while it is computed. Throws `Error` (interrupted) likewise.
std::vector<sweep::DiagramCell> compute_diagram(const sweep::SweepResult& result, const std::filesystem::path& file,
                                                int threads);

}  // namespace stridor::app
