#include "stridor/pictures/noise_chart.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/text.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/chart_cells.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stridor::pictures {

namespace {

std::span<const sweep::CellVerdict> cells_of(const sweep::SweepResult& result, std::size_t direction) {
    const std::size_t count =
        static_cast<std::size_t>(result.study.x.points) * static_cast<std::size_t>(result.study.y.points);
    STRIDOR_EXPECT(result.cells.size() == count * result.study.directions.size());
    return std::span(result.cells).subspan(direction * count, count);
}

// "Each cell was run from rest, stuck and sliding; the worst is shown."
drawing::StyledText starts_caption(const sweep::Study& study) {
    std::string names;
    for (std::size_t k = 0; k < study.starts.size(); ++k) {
        const bool is_last = k > 0 && k + 1 == study.starts.size();
        names += (k == 0    ? ""
                  : is_last ? " and "
                            : ", ") +
                 std::string(sweep::start_names()[static_cast<std::size_t>(study.starts[k])]);
    }
    return drawing::StyledText("Each cell was run from " + names + "; the worst is shown.");
}

drawing::Scene empty_chart(const sweep::SweepResult& result, const drawing::StyledText& title) {
    const sweep::Study& study = result.study;
    std::vector<std::string_view> varied{study.x.parameter, study.y.parameter};
    if (!study.starts.empty()) varied.emplace_back("run.initial");
    drawing::Scene scene;
    scene.title = title;
    scene.caption = {conditions(study.base, varied)};
    if (!study.starts.empty()) scene.caption.push_back(starts_caption(study));
    scene.column_widths.assign(study.directions.size(), 1.0);
    scene.height = study.directions.size() == 1 ? 110.0 : 92.0;
    for (std::size_t d = 0; d < study.directions.size(); ++d) {
        const bool is_going = study.directions[d] == parameters::Direction::going;
        const drawing::StyledText name = drawing::StyledText(is_going ? "going (" : "coming (") + drawing::symbol("V") +
                                         (is_going ? " > 0)" : " < 0)");
        drawing::Panel panel;
        panel.title = study.directions.size() == 1 ? name : lettered(d, name);
        panel.column = d;
        panel.frame = drawing::Frame::closed;
        panel.x = field_axis(study.x);
        panel.y = field_axis(study.y);
        if (d > 0) panel.y.text = drawing::AxisText::hidden;
        scene.panels.push_back(std::move(panel));
    }
    return scene;
}

// which values the colours of a figure begin and end with: a few odd cells do not wash out all others
drawing::Extent value_range(std::vector<double> values, const sweep::CellFigure& figure) {
    constexpr double odd_share = 0.02;    // usual 0.02; 0 lets a single value take half of the colours
    constexpr double level_span = 100.0;  // [dB] what lies lower is rest, and would take all colours
    values.erase(std::remove_if(values.begin(), values.end(), [](double value) { return !std::isfinite(value); }),
                 values.end());
    std::sort(values.begin(), values.end());
    const bool is_share = figure.unit == "1" && (values.empty() || (values.front() >= 0.0 && values.back() <= 1.0));
    if (is_share || values.empty()) return {0.0, 1.0};
    const auto skipped = static_cast<std::size_t>(odd_share * static_cast<double>(values.size()));
    drawing::Extent range{values[skipped], values[values.size() - 1 - skipped]};
    if (figure.unit.substr(0, 2) == "dB") range.from = std::max(range.from, range.to - level_span);
    return range.from < range.to ? range : drawing::Extent{range.from - 0.5, range.from + 0.5};
}

bool reaches_beyond(std::span<const double> values, const drawing::Extent& range) {
    return std::any_of(values.begin(), values.end(),
                       [&](double value) { return std::isfinite(value) && (value < range.from || value > range.to); });
}

// one figure of every cell; NaN where the cell is not done or has no such value
std::vector<double> shown_values(const ShownCells& shown, const sweep::CellFigure& figure) {
    std::vector<double> values = shown.values(figure);
    for (std::size_t index = 0; index < values.size(); ++index)
        if (shown.chart().cells[index].status != sweep::Status::done || !std::isfinite(values[index]))
            values[index] = sweep::Cell::unknown;
    return values;
}

bool is_torn(const sweep::CellVerdict& cell) {
    return cell.agreement == sweep::Agreement::quiet_unless_disturbed;
}

// a disc on each cell that is quiet from one start and noisy from another
drawing::Points torn_points(const sweep::SweepResult& result, std::size_t direction) {
    const sweep::Study& study = result.study;
    drawing::Points points{{}, {}, drawing::ink, 2.0, drawing::white};
    // small enough for the cells to be told apart
    points.columns = static_cast<std::size_t>(study.x.points);
    points.rows = static_cast<std::size_t>(study.y.points);
    for (std::size_t index = 0; index < result.cells.size(); ++index) {
        const sweep::CellPlace place = sweep::place_of(study, index);
        if (place.direction != direction || !is_torn(result.cells[index])) continue;
        points.x.push_back(sweep::value_at(study.x, place.ix));
        points.y.push_back(sweep::value_at(study.y, place.iy));
    }
    return points;
}

// "12 % of the cells were computed, ...": nothing for a complete chart
std::vector<drawing::StyledText> refinement_caption(const sweep::SweepResult& result, const std::string& of_others) {
    const std::size_t computed = sweep::computed_count(result);
    if (computed == result.cells.size()) return {};
    const double share = 100.0 * static_cast<double>(computed) / static_cast<double>(result.cells.size());
    return {drawing::StyledText(base::shortest(std::round(share * 10.0) / 10.0) + " % of the cells were computed; " +
                                of_others)};
}

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

drawing::Scene noise_chart(const sweep::SweepResult& result) {
    const ShownCells shown(result);
    const sweep::SweepResult& chart = shown.chart();
    const std::string& title = result.study.base.title;
    drawing::Scene scene =
        empty_chart(chart, title.empty() ? drawing::StyledText("Noise chart") : drawing::StyledText(title));
    add_kind_legend(scene, result);
    if (std::any_of(result.cells.begin(), result.cells.end(), is_torn))
        scene.legend.push_back({"quiet unless disturbed", drawing::Points{{}, {}, drawing::ink, 2.0, drawing::white}});
    for (drawing::StyledText& text : refinement_caption(result, "the others lie among such that agree."))
        scene.caption.push_back(std::move(text));
    for (drawing::StyledText& text : shown.caption())
        scene.caption.push_back(std::move(text));
    const std::vector<sweep::Boundary> boundaries = sweep::boundaries(chart);
    for (std::size_t d = 0; d < scene.panels.size(); ++d) {
        drawing::CategoryCells map{cell_edges(chart.study.x), cell_edges(chart.study.y), {}, kind_fills()};
        for (const sweep::CellVerdict& cell : cells_of(chart, d))
            map.kinds.push_back(static_cast<std::uint16_t>(kind_of(cell)));
        std::vector<drawing::Layer>& layers = scene.panels[d].layers;
        layers.emplace_back(std::move(map));
        if (drawing::Line line = boundary_line(chart.study, boundaries, d); !line.x.empty())
            layers.emplace_back(std::move(line));
        if (drawing::Points torn = torn_points(chart, d); !torn.x.empty()) layers.emplace_back(std::move(torn));
        layers.emplace_back(drawing::RegionNames{kind_names()});
    }
    return scene;
}

drawing::Scene figure_chart(const sweep::SweepResult& result, std::string_view name) {
    const sweep::CellFigure* figure = sweep::find_cell_figure(name);
    if (figure == nullptr) {
        std::vector<std::string_view> known{"category"};
        for (const sweep::CellFigure& each : sweep::cell_figures())
            known.push_back(each.name);
        throw Error(ErrorKind::input,
                    {"\"" + std::string(name) + "\" is no figure of a cell",
                     "it is neither \"category\" nor a column of the results", base::did_you_mean(name, known)});
    }
    const std::string& title = result.study.base.title;
    const ShownCells shown(result);
    const sweep::SweepResult& chart = shown.chart();
    drawing::Scene scene = empty_chart(chart, (title.empty() ? "" : title + ": ") + spelled(figure->name));
    const std::vector<double> values = shown_values(shown, *figure);
    const drawing::ColourScale colours{value_range(values, *figure), drawing::AxisScale::linear};
    const drawing::Fill no_value{{0xD9, 0xD9, 0xD9}, drawing::Texture::none, {}};
    if (figure->unit.starts_with("dB"))
        scene.caption.emplace_back("A velocity level of the " +
                                   std::string(figure->name.substr(0, figure->name.find('_'))) +
                                   ": a vibration, not a sound pressure.");
    if (reaches_beyond(values, colours.range))
        scene.caption.emplace_back("Values beyond the scale have the colour of its end.");
    for (drawing::StyledText& text :
         refinement_caption(result, "the others have the value of the nearest corner of their block."))
        scene.caption.push_back(std::move(text));
    for (drawing::StyledText& text : shown.caption())
        scene.caption.push_back(std::move(text));
    bool has_gap = false;
    for (std::size_t d = 0; d < scene.panels.size(); ++d) {
        drawing::ValueCells map{cell_edges(chart.study.x), cell_edges(chart.study.y), {}, colours, no_value};
        drawing::Boxes failed{{}, failed_fill()};
        const std::span<const sweep::CellVerdict> cells = cells_of(chart, d);
        const std::size_t columns = map.x_edges.size() - 1;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const bool is_done = cells[i].status == sweep::Status::done;
            const double value = values[d * cells.size() + i];
            map.values.push_back(value);
            has_gap = has_gap || (is_done && !std::isfinite(value));
            if (!is_done)
                failed.boxes.push_back({{map.x_edges[i % columns], map.x_edges[i % columns + 1]},
                                        {map.y_edges[i / columns], map.y_edges[i / columns + 1]}});
        }
        scene.panels[d].layers.emplace_back(std::move(map));
        if (!failed.boxes.empty()) scene.panels[d].layers.emplace_back(std::move(failed));
    }
    scene.colour_bar = drawing::ColourBar{spelled(figure->name), std::string(figure->unit), colours};
    if (has_gap) scene.legend.push_back({"no value", no_value});
    if (const std::string text = failure_words(result); !text.empty()) scene.legend.push_back({text, failed_fill()});
    return scene;
}

drawing::Scene quantity_chart(const sweep::SweepResult& result, std::string_view quantity) {
    return quantity == "category" ? noise_chart(result) : figure_chart(result, quantity);
}

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
