#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/sweep/cell.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The runs of a study as the work of a crew.
namespace stridor::sweep {

/// A task is a run by the index of its first cell, and its result are the cells that it gives (`evaluate_run`). The
/// study must outlive the crew.
crew::Work work_of(const Study& study);

/// Cells as bytes.
std::string packed(std::span<const Cell> cells);

/// Out of bytes, bit for bit. Throws `Error` (io) where they are not those of cells.
std::vector<Cell> unpacked_cells(std::string_view bytes);

}  // namespace stridor::sweep
