#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <stop_token>
#include <vector>

namespace stridor::sweep {

/// Computes the cells of one grid point, in the order of `study.directions`; none at all if it was stopped.
///
/// A constant drive is run once per direction, any other once, with its going and coming phases as the cells. What goes
/// wrong with the physics or the numbers becomes the cell's status; only what concerns every cell throws `Error`.
/// `workspace` serves one thread from point to point.
std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop,
                           integration::Workspace& workspace);
std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop = {});

}  // namespace stridor::sweep
