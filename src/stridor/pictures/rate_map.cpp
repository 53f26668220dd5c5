#include "stridor/pictures/rate_map.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

namespace stridor::pictures {

namespace {

constexpr std::array<std::string_view, 3> rates{"slip", "stick", "separation"};
constexpr drawing::ColourScale percent{{0.0, 100.0}, drawing::AxisScale::linear};

// `values` is a rate of every cell
drawing::Panel map_panel(const sweep::SweepResult& result, std::size_t direction, std::span<const double> values) {
    const sweep::Study& study = result.study;
    const std::size_t count = static_cast<std::size_t>(study.x.points) * static_cast<std::size_t>(study.y.points);
    STRIDOR_EXPECT(result.cells.size() == count * study.directions.size());
    drawing::Panel panel;
    panel.frame = drawing::Frame::closed;
    panel.x = field_axis(study.x);
    panel.y = field_axis(study.y);
    drawing::ValueCells cells{cell_edges(study.x), cell_edges(study.y), {}, percent, failed_fill()};
    for (std::size_t i = direction * count; i < (direction + 1) * count; ++i) {
        const bool is_done = result.cells[i].status == sweep::Status::done;
        cells.values.push_back(is_done ? 100.0 * values[i] : sweep::Cell::unknown);
    }
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

bool has_failures(const sweep::SweepResult& result) {
    return std::any_of(result.cells.begin(), result.cells.end(),
                       [](const sweep::CellVerdict& cell) { return cell.status != sweep::Status::done; });
}

bool is_refined(const sweep::SweepResult& result) {
    return sweep::computed_count(result) < result.cells.size();
}

// what tells one row from the next: the angle and the direction
drawing::StyledText row_name(const sweep::Study& study, std::size_t direction) {
    return setting(study.base, "joint.incidence_angle") + ", " +
           drawing::StyledText(parameters::direction_names[static_cast<std::size_t>(study.directions[direction])]);
}

// the axis below the lowest map of a column serves all that share it
void share_x_axes(drawing::Scene& scene) {
    for (drawing::Panel& panel : scene.panels)
        for (const drawing::Panel& other : scene.panels)
            if (other.column == panel.column && other.row == panel.row + 1 && other.x.label == panel.x.label &&
                other.x.range == panel.x.range && other.x.scale == panel.x.scale)
                panel.x.text = drawing::AxisText::hidden;
}

}  // namespace

drawing::Scene rate_map(std::span<const sweep::SweepResult> results) {
    drawing::Scene scene;
    scene.title = "Contact-state rates";
    scene.column_widths.assign(rates.size(), 1.0);
    scene.row_heights.clear();
    bool is_any_failed = false;
    for (const sweep::SweepResult& result : results) {
        is_any_failed = is_any_failed || has_failures(result);
        std::array<std::vector<double>, rates.size()> values;
        for (std::size_t column = 0; column < rates.size(); ++column)
            values[column] = sweep::figure_values(result, sweep::cell_figure(rates[column]));
        for (std::size_t d = 0; d < result.study.directions.size(); ++d) {
            for (std::size_t column = 0; column < rates.size(); ++column) {
                drawing::Panel panel = map_panel(result, d, values[column]);
                panel.row = scene.row_heights.size();
                panel.column = column;
                panel.title = column == 0 ? lettered(panel.row, row_name(result.study, d) + ": slip")
                                          : drawing::StyledText(rates[column]);
                if (column > 0) panel.y.text = drawing::AxisText::hidden;
                scene.panels.push_back(std::move(panel));
            }
            scene.row_heights.push_back(1.0);
        }
    }
    share_x_axes(scene);
    if (!results.empty()) {
        const sweep::Study& study = results.front().study;
        const std::array<std::string_view, 3> varied{study.x.parameter, study.y.parameter, "joint.incidence_angle"};
        scene.caption = {conditions(study.base, varied)};
        if (std::any_of(results.begin(), results.end(), is_refined))
            scene.caption.emplace_back(
                "Cells that were not computed have the values of the nearest corner of their block.");
    }
    if (scene.row_heights.empty()) scene.row_heights = {1.0};
    scene.height = 22.0 + 56.0 * static_cast<double>(scene.row_heights.size());
    scene.colour_bar = drawing::ColourBar{"share of the window", "%", percent};
    if (is_any_failed) {
        drawing::LegendEntry& entry = scene.legend.emplace_back();
        entry.text = "failed";
        entry.sample = failed_fill();
    }
    return scene;
}

}  // namespace stridor::pictures
