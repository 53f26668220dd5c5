#pragma once

#include "stridor/drawing/layout.hpp"

#include <vector>

/// Labels in a row: how many fit, and where they must move.
namespace stridor::drawing {

/// Returns a text cut to a width [mm], with dots at the cut; `size` in pt.
StyledText fitted(const StyledText& text, double size, double width);

/// Returns places moved apart, as little as needed, until neighbours are at least `least` apart; rising.
std::vector<double> spread(std::vector<double> places, double least);

/// Returns the numbers of the labels to keep: every second, third, ... so that all are at least `least` apart from end
/// to end. `ends` [mm] are the extents of the labels along the axis, rising.
std::vector<std::size_t> thinned(const std::vector<Extent>& ends, double least);

/// Returns the placed notes of a panel and the names of its regions; `size` [pt] is that of notes without their own.
std::vector<PlacedNote> placed_notes(const Panel& panel, const Rectangle& area, double size);

/// Returns the area of each text of a layout on the sheet [mm], notes of panels included.
std::vector<Rectangle> text_areas(const Layout& layout);

/// Says whether every text is on the sheet and none touches another.
bool is_legible(const Layout& layout, double width);

/// Returns the names of the regions of a category map as notes, so that it can be read without colours.
///
/// A region is a set of cells of one kind that touch by their sides. Its name stands where the region has most room,
/// and is left out if the region is too small; a kind without a name has an empty text. `area` is the panel on paper,
/// `size` the letters' [pt]. A name covers no large mark of the panel's points.
std::vector<Note> region_names(const CategoryCells& cells, const std::vector<StyledText>& names, const Panel& panel,
                               const Rectangle& area, double size);

}  // namespace stridor::drawing
