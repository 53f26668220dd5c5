#pragma once

#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/scene.hpp"

#include <span>
#include <string>
#include <vector>

/// The colours of paper, ink and numbers. Those of categories and contact states stand in
/// pictures/parts/category_colours.
namespace stridor::drawing {

inline constexpr Colour white{255, 255, 255};
inline constexpr Colour ink{0x22, 0x22, 0x22};        // text and axes
inline constexpr Colour quiet_ink{0x66, 0x66, 0x66};  // captions
inline constexpr Colour grid_ink{0xE2, 0xE2, 0xE2};   // grid lines
inline constexpr Colour accent{0x00, 0x66, 0x99};     // the curve of a panel with one curve
inline constexpr Colour highlight{0xF3, 0xF0, 0xE6};  // the ground under a stretch that is looked at closely

/// Returns the sequential map (viridis) at equal distances, first and last stop included.
std::span<const Colour> sequential_stops();

/// Returns the colour of the sequential map at a share from 0 to 1; beyond that its ends.
Colour sequential(double share);

/// Returns a colour mixed with white; share 1 is the colour itself.
Colour tint(Colour colour, double share);

/// Returns the CIE 1976 lightness L* (D65) of a colour, 0 black to 100 white, which a grey print keeps.
double lightness(Colour colour);

/// Returns the readable text colour on a ground: `ink` or white.
Colour text_colour_on(Colour ground);

/// Returns "#RRGGBB"
std::string hex(Colour colour);

/// A straight line on paper [mm].
struct Segment {
    double x0 = 0.0;
    double y0 = 0.0;
    double x1 = 0.0;
    double y1 = 0.0;
};

/// A dot on paper [mm].
struct Dot {
    double x = 0.0;
    double y = 0.0;
};

/// The strokes of a texture.
struct Pattern {
    std::vector<Segment> lines;
    std::vector<Dot> dots;
};

/// Returns the texture over an area of rectangles that do not overlap. Its lines and dots have their place on the
/// paper, not in a rectangle: they continue from one rectangle into the next. `spacing` is the distance between lines
/// [mm].
Pattern pattern(Texture texture, std::span<const Rectangle> area, double spacing = 1.3);

}  // namespace stridor::drawing
