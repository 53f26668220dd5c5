#pragma once

#include "stridor/drawing/text.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// A scene describes the content of a picture, in data units. It knows neither the origin of the data nor the drawer.
///
/// A picture is one function that builds a scene. Panels stand in a grid of rows and columns; their layers are drawn in
/// order, later ones over earlier ones. Lengths on paper are in mm, text sizes and line widths in pt.
namespace stridor::drawing {

inline constexpr double millimetres_per_point = 25.4 / 72.0;

/// A colour in sRGB, eight bits each.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    bool operator==(const Colour&) const = default;
};

/// A pattern over a fill: the second channel beside colour, so that a picture can be read in grey.
enum class Texture { none, dots, rising, falling, crossed };

/// How an area is filled. A texture is drawn in `ink` over the colour.
struct Fill {
    Colour colour{255, 255, 255};
    Texture texture = Texture::none;
    Colour ink;
    bool operator==(const Fill&) const = default;
};

/// The pattern of a line.
enum class Dash { solid, dashed, dotted };

/// How a line is drawn.
struct Stroke {
    Colour colour;
    double width = 0.8;  // [pt]
    Dash dash = Dash::solid;
};

/// An interval of an axis, in its data units.
struct Extent {
    double from = 0.0;
    double to = 1.0;
    bool operator==(const Extent&) const = default;
};

/// How values lie along an axis.
enum class AxisScale { linear, logarithmic };

/// Ticks of the major size carry the labels.
enum class TickSize { major, minor };

/// A mark on an axis at a value in data units.
struct Tick {
    double value = 0.0;
    StyledText label;
    TickSize size = TickSize::major;
};

/// Whether an axis' numbers and title stand beside it, or a neighbour panel carries them.
enum class AxisText { shown, hidden };

/// One axis of a panel: its quantity and its range.
struct PanelAxis {
    StyledText label;  // "preload F", without its unit
    std::string unit;  // as in the field table: "m/s^2", "1"
    AxisScale scale = AxisScale::linear;
    Extent range;
    std::vector<Tick> ticks;  // empty: chosen by the range and the axis' length
    AxisText text = AxisText::shown;
};

/// A line through points; a NaN interrupts it. It may have as many points as a simulation has steps: it is reduced to
/// the extremes of each pixel column when drawn.
struct Line {
    std::vector<double> x;  // shape [point]
    std::vector<double> y;  // shape [point]
    Stroke stroke;
};

/// The shape of a point: a second channel beside its colour.
enum class Mark { disc, square, triangle, diamond, nabla, cross };

/// Points, without a line.
struct Points {
    std::vector<double> x;  // shape [point]
    std::vector<double> y;  // shape [point]
    Colour colour;
    double diameter = 2.0;      // [pt]
    std::optional<Colour> rim;  // of a ring around each, half as thick as the disc, that shows it on any ground
    Mark mark = Mark::disc;
    std::optional<Colour> outline{};  // a thin line around each
    std::size_t columns = 0;          // of a map whose cells hold the points: each stays within a third of its cell
    std::size_t rows = 0;
};

/// States over time, one row per state: row r fills y from r + 0.1 to r + 0.9.
///
/// If intervals are shorter than a pixel column, the shade shows the share of time spent in the state. Even the
/// shortest interval stays visible.
struct Strip {
    /// A stay in one state, in units of x.
    struct Interval {
        double from = 0.0;
        double to = 0.0;
        std::size_t row = 0;
    };
    std::vector<Interval> intervals;
    std::vector<Colour> rows;  // shape [row]
};

/// An axis-parallel rectangle in data units.
struct Box {
    Extent x;
    Extent y;
};

/// Filled rectangles.
struct Boxes {
    std::vector<Box> boxes;
    Fill fill;
};

/// Cells of a map with one kind each out of a list of fills.
struct CategoryCells {
    std::vector<double> x_edges;       // rising, shape [column + 1]
    std::vector<double> y_edges;       // rising, shape [row + 1]
    std::vector<std::uint16_t> kinds;  // index into fills, shape [row][column]
    std::vector<Fill> fills;
};

/// A quantity's colours: the sequential map stretched over a range; values beyond it take the end's colour.
struct ColourScale {
    Extent range;
    AxisScale scale = AxisScale::linear;
};

/// Cells of a map with one value each; a cell without a number is filled with `missing`.
struct ValueCells {
    std::vector<double> x_edges;  // rising, shape [column + 1]
    std::vector<double> y_edges;  // rising, shape [row + 1]
    std::vector<double> values;   // shape [row][column]
    ColourScale colours;
    Fill missing;
};

/// The reference of a note's position: data units, or shares of the panel from its lower left corner.
enum class Anchor { data, panel };

/// The end of a text at its position.
enum class Align { left, centre, right };

/// A piece of text in a panel, over all other layers.
struct Note {
    StyledText text;
    double x = 0.0;
    double y = 0.0;
    Anchor anchor = Anchor::data;
    Align align = Align::left;
    Colour colour;
    double size = 0.0;             // [pt] 0: the scene's
    std::optional<Colour> ground;  // of a patch under the letters, to keep textures away from them
};

/// Names written into the regions of the category cells before it, where they have room (`region_names`).
struct RegionNames {
    std::vector<StyledText> names;  // shape [fill]; an empty one is not written
};

/// The direction of a line across a panel.
enum class Orientation { vertical, horizontal };

/// A straight line across the whole panel at one value.
struct Rule {
    double value = 0.0;
    Orientation orientation = Orientation::vertical;
    Stroke stroke;
};

using Layer = std::variant<Line, Points, Strip, Boxes, CategoryCells, ValueCells, Note, RegionNames, Rule>;

/// The lines around a panel: two axis lines for curves, a closed frame for maps and strips.
enum class Frame { open, closed };

/// The faint lines from the ticks across a panel.
enum class Grid { none, vertical, both };

/// One plot, at its place among the others.
struct Panel {
    StyledText title;
    std::size_t row = 0;     // from the top
    std::size_t column = 0;  // from the left
    PanelAxis x;
    PanelAxis y;
    Frame frame = Frame::open;
    Grid grid = Grid::none;
    std::vector<Layer> layers;
};

/// One entry of the legend below the panels.
struct LegendEntry {
    StyledText text;
    std::variant<Fill, Stroke, Points> sample;  // of points one is shown, wherever they stand
};

/// The scale of a quantity's colours, right of all panels or of one row of them.
struct ColourBar {
    StyledText label;
    std::string unit;
    ColourScale colours;
    std::optional<std::size_t> row{};  // beside this row of panels only
};

/// Whether a title stands above the panels, or only among the facts of the file.
enum class TitleText { printed, left_out };

/// A whole picture.
struct Scene {
    StyledText title;
    TitleText title_text = TitleText::printed;
    std::vector<StyledText> caption;         // paragraphs below the title, each wrapped to the width
    double width = 170.0;                    // [mm] the text width of a two-column paper
    double height = 100.0;                   // [mm] more where texts of many lines would leave panels too low
    double font_size = 8.0;                  // [pt]
    std::vector<double> column_widths{1.0};  // relative, shape [column]
    std::vector<double> row_heights{1.0};    // relative, shape [row]
    std::vector<Panel> panels;
    std::vector<LegendEntry> legend;
    std::optional<ColourBar> colour_bar;
};

}  // namespace stridor::drawing
