#include "stridor/pictures/strokes.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/sweep/starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

using sweep::ComputedStroke;
using sweep::StrokeHistory;

constexpr drawing::Colour line_colour{0x88, 0x88, 0x88};
constexpr double stroke_mark_size = 3.0;  // [pt]

// what changes slowly, a row of the picture
struct SlowQuantity {
    std::string_view label;
    std::string_view unit;
    double ComputedStroke::*value;
};

std::vector<SlowQuantity> slow_quantities(const sweep::StrokePlan& plan) {
    std::vector<SlowQuantity> quantities;
    if (plan.heating) quantities.push_back({"temperature", "degC", &ComputedStroke::temperature});
    if (plan.wear) quantities.push_back({"share of the preload", "1", &ComputedStroke::preload_share});
    return quantities;
}

drawing::Extent extent_of(const StrokeHistory& history, double ComputedStroke::*value) {
    const auto [low, high] =
        std::ranges::minmax(history.strokes, {}, [&](const ComputedStroke& stroke) { return stroke.*value; });
    const double span = high.*value - low.*value;
    const double air = span > 0.0 ? 0.08 * span : std::max(1e-3, 0.05 * std::abs(high.*value));
    return {low.*value - air, high.*value + air};
}

void add_strokes(drawing::Panel& panel, const StrokeHistory& history, const SlowQuantity& quantity,
                 std::size_t direction) {
    drawing::Line line{{}, {}, {line_colour, 0.8, drawing::Dash::solid}};
    std::map<std::string_view, drawing::Points> marks;  // by verdict
    for (const ComputedStroke& stroke : history.strokes) {
        const sweep::Cell& cell = stroke.cells[direction];
        line.x.push_back(static_cast<double>(stroke.number));
        line.y.push_back(stroke.*quantity.value);
        if (cell.status != sweep::Status::done) continue;
        drawing::Points& points = marks[sweep::word(cell)];
        points.x.push_back(line.x.back());
        points.y.push_back(line.y.back());
        points.colour = category_fill(cell.category).colour;
        points.diameter = stroke_mark_size;
        points.outline = line_colour;
    }
    panel.layers.emplace_back(std::move(line));
    for (auto& [word, points] : marks)
        panel.layers.emplace_back(std::move(points));
}

// each verdict of the picture once
std::vector<drawing::LegendEntry> legend_of(const StrokeHistory& history) {
    std::map<std::string_view, drawing::Points> words;
    for (const ComputedStroke& stroke : history.strokes)
        for (const sweep::Cell& cell : stroke.cells)
            if (cell.status == sweep::Status::done)
                words[sweep::word(cell)].colour = category_fill(cell.category).colour;
    std::vector<drawing::LegendEntry> legend;
    for (auto& [word, points] : words) {
        points.diameter = stroke_mark_size;
        points.outline = line_colour;
        legend.push_back({drawing::StyledText(std::string(word)), points});
    }
    return legend;
}

}  // namespace

drawing::Scene strokes(const StrokeHistory& history) {
    const std::vector<SlowQuantity> quantities = slow_quantities(history.plan);
    const std::string& title = history.base.title;
    drawing::Scene scene;
    scene.title = "Over strokes" + (title.empty() ? "" : ": " + title);
    scene.caption = {conditions(history.base, std::array<std::string_view, 1>{"temperature.value"}),
                     "Marks: computed strokes, at what each begins with; their colour is the verdict."};
    scene.height = 25.0 + 45.0 * static_cast<double>(quantities.size());
    scene.column_widths.assign(history.directions.size(), 1.0);
    scene.row_heights.assign(quantities.size(), 1.0);
    scene.legend = legend_of(history);
    const double last = static_cast<double>(std::max<std::int64_t>(2, history.strokes.back().number));
    for (std::size_t row = 0; row < quantities.size(); ++row)
        for (std::size_t d = 0; d < history.directions.size(); ++d) {
            drawing::Panel panel;
            panel.grid = drawing::Grid::both;
            panel.row = row;
            panel.column = d;
            if (row + 1 == quantities.size()) panel.x.label = "stroke";
            if (row + 1 < quantities.size()) panel.x.text = drawing::AxisText::hidden;
            panel.x.unit = "1";
            panel.x.range = {1.0, last};
            panel.y.label = std::string(quantities[row].label);
            panel.y.unit = quantities[row].unit;
            panel.y.range = extent_of(history, quantities[row].value);
            if (d > 0) panel.y.text = drawing::AxisText::hidden;
            const auto direction = static_cast<std::size_t>(history.directions[d]);
            if (row == 0) panel.title = lettered(d, drawing::StyledText(parameters::direction_names[direction]));
            add_strokes(panel, history, quantities[row], d);
            scene.panels.push_back(std::move(panel));
        }
    return scene;
}

}  // namespace stridor::pictures
