#pragma once

#include "stridor/drawing/layout.hpp"

namespace stridor::drawing {

inline constexpr double sheet_margin = 1.5;  // [mm] around everything

/// Lengths that follow from the size of the letters [mm].
struct Measures {
    double em = 0.0;
    double line = 0.0;     // from one line of text to the next
    double to_tick = 0.0;  // from an axis line to its numbers
};

/// Returns the measures for letters of `font_size` [pt].
Measures measures(double font_size);

/// Places the legend at the foot of the sheet: entries side by side, in as many rows as they need. Returns the lower
/// end of the room for panels [mm].
double place_legend(const Scene& scene, Layout& layout);

}  // namespace stridor::drawing
