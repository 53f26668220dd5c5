#pragma once

#include "stridor/sweep/cell.hpp"

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

/// Lines between the categories of a chart.
///
/// The verdict is known at the cells' values only, so a boundary is known to lie between two neighbours that differ,
/// and is taken to cross their connection in the middle. Within each square of four neighbouring cells the crossings of
/// one pair of verdicts are joined (marching squares); where three or four verdicts meet in a square, their lines meet
/// in its middle. Where two areas touch across a square's diagonals, the one whose verdict comes later in the order
/// none, squeal, squeak, creak, undecided, then without a category, then locks, is taken to hold together. Slides and
/// sticks are both `none`, and no boundary passes between them.
namespace stridor::sweep {

/// Between which neighbours a boundary passes.
enum class Crossing {
    along_x,  // a cell and the next one in x
    along_y,  // a cell and the next one in y
    amid,     // three or four cells around it
};

/// A point of a boundary, and how far off it may lie: the distance to the farther of the two cells that it parts, and
/// across to half way to the next ones. On a linear axis that is half the distance of neighbouring cells.
struct BoundaryVertex {
    double x = 0.0;             // in the unit of the axis' field
    double y = 0.0;             // likewise
    double x_resolution = 0.0;  // likewise, above zero
    double y_resolution = 0.0;  // likewise, above zero
    Crossing crossing = Crossing::amid;
};

/// Does a line return to its beginning?
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

/// All boundaries of a sweep: by direction, then by pair of verdicts, then by where they begin, open ones first.
std::vector<Boundary> boundaries(const SweepResult& result);

}  // namespace stridor::sweep
