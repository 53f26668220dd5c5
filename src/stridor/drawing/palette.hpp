#pragma once

#include "stridor/drawing/scene.hpp"

#include <span>
#include <string>

/// The colours of paper, ink and numbers. Those of categories and contact states stand in
/// pictures/parts/category_colours.
namespace stridor::drawing {

inline constexpr Colour white{255, 255, 255};
inline constexpr Colour ink{0x22, 0x22, 0x22};        // text and axes
inline constexpr Colour quiet_ink{0x66, 0x66, 0x66};  // captions
inline constexpr Colour grid_ink{0xE2, 0xE2, 0xE2};   // grid lines
inline constexpr Colour accent{0x00, 0x66, 0x99};     // the curve of a panel with one curve
inline constexpr Colour highlight{0xF3, 0xF0, 0xE6};  // the ground under a stretch that is looked at closely

/// The sequential map (viridis) at equal distances, first and last stop included.
std::span<const Colour> sequential_stops();

/// The sequential map at a share from 0 to 1; beyond that its ends.
Colour sequential(double share);

/// A colour mixed with white; share 1 is the colour itself.
Colour tint(Colour colour, double share);

/// CIE 1976 lightness L* (D65) of a colour, 0 black to 100 white: what is left of it in a grey print.
double lightness(Colour colour);

/// The text colour that can be read on a ground: `ink` or white.
Colour text_colour_on(Colour ground);

/// "#RRGGBB"
std::string hex(Colour colour);

}  // namespace stridor::drawing
