#pragma once

#include "stridor/drawing/layout.hpp"

#include <span>
#include <vector>

namespace stridor::drawing {

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

/// The texture over an area made of rectangles that do not overlap. Its lines and dots have their place on the paper,
/// not in a rectangle: they run on from one rectangle into the next. `spacing` is the distance between lines [mm].
Pattern pattern(Texture texture, std::span<const Rectangle> area, double spacing = 1.3);

}  // namespace stridor::drawing
