#include "stridor/pictures/sound.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/sound_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::pictures {

namespace {

using sound::SoundAnalysis;

drawing::Panel panel_over_time(const SoundAnalysis& analysis, std::size_t row) {
    drawing::Panel panel;
    panel.row = row;
    panel.grid = drawing::Grid::both;
    panel.x.range = {0.0, analysis.duration};
    panel.x.text = drawing::AxisText::hidden;
    return panel;
}

drawing::Panel waveform_panel(const SoundAnalysis& analysis) {
    drawing::Panel panel = panel_over_time(analysis, 0);
    panel.y.label = analysis.unit == "FS" ? "sound" : "signal";
    panel.y.unit = analysis.unit == "FS" ? "1" : analysis.unit;
    drawing::Line line = waveform_line(analysis);
    double low = 0.0;
    double high = 0.0;
    for (const double sample : line.y) {
        low = std::min(low, sample);
        high = std::max(high, sample);
    }
    panel.y.range = air_around(low, high);
    panel.layers.emplace_back(std::move(line));
    return panel;
}

drawing::Panel level_panel(const SoundAnalysis& analysis) {
    drawing::Panel panel = panel_over_time(analysis, 1);
    panel.y.label = "level, fast";
    panel.y.unit = "dB";
    drawing::Line line;
    line.stroke = {drawing::accent, 0.8, drawing::Dash::solid};
    const double highest = analysis.level.greatest;
    double lowest = highest;
    for (std::size_t k = 0; k < analysis.level.decibels.size(); ++k) {
        const double here = std::max(analysis.level.decibels[k], highest - 90.0);
        line.x.push_back(static_cast<double>(k + 1) * analysis.level.interval);
        line.y.push_back(here);
        lowest = std::min(lowest, here);
    }
    const bool has_level = std::isfinite(highest);
    panel.y.range = has_level ? air_around(lowest, highest) : drawing::Extent{-1.0, 1.0};
    if (has_level) panel.layers.emplace_back(std::move(line));
    return panel;
}

drawing::Panel spectrogram_panel(const SoundAnalysis& analysis, drawing::Scene& scene) {
    drawing::Panel panel = panel_over_time(analysis, 2);
    panel.frame = drawing::Frame::closed;
    panel.grid = drawing::Grid::none;
    const double highest = highest_frequency(analysis.spectrum);
    panel.y.label = "frequency";
    panel.y.unit = "Hz";
    panel.y.range = {0.0, highest};
    if (analysis.spectrogram.columns() == 0) return panel;
    drawing::ValueCells cells = spectrogram_cells(analysis, highest);
    scene.colour_bar = drawing::ColourBar{"level per hertz", signal::level_unit(analysis.unit), cells.colours};
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

drawing::Panel category_panel(const SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    drawing::Panel panel = panel_over_time(analysis, 3);
    panel.frame = drawing::Frame::closed;
    panel.grid = drawing::Grid::none;
    panel.x.text = drawing::AxisText::shown;
    panel.x.label = "time";
    panel.x.unit = "s";
    panel.y.range = {0.0, 1.0};
    panel.y.text = drawing::AxisText::hidden;
    panel.layers = segment_layers(verdict, analysis.duration);
    return panel;
}

}  // namespace

drawing::Scene sound(const SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    drawing::Scene scene;
    scene.title = analysis.name.empty() ? drawing::StyledText("Recording") : drawing::StyledText(analysis.name);
    scene.caption = {drawing::StyledText(
        fmt::format("{:.4g} s at {:g} Hz; levels in {}; heard as {}", analysis.duration, analysis.rate,
                    signal::level_unit(analysis.unit), classification::name(verdict.category)))};
    scene.height = 150.0;
    scene.row_heights = {1.0, 0.8, 1.8, 0.22};
    scene.panels.push_back(waveform_panel(analysis));
    scene.panels.push_back(level_panel(analysis));
    scene.panels.push_back(spectrogram_panel(analysis, scene));
    scene.panels.push_back(category_panel(analysis, verdict));
    scene.legend = category_legend({&verdict});
    return scene;
}

}  // namespace stridor::pictures
