#include "stridor/pictures/following.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::pictures {

namespace {

using sweep::FollowedRun;
using sweep::FollowedWay;

constexpr drawing::Colour way_colours[] = {{0x00, 0x66, 0x99}, {0xC4, 0x6A, 0x00}};
constexpr drawing::Mark way_marks[] = {drawing::Mark::triangle, drawing::Mark::nabla};
constexpr double way_mark_size = 3.2;  // [pt]

drawing::Extent figure_extent(const sweep::Following& following, const sweep::CellFigure& figure) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const FollowedRun& run : following.runs)
        for (const sweep::Cell& cell : run.cells) {
            const double value = sweep::figure_of(cell, figure);
            if (!std::isfinite(value)) continue;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    if (!(low <= high)) return {0.0, 1.0};
    const double air = high > low ? 0.06 * (high - low) : std::max(1e-12, 0.1 * std::abs(high));
    return {low - air, high + air};
}

// where the ways differ, half a step to both sides
drawing::Boxes differing(const sweep::Following& following, std::size_t direction, const drawing::Extent& y) {
    const double half_step = 0.5 * (following.over.to - following.over.from) / (following.over.points - 1);
    drawing::Boxes boxes{{}, {drawing::tint({0x7B, 0x3F, 0x8C}, 0.14), drawing::Texture::none, {}}};
    for (const double value : sweep::hysteresis(following, direction))
        boxes.boxes.push_back(
            {{std::max(following.over.from, value - half_step), std::min(following.over.to, value + half_step)}, y});
    return boxes;
}

void add_way(drawing::Panel& panel, const sweep::Following& following, const sweep::CellFigure& figure,
             std::size_t direction, FollowedWay way) {
    const auto which = static_cast<std::size_t>(way);
    drawing::Line line{
        {}, {}, {way_colours[which], 1.0, way == FollowedWay::up ? drawing::Dash::solid : drawing::Dash::dashed}};
    std::map<std::string_view, drawing::Points> marks;  // by verdict
    for (const FollowedRun& run : following.runs) {
        // the way down begins where the way up ends
        const bool is_turn = run.way == FollowedWay::up && run.value == following.over.to;
        if (run.way != way && !is_turn) continue;
        const sweep::Cell& cell = run.cells[direction];
        const double value = sweep::figure_of(cell, figure);
        if (cell.status != sweep::Status::done || !std::isfinite(value)) continue;
        line.x.push_back(run.value);
        line.y.push_back(value);
        if (run.way != way) continue;
        drawing::Points& points = marks[sweep::word(cell)];
        points.x.push_back(run.value);
        points.y.push_back(value);
        points.colour = category_fill(cell.category).colour;
        points.diameter = way_mark_size;
        points.mark = way_marks[which];
        points.outline = way_colours[which];
    }
    if (!line.x.empty()) panel.layers.emplace_back(std::move(line));
    for (auto& [word, points] : marks)
        panel.layers.emplace_back(std::move(points));
}

}  // namespace

drawing::Scene following(const sweep::Following& following, const sweep::CellFigure& figure) {
    const parameters::Field* field = parameters::field_of(following.over.key);
    STRIDOR_EXPECT(field != nullptr);
    const std::string& title = following.base.title;
    drawing::Scene scene;
    scene.title = "Followed up and down" + (title.empty() ? "" : ": " + title);
    scene.caption = {
        conditions(following.base, std::array<std::string_view, 1>{following.over.key}),
        "Triangles: up, solid; upside down: down, dashed; their colour is the verdict. Tinted: the ways have "
        "other verdicts."};
    scene.height = 75.0;
    scene.column_widths.assign(following.directions.size(), 1.0);
    scene.row_heights = {1.0};
    const drawing::Extent y = figure_extent(following, figure);
    for (std::size_t d = 0; d < following.directions.size(); ++d) {
        drawing::Panel panel;
        panel.grid = drawing::Grid::both;
        panel.column = d;
        panel.x.label = field_label(*field);
        panel.x.unit = parameters::unit_of(*field);
        panel.x.range = {following.over.from, following.over.to};
        panel.y.label = spelled(figure.name);
        panel.y.unit = figure.unit;
        panel.y.range = y;
        if (d > 0) panel.y.text = drawing::AxisText::hidden;
        panel.title = lettered(
            d, drawing::StyledText(parameters::direction_names[static_cast<std::size_t>(following.directions[d])]));
        panel.layers.emplace_back(differing(following, d, y));
        for (const FollowedWay way : {FollowedWay::up, FollowedWay::down})
            add_way(panel, following, figure, d, way);
        scene.panels.push_back(std::move(panel));
    }
    return scene;
}

}  // namespace stridor::pictures
