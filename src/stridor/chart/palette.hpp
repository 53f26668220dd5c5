#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/classification/category.hpp"
#include "stridor/model/contact_state.hpp"

#include <string>

/// The one place of colours.
///
/// Categories keep a CIEDE2000 distance of 21 for normal, protanopic, deuteranopic and tritanopic eyes and 18.5 L* in
/// grey; contact states keep 30 among themselves and 14.5 from every category, so that a reader never takes a state for
/// a verdict. Colour is never alone: every category but `none` has its own texture.
namespace stridor::chart {

inline constexpr Colour white{255, 255, 255};
inline constexpr Colour ink{0x22, 0x22, 0x22};        // text and axes
inline constexpr Colour quiet_ink{0x66, 0x66, 0x66};  // captions
inline constexpr Colour grid_ink{0xE2, 0xE2, 0xE2};   // grid lines
inline constexpr Colour accent{0x00, 0x66, 0x99};     // the curve of a panel with one curve
inline constexpr Colour highlight{0xF3, 0xF0, 0xE6};  // the ground under a stretch that is looked at closely

/// Fill of a category; `undecided` is white with dots, for it is no verdict.
Fill category_fill(classification::Category category);

/// Fill of a contact that is quiet because it sticks: the second, darker shade of `none`.
Fill stuck_fill();

/// Fill of a cell that has no result: white and crossed, never the colour of a category.
Fill failed_fill();

Colour state_colour(model::ContactState state);

/// The sequential map (viridis) at a share from 0 to 1; beyond that its ends.
Colour sequential(double share);

/// A colour mixed with white; share 1 is the colour itself.
Colour tint(Colour colour, double share);

/// CIE 1976 lightness L* (D65) of a colour, 0 black to 100 white: what is left of it in a grey print.
double lightness(Colour colour);

/// The text colour that can be read on a ground: `ink` or white.
Colour text_colour_on(Colour ground);

/// "#RRGGBB"
std::string hex(Colour colour);

}  // namespace stridor::chart
