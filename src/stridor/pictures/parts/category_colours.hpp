#pragma once

#include "stridor/classification/verdict.hpp"
#include "stridor/drawing/scene.hpp"
#include "stridor/model/contact_state.hpp"

/// The one place of the colours of categories and contact states.
///
/// Categories keep a CIEDE2000 distance of 21 for normal, protanopic, deuteranopic and tritanopic eyes and 18.5 L* in
/// grey; contact states keep 30 among themselves and 14.5 from every category, so that a reader never takes a state for
/// a verdict. Colour is never alone: every category but `none` has its own texture.
namespace stridor::pictures {

/// Returns the fill of a category; `undecided` is white with dots, for it is not a verdict.
drawing::Fill category_fill(classification::Category category);

/// Returns the fill of a contact that is quiet because it sticks: the second, darker shade of `none`.
drawing::Fill stuck_fill();

/// Returns the fill of a contact that locks: darker than the shades of `none` and crossed, for it is not a quiet
/// design.
drawing::Fill locked_fill();

/// Returns the fill of a cell without a result: white and crossed, never the colour of a category.
drawing::Fill failed_fill();

/// Returns the colour of a contact state.
drawing::Colour state_colour(model::ContactState state);

}  // namespace stridor::pictures
