#pragma once

#include "stridor/sweep/cell.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

/// Lines between the categories of a chart.
///
/// The verdict is known at the cells only. So a boundary lies between two neighbours that differ, and is drawn across
/// the middle of their connection. Within each square of four neighbouring cells the crossings of one pair of verdicts
/// are joined (marching squares); where three or four verdicts meet in a square, their lines meet in its middle. Where
/// two areas touch across a square's diagonals, one of them is taken to hold together: the one whose verdict comes
/// later in the order none, squeal, squeak, creak, undecided, then without a category, then locks. Slides and sticks
/// are both `none`, and no boundary passes between them.
namespace stridor::sweep {

/// The neighbours between which a boundary passes.
enum class Crossing {
    along_x,  // a cell and the next one in x
    along_y,  // a cell and the next one in y
    amid,     // three or four cells around it
};

/// A point of a boundary, and its uncertainty: the distance to the farther of the two cells that it separates; in the
/// other direction, half way to the next cells. On a linear axis that is half the distance of neighbouring cells.
struct BoundaryVertex {
    double x = 0.0;             // in the unit of the axis' field
    double y = 0.0;             // in the unit of the other axis' field
    double x_resolution = 0.0;  // in the unit of x, above zero
    double y_resolution = 0.0;  // in the unit of y, above zero
    Crossing crossing = Crossing::amid;
};

/// Whether a line returns to its beginning.
enum class LineForm {
    open,    // ends at the chart's edge, or where three verdicts meet
    closed,  // its last vertex is joined to its first one, which is not repeated
};

inline constexpr std::array<std::string_view, 2> line_form_names{"open", "closed"};

/// One line between two verdicts.
struct Boundary {
    std::size_t direction = 0;  // into study.directions
    std::string_view first;     // verdict on one side, of `verdict_words`
    std::string_view second;    // on the other; the two stand in the order above
    LineForm form = LineForm::open;
    std::vector<BoundaryVertex> vertices;
};

/// Returns all boundaries of a sweep: by direction, then by pair of verdicts, then by where they begin, open ones
/// first.
std::vector<Boundary> boundaries(const SweepResult& result);

}  // namespace stridor::sweep
