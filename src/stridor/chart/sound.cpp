#include "stridor/chart/sound.hpp"

#include "stridor/chart/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace stridor::chart {

namespace {

using classification::Category;
using signal::SoundAnalysis;

constexpr double depth = 70.0;  // [dB] of the spectrogram's colours
constexpr std::size_t most_columns = 360;
constexpr std::size_t most_rows = 140;

Range air_around(double low, double high) {
    const double air = high > low ? 0.06 * (high - low) : 1.0;
    return {low - air, high + air};
}

Panel panel_over_time(const SoundAnalysis& analysis, std::size_t row) {
    Panel panel;
    panel.row = row;
    panel.grid = Grid::both;
    panel.x.range = {0.0, analysis.duration};
    panel.x.text = AxisText::hidden;
    return panel;
}

Panel waveform_panel(const SoundAnalysis& analysis) {
    Panel panel = panel_over_time(analysis, 0);
    panel.y.label = analysis.unit == "FS" ? "sound" : "signal";
    panel.y.unit = analysis.unit == "FS" ? "1" : analysis.unit;
    Line line;
    line.stroke = {accent, 0.5, Dash::solid};
    double low = 0.0;
    double high = 0.0;
    for (std::size_t k = 0; k < analysis.waveform.extents.size(); ++k) {
        const signal::Extent& extent = analysis.waveform.extents[k];
        const double time = (static_cast<double>(k) + 0.5) * analysis.waveform.interval;
        line.x.insert(line.x.end(), {time, time});
        line.y.insert(line.y.end(), {extent.low, extent.high});
        low = std::min(low, extent.low);
        high = std::max(high, extent.high);
    }
    panel.y.range = air_around(low, high);
    panel.layers.emplace_back(std::move(line));
    return panel;
}

Panel level_panel(const SoundAnalysis& analysis) {
    Panel panel = panel_over_time(analysis, 1);
    panel.y.label = "level, fast";
    panel.y.unit = "dB";
    Line line;
    line.stroke = {accent, 0.8, Dash::solid};
    const double highest = analysis.level.greatest;
    double lowest = highest;
    for (std::size_t k = 0; k < analysis.level.decibels.size(); ++k) {
        const double here = std::max(analysis.level.decibels[k], highest - 90.0);
        line.x.push_back(static_cast<double>(k + 1) * analysis.level.interval);
        line.y.push_back(here);
        lowest = std::min(lowest, here);
    }
    const bool has_level = std::isfinite(highest);
    panel.y.range = has_level ? air_around(lowest, highest) : Range{-1.0, 1.0};
    if (has_level) panel.layers.emplace_back(std::move(line));
    return panel;
}

// the frequency below which 99.9 % of the power lies, doubled
double highest_frequency(const signal::Spectrum& spectrum) {
    double whole = 0.0;
    for (const double density : spectrum.density)
        whole += density;
    double sum = 0.0;
    std::size_t k = 0;
    while (k + 1 < spectrum.density.size() && sum <= 0.999 * whole)
        sum += spectrum.density[k++];
    const double limit = spectrum.spacing * static_cast<double>(spectrum.density.size() - 1);
    return std::min(limit, std::max(2000.0, 2.0 * static_cast<double>(k) * spectrum.spacing));
}

// levels of pooled cells, shape [row][column]
ValueCells spectrogram_cells(const SoundAnalysis& analysis, double highest) {
    const signal::Spectrogram& graph = analysis.spectrogram;
    const auto rows = std::min(graph.rows, static_cast<std::size_t>(std::ceil(highest / graph.row)));
    const std::size_t row_pool = (rows + most_rows - 1) / most_rows;
    const std::size_t column_pool = (graph.columns() + most_columns - 1) / most_columns;
    ValueCells cells;
    const double reference = signal::reference_of(analysis.unit);
    for (std::size_t row = 0; row < rows; row += row_pool) {
        cells.y_edges.push_back(static_cast<double>(row) * graph.row);
        for (std::size_t column = 0; column < graph.columns(); column += column_pool) {
            double sum = 0.0;
            std::size_t count = 0;
            for (std::size_t c = column; c < std::min(column + column_pool, graph.columns()); ++c)
                for (std::size_t r = row; r < std::min(row + row_pool, rows); ++r, ++count)
                    sum += graph.density[c * graph.rows + r];
            cells.values.push_back(signal::level_of(std::max(sum / static_cast<double>(count), 1e-300), reference));
        }
    }
    cells.y_edges.push_back(static_cast<double>(rows) * graph.row);
    for (std::size_t column = 0; column < graph.columns(); column += column_pool)
        cells.x_edges.push_back(static_cast<double>(column) * graph.column);
    cells.x_edges.push_back(static_cast<double>(graph.columns()) * graph.column);
    const double top = std::ceil(*std::max_element(cells.values.begin(), cells.values.end()));
    cells.colours = {{top - depth, top}, AxisScale::linear};
    return cells;
}

Panel spectrogram_panel(const SoundAnalysis& analysis, Scene& scene) {
    Panel panel = panel_over_time(analysis, 2);
    panel.frame = Frame::closed;
    panel.grid = Grid::none;
    const double highest = highest_frequency(analysis.spectrum);
    panel.y.label = "frequency";
    panel.y.unit = "Hz";
    panel.y.range = {0.0, highest};
    if (analysis.spectrogram.columns() == 0) return panel;
    ValueCells cells = spectrogram_cells(analysis, highest);
    scene.colour_bar = ColourBar{"level per hertz", signal::level_unit(analysis.unit), cells.colours};
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

Panel category_panel(const SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    Panel panel = panel_over_time(analysis, 3);
    panel.frame = Frame::closed;
    panel.grid = Grid::none;
    panel.x.text = AxisText::shown;
    panel.x.label = "time";
    panel.x.unit = "s";
    panel.y.range = {0.0, 1.0};
    panel.y.text = AxisText::hidden;
    for (std::size_t k = 0; k < classification::category_names.size(); ++k) {
        Boxes boxes;
        boxes.fill = category_fill(static_cast<Category>(k));
        for (const classification::SoundSegment& segment : verdict.segments)
            if (static_cast<std::size_t>(segment.verdict.category) == k)
                boxes.boxes.push_back({{segment.from, std::min(segment.to, analysis.duration)}, {0.0, 1.0}});
        if (!boxes.boxes.empty()) panel.layers.emplace_back(std::move(boxes));
    }
    return panel;
}

}  // namespace

Scene sound(const SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    Scene scene;
    scene.title = analysis.name.empty() ? Text("Recording") : Text(analysis.name);
    scene.caption = {
        Text(fmt::format("{:.4g} s at {:g} Hz; levels in {}; heard as {}", analysis.duration, analysis.rate,
                         signal::level_unit(analysis.unit), classification::name(verdict.category)))};
    scene.height = 150.0;
    scene.row_heights = {1.0, 0.8, 1.8, 0.22};
    scene.panels.push_back(waveform_panel(analysis));
    scene.panels.push_back(level_panel(analysis));
    scene.panels.push_back(spectrogram_panel(analysis, scene));
    scene.panels.push_back(category_panel(analysis, verdict));
    for (std::size_t k = 0; k < classification::category_names.size(); ++k) {
        const auto category = static_cast<Category>(k);
        const bool occurs = std::any_of(verdict.segments.begin(), verdict.segments.end(),
                                        [&](const auto& segment) { return segment.verdict.category == category; });
        if (!occurs) continue;
        LegendEntry entry;
        entry.text = Text(classification::name(category));
        entry.sample = category_fill(category);
        scene.legend.push_back(std::move(entry));
    }
    return scene;
}

}  // namespace stridor::chart
