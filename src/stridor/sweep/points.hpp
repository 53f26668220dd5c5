#pragma once

#include "stridor/crew/crew.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

/// Cells away from the grid of a chart: designs of experiments, samples of scattering parameters.
namespace stridor::sweep {

/// A case and what changes from point to point: quantities, and which of several base cases they change. So a word may
/// change, too: each word has a base case.
struct DesignPoints {
    std::vector<parameters::Case> bases;  // one at least
    std::vector<std::string> keys;        // of quantities, in any spelling of `parameters::key_called`
    std::vector<double> values;           // in their units, shape [point][key]
    std::vector<parameters::Direction> directions{parameters::Direction::going, parameters::Direction::coming};
    std::vector<std::size_t> base_of{};         // [1] of each point, into `bases`; empty: the first one of all
    std::vector<parameters::Initial> starts{};  // each cell is run from all of them; empty: from its base's own
};

/// Returns the number of points.
std::size_t point_count(const DesignPoints& points);

/// How they are computed.
struct PointOptions {
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    std::function<void(std::size_t done)> progress{};  // runs done; from the caller's thread, ten times a second
};

/// Returns the number of runs that give all cells: one per point, with a constant drive one per point and direction.
/// The runs from all starts count as one.
std::size_t run_count(const DesignPoints& points);

/// Throws `Error` (input) for a name that is not a quantity of any base, two names of one quantity, a value out of its
/// field's range (with the number of its point), no direction, the same direction or start twice.
void check(const DesignPoints& points);

/// Returns the cells of all points: those of a chart with the same starts, had its axes these values. Shape
/// [direction][point].
///
/// A quantity changes only the points whose base has it. A constant drive moves with V = +-|velocity|, as in charts.
/// The bits do not depend on the crew. A fault of the physics, the numbers or contradictory values becomes the cell's
/// status. Throws what `check` does, and `Error` (interrupted) when stopped.
std::vector<Cell> evaluate(const DesignPoints& points, const PointOptions& options = {});

}  // namespace stridor::sweep
