#pragma once

#include "stridor/drawing/layout.hpp"

#include <vector>

namespace stridor::drawing {

/// Names written into the regions of a category map, so that it can be read without colours.
///
/// A region is a set of cells of one kind that touch by their sides. A name stands where its region has most room
/// around it, and is left out where the region is too small; kinds without a name have an empty text. `area` is where
/// the panel stands on paper, `size` the letters' [pt]. A name stands on no large mark of the panel's points.
std::vector<Note> region_names(const CategoryCells& cells, const std::vector<StyledText>& names, const Panel& panel,
                               const Rectangle& area, double size);

}  // namespace stridor::drawing
