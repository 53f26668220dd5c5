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

/// A case and what of it changes from point to point.
struct DesignPoints {
    parameters::Case base;
    std::vector<std::string> keys;  // of quantities, in any spelling of `parameters::key_called`
    std::vector<double> values;     // in their units, shape [point][key]
    std::vector<parameters::Direction> directions{parameters::Direction::going, parameters::Direction::coming};
};

/// How many points there are.
std::size_t point_count(const DesignPoints& points);

/// How they are computed.
struct PointOptions {
    crew::CrewMaker crew = crew::thread_crews();  // who computes
    std::stop_token stop{};
    std::function<void(std::size_t done)> progress{};  // runs done; from the caller's thread, ten times a second
};

/// How many runs give all cells: one per point, with a constant drive one per point and direction.
std::size_t run_count(const DesignPoints& points);

/// The case of one point in one direction. A constant drive moves with V = +-|velocity|, as in charts.
parameters::Case case_at(const DesignPoints& points, std::size_t point, parameters::Direction direction);

/// Throws `Error` (input) for a name that is no quantity of this case, two names of one, a value out of its field's
/// range, with the number of its point, no direction or the same twice.
void check(const DesignPoints& points);

/// The cells of all points: what a chart has where its axes take these values. Shape [direction][point].
///
/// The same bits for every crew. What goes wrong with the physics, the numbers or values that contradict
/// each other becomes the cell's status. Throws what `check` does, and `Error` (interrupted) when stopped.
std::vector<Cell> evaluate(const DesignPoints& points, const PointOptions& options = {});

}  // namespace stridor::sweep
