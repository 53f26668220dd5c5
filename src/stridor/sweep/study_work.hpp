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

/// Computes one task; returns `std::nullopt` if it was stopped. Several threads call it at once, each with its own
/// workspace.
using Simulating = std::function<std::optional<std::string>(const crew::Task& task, const std::stop_token& stop,
                                                            integration::Workspace& workspace)>;

/// Returns a work of this text (`crew::Work`). The references of `compute` must outlive the crew.
crew::Work simulating_work(std::string text, Simulating compute);

/// The runs that were not given to anybody yet, in index order: a store is filled ten times as fast in that order.
///
/// It needs two bits for each run that could be on it.
class Agenda {
public:
    /// Begins empty, for runs whose index is below `bound`.
    explicit Agenda(std::size_t bound) : waiting_(bound), was_added_(bound) {}

    /// Adds a run, unless it was added before.
    void add(std::size_t run);

    /// Removes and returns the `most` runs with the lowest indices, or all that are left.
    std::vector<std::size_t> next(std::size_t most);

    /// Returns the number of runs that are left.
    std::size_t left() const { return left_; }

private:
    std::vector<bool> waiting_;
    std::vector<bool> was_added_;
    std::size_t left_ = 0;
    std::size_t cursor_ = 0;  // none below it waits
};

/// Returns the work of a study: a task is a run by the index of its first cell, and its result is the cells that it
/// gives (`evaluate_run`). The study must outlive the crew.
crew::Work work_of(const Study& study);

/// Returns cells as bytes.
std::string packed(std::span<const Cell> cells);

/// Returns the cells in these bytes, bit for bit. Throws `Error` (io) if the bytes are not those of cells.
std::vector<Cell> unpacked_cells(std::string_view bytes);

}  // namespace stridor::sweep
