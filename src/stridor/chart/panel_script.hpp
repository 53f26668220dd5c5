#pragma once

#include "stridor/chart/layout.hpp"

#include <string>

namespace stridor::chart {

inline constexpr double texture_width = 0.45;  // [pt] of the lines of a texture

enum class TickSide { left, right };

/// What one panel's part of a script needs besides the panel.
struct PanelContext {
    std::string decorations;  // commands for what stands around it on the paper
    TickSide y_ticks = TickSide::left;
};

/// The commands that draw one panel of a scene.
std::string panel_script(const Scene& scene, const Panel& panel, const PlacedPanel& placed,
                         const PanelContext& context);

/// Room that a note takes [mm], a little air included.
struct Extent {
    double width = 0.0;
    double height = 0.0;
};
Extent note_extent(const Text& text, double size);

/// The diameter of the ring around points that have one [pt].
double rim_diameter(const Points& points);

inline constexpr double outline_width = 0.9;  // [pt] added to a point's diameter by its outline

/// "pt ... ps ... lc rgb '#...'": the mark of points in a colour, so much wider [pt].
std::string point_style(const Points& points, Colour colour, double wider);

/// "lc rgb '#...' lw ... dt ..."
std::string line_style(const Stroke& stroke);

}  // namespace stridor::chart
