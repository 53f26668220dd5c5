#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/strokes.hpp"

namespace stridor::pictures {

/// Draws a history of strokes: temperature and preload with which each begins over its number, a row for each that
/// changes and a column per direction. The mark of a computed stroke has the colour of its verdict.
drawing::Scene strokes(const sweep::StrokeHistory& history);

}  // namespace stridor::pictures
