#include "stridor/pictures/diagram.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace stridor::pictures {

namespace {

using sweep::DiagramCell;
using sweep::SweepResult;

constexpr double point_diameter = 1.1;      // [pt]
constexpr double octaves_of_linear = 16.0;  // [1] largest over smallest value up to which a linear axis shows both

// a row of panels: for each cell the values that stand above its place on the x axis
struct DiagramRow {
    drawing::StyledText label;
    std::string unit;
    std::vector<std::vector<double>> values;  // shape [cell][value]
};

std::vector<std::vector<double>> values_of(const std::vector<DiagramCell>& cells,
                                           std::vector<double> DiagramCell::*member) {
    std::vector<std::vector<double>> values;
    for (const DiagramCell& cell : cells)
        values.push_back(cell.*member);
    return values;
}

DiagramRow figure_row(const SweepResult& result, const sweep::CellFigure& figure) {
    std::string name(figure.name);
    std::replace(name.begin(), name.end(), '_', ' ');
    DiagramRow row{drawing::StyledText(name), std::string(figure.unit), {}};
    for (const double value : sweep::figure_values(result, figure))
        row.values.push_back(std::isfinite(value) ? std::vector{value} : std::vector<double>{});
    return row;
}

std::vector<DiagramRow> rows_of(const SweepResult& result, const std::vector<DiagramCell>& cells) {
    const drawing::StyledText x1 =
        drawing::StyledText("x", drawing::TextStyle::italic) + drawing::StyledText("1", drawing::TextStyle::subscript);
    std::vector<DiagramRow> rows{
        {drawing::StyledText("extremes of ") + x1, "m", values_of(cells, &DiagramCell::extremes)},
        {"beat interval", "s", values_of(cells, &DiagramCell::intervals)}};
    for (const std::string& quantity : result.study.quantities)
        if (const sweep::CellFigure* figure = sweep::find_cell_figure(quantity))
            rows.push_back(figure_row(result, *figure));
    return rows;
}

// from the least to the largest value of all directions, with a little air
drawing::PanelAxis axis_over(const DiagramRow& row) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::vector<double>& values : row.values)
        for (const double value : values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    drawing::PanelAxis axis;
    axis.label = row.label;
    axis.unit = row.unit;
    if (!(low <= high)) return axis;
    const bool is_wide = low > 0.0 && high > octaves_of_linear * low;
    if (is_wide) {
        axis.scale = drawing::AxisScale::logarithmic;
        axis.range = {low / 1.2, high * 1.2};
        return axis;
    }
    const double air = high > low ? 0.06 * (high - low) : std::max(1e-12, 0.1 * std::abs(high));
    axis.range = {low - air, high + air};
    return axis;
}

drawing::Panel strip_panel(const SweepResult& result, std::size_t direction) {
    const auto columns = static_cast<std::size_t>(result.study.x.points);
    drawing::Panel panel;
    panel.frame = drawing::Frame::closed;
    panel.y.range = {0.0, 1.0};
    panel.y.ticks = {{-1.0, {}, drawing::TickSize::minor}};  // none within the strip
    drawing::CategoryCells strip{cell_edges(result.study.x), {0.0, 1.0}, {}, kind_fills()};
    for (std::size_t ix = 0; ix < columns; ++ix)
        strip.kinds.push_back(static_cast<std::uint16_t>(kind_of(result.cells[direction * columns + ix])));
    panel.layers.emplace_back(std::move(strip));
    return panel;
}

drawing::Panel points_panel(const SweepResult& result, const DiagramRow& row, std::size_t direction) {
    const auto columns = static_cast<std::size_t>(result.study.x.points);
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.y = axis_over(row);
    drawing::Points points{{}, {}, drawing::accent, point_diameter, {}};
    for (std::size_t ix = 0; ix < columns; ++ix)
        for (const double value : row.values[direction * columns + ix]) {
            points.x.push_back(sweep::value_at(result.study.x, static_cast<int>(ix)));
            points.y.push_back(value);
        }
    if (!points.x.empty()) panel.layers.emplace_back(std::move(points));
    return panel;
}

drawing::StyledText direction_title(const sweep::Study& study, std::size_t direction) {
    const bool is_going = study.directions[direction] == parameters::Direction::going;
    const drawing::StyledText name =
        drawing::StyledText(is_going ? "going (" : "coming (") + drawing::symbol("V") + (is_going ? " > 0)" : " < 0)");
    return study.directions.size() == 1 ? name : lettered(direction, name);
}

}  // namespace

drawing::Scene diagram(const SweepResult& result, const std::vector<DiagramCell>& cells) {
    const sweep::Study& study = result.study;
    STRIDOR_EXPECT(sweep::has_one_axis(study) && cells.size() == result.cells.size());
    const std::vector<DiagramRow> rows = rows_of(result, cells);
    drawing::Scene scene;
    scene.title = study.base.title.empty() ? drawing::StyledText("Diagram over one parameter")
                                           : drawing::StyledText(study.base.title);
    scene.caption = {
        conditions(study.base, std::array<std::string_view, 1>{study.x.parameter}),
        "Points: the turns of the joint's motion, and the times between like changes of contact state, in the "
        "judged part of each run."};
    scene.column_widths.assign(study.directions.size(), 1.0);
    scene.row_heights = {0.28};
    scene.row_heights.resize(1 + rows.size(), 1.0);
    scene.height = 44.0 + 40.0 * static_cast<double>(rows.size());
    for (std::size_t direction = 0; direction < study.directions.size(); ++direction)
        for (std::size_t row = 0; row <= rows.size(); ++row) {
            drawing::Panel panel =
                row == 0 ? strip_panel(result, direction) : points_panel(result, rows[row - 1], direction);
            if (row == 0) panel.title = direction_title(study, direction);
            panel.row = row;
            panel.column = direction;
            panel.x = field_axis(study.x);
            if (row < rows.size()) panel.x.text = drawing::AxisText::hidden;
            if (direction > 0) panel.y.text = drawing::AxisText::hidden;
            scene.panels.push_back(std::move(panel));
        }
    add_kind_legend(scene, result);
    return scene;
}

}  // namespace stridor::pictures
