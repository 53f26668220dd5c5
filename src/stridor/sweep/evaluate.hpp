#pragma once

#include "stridor/integration/simulate.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace stridor::sweep {

/// One run of a case, and how it ended.
struct Attempt {
    Status status = Status::done;
    std::string message;         // why it is not done
    integration::Motion motion;  // of a done run only
};

/// Says whether a case has the start that it asks for. Steady sliding is no start if it has no equilibrium, since the
/// contact would dig in. Other faults of a case are left to its run.
bool can_begin(const parameters::Case& c);

/// Runs a case; returns `std::nullopt` if it was stopped.
///
/// A fault of the case, the physics or the numbers becomes a status; only an error that concerns every case throws
/// `Error`.
std::optional<Attempt> attempt(const parameters::Case& c, const record::Request& request, std::stop_token stop,
                               integration::Workspace& workspace);

/// Returns the kept result of one direction of a run: its verdict by contact states and its figures.
Cell cell_of(const parameters::Case& c, parameters::Direction direction, const Attempt& attempt);

/// Returns the cells of one run, one of each of these directions; none at all if it was stopped. With `starts` above 0
/// the case is run from each of them, and a cell shows its worst start (starts.hpp). A start that the case does not
/// have (`can_begin`) takes the verdict of the first one that it has. `case_of` returns the case of a start; if
/// `starts` is 0 it is called for start 0.
std::vector<Cell> evaluate_starts(std::size_t starts, std::span<const parameters::Direction> directions,
                                  const std::function<parameters::Case(std::size_t start)>& case_of,
                                  const std::stop_token& stop, integration::Workspace& workspace);

/// Computes the cells that one run gives, `directions_per_run` of them from this index on; none at all if it was
/// stopped.
///
/// A constant drive is run once per direction, any other once, with its going and coming phases as the cells. All that
/// is done once per start of `study.starts`, if it has any, and a cell then shows its worst start (starts.hpp). A fault
/// of the physics or the numbers becomes the cell's status; only an error that concerns every cell throws `Error`.
/// `workspace` serves one thread from run to run.
std::vector<Cell> evaluate_run(const Study& study, std::size_t first, const std::stop_token& stop,
                               integration::Workspace& workspace);

/// Computes all cells of one grid point, in the order of `study.directions`; none at all if it was stopped.
std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop = {});

}  // namespace stridor::sweep
