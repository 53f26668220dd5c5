#pragma once

#include "stridor/crew/thread_crew.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Cells anywhere, and not on the grid of a chart: designs of experiments, samples of scattering parameters.
namespace stridor::sweep {

/// A case and what of it changes from point to point: quantities, and which of several cases it is that they change.
/// So a word may change, too: there is a case for each.
struct DesignPoints {
    std::vector<parameters::Case> bases;  // one at least
    std::vector<std::string> keys;        // of quantities, in any spelling of `parameters::key_called`
    std::vector<double> values;           // in their units, shape [point][key]
    std::vector<parameters::Direction> directions{parameters::Direction::going, parameters::Direction::coming};
    std::vector<std::size_t> base_of{};         // [1] of each point, into `bases`; empty: the first one of all
    std::vector<parameters::Initial> starts{};  // each cell is run from all of them; empty: from its base's own
};

/// How many points there are.
std::size_t point_count(const DesignPoints& points);

/// How they are computed.
struct PointOptions {
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    std::function<void(std::size_t done)> progress{};  // runs done; from the caller's thread, ten times a second
};

/// How many runs give all cells: one per point, with a constant drive one per point and direction; that from all starts
/// counts as one.
std::size_t run_count(const DesignPoints& points);

/// Throws `Error` (input) for a name that is no quantity of any base, two names of one, a value out of its field's
/// range, with the number of its point, no direction or the same twice, a start twice.
void check(const DesignPoints& points);

/// The cells of all points: what a chart with the same starts has where its axes take these values. Shape
/// [direction][point].
///
/// A quantity changes the points whose base it means something for. A constant drive moves with V = +-|velocity|, as in
/// charts. The same bits for every crew. What goes wrong with the physics, the numbers or values that
/// contradict each other becomes the cell's status. Throws what `check` does, and `Error` (interrupted) when stopped.
std::vector<Cell> evaluate(const DesignPoints& points, const PointOptions& options = {});

}  // namespace stridor::sweep
