#pragma once

#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/page.hpp"

namespace stridor::drawing {

/// Which side of a panel its y ticks stand on.
enum class TickSide { left, right };

/// Draws one panel of a scene: its grid, its layers, its frame with the ticks, and its notes over all of them. The
/// numbers of the ticks and the titles are texts of the layout.
void draw_panel(Page& page, const Panel& panel, const PlacedPanel& placed, TickSide side);

/// Draws a sample of the legend.
void draw_sample(Page& page, const PlacedSample& placed);

}  // namespace stridor::drawing
