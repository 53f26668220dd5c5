#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <stop_token>
#include <vector>

namespace stridor::sweep {

/// Computes the cells that one run gives, `directions_per_run` of them, the first having this index; none at all if it was
/// stopped.
///
/// A constant drive is run once per direction, any other once, with its going and coming phases as the cells; all that
/// once per start of `study.starts`, if it has any, and a cell then shows its loudest start (starts.hpp). What goes
/// wrong with the physics or the numbers becomes the cell's status; only what concerns every cell throws `Error`.
/// `workspace` serves one thread from run to run.
std::vector<Cell> evaluate_run(const Study& study, std::size_t first, const std::stop_token& stop,
                               integration::Workspace& workspace);

/// The same for all cells of one grid point, in the order of `study.directions`.
std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop = {});

}  // namespace stridor::sweep
