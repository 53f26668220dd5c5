#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// The runs of a study as the work of a crew.
namespace stridor::sweep {

// The work of a crew whose tasks are runs of an engine.

/// Computes one task; nothing if it was stopped. Several threads call it at once, each with its own workspace.
using Simulating = std::function<std::optional<std::string>(const crew::Task& task, const std::stop_token& stop,
                                                            integration::Workspace& workspace)>;

/// A work of this text (`crew::Work`). What `compute` refers to must outlive the crew.
crew::Work simulating_work(std::string text, Simulating compute);

/// The runs that nobody was given yet, in index order: a store is filled ten times as fast in that order as in any.
///
/// It needs two bits for each run that could be on it.
class Agenda {
public:
    /// For runs whose index is below `bound`, none of them on it.
    explicit Agenda(std::size_t bound) : waiting_(bound), was_added_(bound) {}

    /// Puts a run on it, unless it was on it before.
    void add(std::size_t run);

    /// Takes so many runs off it, or all that are left, those with the lowest indices.
    std::vector<std::size_t> next(std::size_t most);

    /// Number of runs that are on it.
    std::size_t left() const { return left_; }

private:
    std::vector<bool> waiting_;
    std::vector<bool> was_added_;
    std::size_t left_ = 0;
    std::size_t cursor_ = 0;  // none below it waits
};

/// A task is a run by the index of its first cell, and its result are the cells that it gives (`evaluate_run`). The
/// study must outlive the crew.
crew::Work work_of(const Study& study);

/// Cells as bytes.
std::string packed(std::span<const Cell> cells);

/// Out of bytes, bit for bit. Throws `Error` (io) where they are not those of cells.
std::vector<Cell> unpacked_cells(std::string_view bytes);

}  // namespace stridor::sweep
