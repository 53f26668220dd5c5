#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::sweep {

using parameters::Scale;
using parameters::scale_names;

/// Most points of an axis: more are a typing error.
inline constexpr int most_points = 65536;

/// Most cells of a study: a sweep counts them in 32 bits.
inline constexpr std::size_t most_cells = 4'000'000'000;

/// One axis of a chart: a quantity of the case and the values it takes, rising, both ends included.
struct Axis {
    std::string parameter;  // "contact.preload" of all joints, "joint.lip2.contact.preload" of one (`case_key.hpp`)
    double from = 0.0;      // in the field's unit (SI, angles in deg)
    double to = 1.0;
    int points = 2;  // [1] from 2 to `most_points`; 1: a resting axis
    Scale scale = Scale::linear;
};

/// Coarsest base grid of a refined chart: every 2^6 = 64th point.
inline constexpr int most_refinement = 6;

/// Returns value number `index` of an axis, 0 <= index < points, with the same bits on every machine and exact ends.
double value_at(const Axis& axis, int index);

/// A chart to be computed: a case, two of its quantities as axes, and the directions to look at. With one axis only, y
/// rests at one value (`resting_axis`).
///
/// A constant drive is run once per direction, with V = +-|velocity|. Other drives give both directions in one run.
struct Study {
    parameters::Case base;
    Axis x;
    Axis y;
    std::vector<parameters::Direction> directions{parameters::Direction::going, parameters::Direction::coming};
    std::vector<std::string> quantities{"category"};  // what to draw: "category" or names of `cell_figures`
    int refine = 0;  // [1] halvings from the base grid to the chart's; 0: every cell is computed
    std::vector<parameters::Initial> starts;  // each cell is run from all of them; empty: from the case's own
};

/// Returns the y axis of a study over x alone: one point, a quantity other than x at the case's own value.
Axis resting_axis(const parameters::Case& c, const Axis& x);

/// Says whether x alone varies.
bool has_one_axis(const Study& study);

/// Returns the base case's own value of an axis' quantity, with several joints that of the first. For the velocity of a
/// constant drive it is the magnitude, since the directions give its sign.
double own_value(const Study& study, const Axis& axis);

/// Says whether the base case's own values lie within both axes. If joints differ in one of them, there is no single
/// place.
bool holds_design(const Study& study);

/// Returns the number of cells: x.points * y.points * directions.
std::size_t cell_count(const Study& study);

/// Returns the number of directions whose cells one run gives: one with a constant drive, else all of the study.
std::size_t directions_per_run(const Study& study);

/// Returns the run that gives a cell, by the index of its first cell: the same place in the first direction that the
/// run gives.
std::size_t run_of(const Study& study, std::size_t index);

/// The place of a cell: index = (direction * y.points + iy) * x.points + ix.
struct CellPlace {
    std::size_t direction = 0;  // into study.directions
    int iy = 0;
    int ix = 0;
    std::size_t start = 0;  // into study.starts, if it has any; no part of the index
};

/// Returns the place of a cell by its index, below `cell_count`; its start is 0.
CellPlace place_of(const Study& study, std::size_t index);

/// Returns the index of a place.
std::size_t index_of(const Study& study, const CellPlace& place);

/// Returns the case of one cell: the base case with the axes' values, the direction and the start set.
parameters::Case case_at(const Study& study, const CellPlace& place);

/// Throws `Error` (input) for an axis that is not a quantity of this case, has an end outside its range, does not rise,
/// has too few or too many points or a logarithm of something not positive; for more than `most_cells` cells; for two
/// equal axes, no direction, the same direction or start twice, an unknown quantity to draw, a refinement beyond
/// `most_refinement`; and for a fault of the case in every cell, whatever the axes say.
void check(const Study& study);

/// Returns a quick form of a study: at most 64 by 64 points, refined; with a constant drive a quarter of the simulated
/// time, judged by its later half; with a sinusoidal one the first two periods. Cells near boundaries, whose motion
/// settles late or is irregular, may get another verdict.
Study preview(Study study);

/// Returns all that decides the results, as lines of "key = value": the canonical case without the two quantities that
/// the axes set, then the axes and the directions, and the refinement and the starts if there are any. A store belongs
/// to exactly one such text. The text holds neither the title nor the quantities to draw, nor the sign of a constant
/// drive's velocity: the directions give it.
std::string canonical_text(const Study& study);

/// Returns the command that runs one cell alone: "stridor simulate FILE --set contact.preload=20 ...". The result has
/// the same bits, since the numbers read back as the same.
std::string reproduce_command(const Study& study, const CellPlace& place, const std::string& file);

}  // namespace stridor::sweep
