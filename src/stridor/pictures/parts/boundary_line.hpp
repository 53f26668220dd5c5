#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <vector>

namespace stridor::pictures {

/// The boundaries of one direction as a line along the edges of the cells (`cell_edges`), NaN between two of them: it
/// runs through their vertices, around the corners of the cells, and on to the frame where a boundary leaves the chart.
drawing::Line boundary_line(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries,
                            std::size_t direction);

}  // namespace stridor::pictures
