#pragma once

#include "stridor/drawing/layout.hpp"

#include <vector>

/// Labels that stand in a row: how many fit, and where they must give way.
namespace stridor::drawing {

/// Cuts a text to a width [mm], with dots where it was cut; `size` in pt.
StyledText fitted(const StyledText& text, double size, double width);

/// Pushes places apart until none is nearer to the next than `least`, as little as that takes; rising.
std::vector<double> spread(std::vector<double> places, double least);

/// Leaves every second, third, ... label so that all lie `least` apart from end to end. `ends` [mm] are what each takes
/// of the axis, rising; returns the numbers of those that stay.
std::vector<std::size_t> thinned(const std::vector<Extent>& ends, double least);

/// Places the notes of a panel and the names of its regions; `size` [pt] is that of notes without their own.
std::vector<PlacedNote> placed_notes(const Panel& panel, const Rectangle& area, double size);

/// What each text of a layout takes of the sheet [mm], notes of panels included.
std::vector<Rectangle> text_areas(const Layout& layout);

/// Is every text on the sheet, and does none touch another?
bool is_legible(const Layout& layout, double width);

/// Names written into the regions of a category map, so that it can be read without colours.
///
/// A region is a set of cells of one kind that touch by their sides. A name stands where its region has most room
/// around it, and is left out where the region is too small; kinds without a name have an empty text. `area` is where
/// the panel stands on paper, `size` the letters' [pt]. A name stands on no large mark of the panel's points.
std::vector<Note> region_names(const CategoryCells& cells, const std::vector<StyledText>& names, const Panel& panel,
                               const Rectangle& area, double size);

}  // namespace stridor::drawing
