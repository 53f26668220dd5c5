#pragma once

#include "stridor/drawing/scene.hpp"

#include <cstddef>
#include <vector>

/// Reduces data without a visible change: a picture has limited resolution, a simulation may be long.
namespace stridor::drawing {

/// Returns a line with at most four points for each stay in a pixel column: the first, the last, the lowest and the
/// highest, in their order. Extremes survive exactly, so an impact of one sample is still seen. `columns` divide the
/// axis' range evenly in its own scale; a NaN stays as one NaN.
Line reduced(const Line& line, const PanelAxis& x, std::size_t columns);

/// A stretch of time in one row of a strip, with the share of it spent in the row's state.
struct Shade {
    Extent x;
    std::size_t row = 0;
    double share = 1.0;  // [1] above 0, in steps of 1/8
};

/// Returns the shades of a strip, equal neighbours joined; columns in which a row's state never occurs have none.
std::vector<Shade> shades(const Strip& strip, const Extent& x, std::size_t columns);

/// Neighbouring cells of one row that look the same.
struct CellRun {
    Box box;
    std::size_t kind = 0;
};

/// Returns the joined cells of each row that are of one kind; rows from the lowest, each from its left end. Empty
/// edges: none.
std::vector<CellRun> cell_runs(const std::vector<double>& x_edges, const std::vector<double>& y_edges,
                               const std::vector<std::uint16_t>& kinds);

}  // namespace stridor::drawing
