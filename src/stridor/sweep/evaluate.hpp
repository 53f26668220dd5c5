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

/// Has a case the start that it asks for? Where steady sliding has no equilibrium, since the contact would dig in,
/// nothing begins with it. What else is wrong with a case, its run says.
bool can_begin(const parameters::Case& c);

/// Runs a case; nothing at all if it was stopped.
///
/// What goes wrong with the case, the physics or the numbers is a status; only what concerns every case throws `Error`.
std::optional<Attempt> attempt(const parameters::Case& c, const record::Request& request, std::stop_token stop,
                               integration::Workspace& workspace);

/// What is kept of one direction of a run: its verdict by contact states and its figures.
Cell cell_of(const parameters::Case& c, parameters::Direction direction, const Attempt& attempt);

/// The cells of one run, one of each of these directions; none at all if it was stopped. With `starts` above 0 the case
/// is run from each of them, and a cell shows its worst start (starts.hpp); a start that it does not have
/// (`can_begin`) takes after the first one that it has. `case_of` gives the case of a start; with
/// none it is asked for start 0.
std::vector<Cell> evaluate_starts(std::size_t starts, std::span<const parameters::Direction> directions,
                                  const std::function<parameters::Case(std::size_t start)>& case_of,
                                  const std::stop_token& stop, integration::Workspace& workspace);

/// Computes the cells that one run gives, `directions_per_run` of them, the first having this index; none at all if it
/// was stopped.
///
/// A constant drive is run once per direction, any other once, with its going and coming phases as the cells; all that
/// once per start of `study.starts`, if it has any, and a cell then shows its worst start (starts.hpp). What goes
/// wrong with the physics or the numbers becomes the cell's status; only what concerns every cell throws `Error`.
/// `workspace` serves one thread from run to run.
std::vector<Cell> evaluate_run(const Study& study, std::size_t first, const std::stop_token& stop,
                               integration::Workspace& workspace);

/// The same for all cells of one grid point, in the order of `study.directions`.
std::vector<Cell> evaluate(const Study& study, int ix, int iy, const std::stop_token& stop = {});

}  // namespace stridor::sweep
