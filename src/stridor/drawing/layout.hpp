#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/drawing/ticks.hpp"

#include <optional>
#include <vector>

namespace stridor::drawing {

/// A rectangle on paper, counted from the scene's lower left corner [mm].
struct Rectangle {
    double left = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    double top = 0.0;
};

/// Returns the width of an area, in its unit.
inline double width_of(const Rectangle& area) {
    return area.right - area.left;
}

/// Returns the height of an area, in its unit.
inline double height_of(const Rectangle& area) {
    return area.top - area.bottom;
}

/// Says whether two areas have a part in common.
inline bool touch(const Rectangle& a, const Rectangle& b) {
    return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

/// A line of text on paper; the point is the middle of its height.
struct PlacedText {
    StyledText text;
    double x = 0.0;  // [mm]
    double y = 0.0;  // [mm]
    Align align = Align::left;
    double size = 8.0;  // [pt]
    Colour colour;
    /// A quarter turn reads from below to above.
    enum class Turn { none, quarter } turn = Turn::none;
};

/// A note of a panel, placed on paper.
struct PlacedNote {
    std::size_t layer = 0;  // of the panel, that it belongs to
    PlacedText text;
    std::optional<Colour> ground;  // of a patch under the letters
};

/// One panel on paper, with the ticks of its axes.
struct PlacedPanel {
    Rectangle area;  // inside the axis lines
    TickSet x;
    TickSet y;
    std::vector<PlacedNote> notes{};  // in the order of their layers
};

/// A sample of the legend; its text is among the layout's texts.
struct PlacedSample {
    Rectangle area;
    std::variant<Fill, Stroke, Points> sample;
};

/// The places of all parts of a scene on paper.
struct Layout {
    double height = 0.0;                    // [mm] of the sheet: the scene's, or more
    std::vector<PlacedPanel> panels;        // as in the scene
    std::optional<PlacedPanel> colour_bar;  // its y ticks stand on the right
    std::vector<PlacedText> texts;          // titles, caption, numbers and titles of the axes, legend
    std::vector<PlacedSample> samples;
};

/// Returns a scene's layout: panels of one column share their left and right ends, panels of one row their upper and
/// lower ends, whatever numbers stand beside them. A pure function of the scene.
///
/// A text that is too long for its place is broken into lines, and the sheet grows if they would leave less than two
/// fifths of it to the panels. If labels of ticks would touch, every second, third, ... tick keeps its label. Labels of
/// an axis with ticks of its own are cut if they would take more than a third of the sheet, or half of the axis.
Layout arrange(const Scene& scene);

}  // namespace stridor::drawing
