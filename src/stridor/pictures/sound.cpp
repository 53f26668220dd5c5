#include "stridor/pictures/sound.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/sound_panels.hpp"
#include "stridor/sound/tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace stridor::pictures {

namespace {

using classification::RecordingVerdict;
using sound::SoundAnalysis;

constexpr double height_by_the_rules = 150.0;  // [mm]
constexpr double height_by_the_ear = 215.0;    // [mm]

constexpr std::size_t most_marks = 1500;                   // of a track: more are not told apart on paper
constexpr double band_of_marks = 0.05;                     // [1] of a panel's height, above its spectrogram
constexpr drawing::Colour pitch_colour{0xE6, 0x2E, 0x2E};  // on every colour of the sequential map

drawing::Panel panel_over_time(const SoundAnalysis& analysis, std::size_t row) {
    drawing::Panel panel;
    panel.row = row;
    panel.grid = drawing::Grid::both;
    panel.x.range = {0.0, analysis.duration};
    panel.x.text = drawing::AxisText::hidden;
    return panel;
}

drawing::Extent excerpt_of(const SoundAnalysis& analysis) {
    const signal::Spectrogram& graph = analysis.impulses;
    return {graph.from, graph.from + graph.column * static_cast<double>(graph.columns())};
}

bool has_cells(const signal::Spectrogram& graph) {
    return graph.columns() > 0;
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
    // where the last panel looks closely
    if (has_cells(analysis.impulses) && analysis.passages.size() > 1)
        panel.layers.emplace_back(drawing::Boxes{{{excerpt_of(analysis), panel.y.range}},
                                                 {drawing::highlight, drawing::Texture::none, drawing::ink}});
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

// the ground for onsets above a spectrogram up to `highest` [Hz]
drawing::Extent with_band(double highest) {
    return {0.0, (1.0 + band_of_marks) * highest};
}

// the tracks of what the ear follows
drawing::Points pitch_points(const SoundAnalysis& analysis) {
    drawing::Points points;
    points.colour = pitch_colour;
    points.diameter = 1.8;
    for (const sound::TonePoint& point : sound::pitch_track(analysis, most_marks)) {
        points.x.push_back(point.time);
        points.y.push_back(point.frequency);
    }
    return points;
}

drawing::Line onset_ticks(const std::vector<double>& instants, double highest) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    drawing::Line line;
    line.stroke = {drawing::ink, 0.5, drawing::Dash::solid};
    for (const double instant : instants) {
        line.x.insert(line.x.end(), {instant, instant, instant});
        line.y.insert(line.y.end(), {1.005 * highest, (1.0 + band_of_marks) * highest, nothing});
    }
    return line;
}

drawing::Panel harmonics_panel(const SoundAnalysis& analysis) {
    drawing::Panel panel = panel_over_time(analysis, 2);
    panel.frame = drawing::Frame::closed;
    panel.grid = drawing::Grid::none;
    const double highest = highest_frequency(analysis.spectrum);
    panel.y.label = "frequency";
    panel.y.unit = "Hz";
    panel.y.range = analysis.passages.empty() ? drawing::Extent{0.0, highest} : with_band(highest);
    if (!has_cells(analysis.spectrogram)) return panel;
    panel.layers.emplace_back(spectrogram_cells(analysis.spectrogram, highest));
    if (analysis.passages.empty()) return panel;
    panel.layers.emplace_back(pitch_points(analysis));
    panel.layers.emplace_back(onset_ticks(sound::onset_track(analysis, most_marks), highest));
    return panel;
}

// the loudest passage on its own time axis
drawing::Panel impulses_panel(const SoundAnalysis& analysis) {
    drawing::Panel panel = panel_over_time(analysis, 4);
    panel.frame = drawing::Frame::closed;
    panel.grid = drawing::Grid::none;
    panel.title = drawing::StyledText("the loudest passage through frames of 5 ms, in the same colours");
    panel.x.range = excerpt_of(analysis);
    panel.x.text = drawing::AxisText::shown;
    panel.x.label = "time";
    panel.x.unit = "s";
    const double highest = static_cast<double>(analysis.impulses.rows) * analysis.impulses.row;
    panel.y.label = "frequency";
    panel.y.unit = "Hz";
    panel.y.range = with_band(highest);
    panel.layers.emplace_back(spectrogram_cells(analysis.impulses, highest, {720, 50}));
    std::vector<double> instants;
    for (const sound::Passage& passage : analysis.passages)
        for (const double instant : passage.onsets.instants)
            if (instant >= panel.x.range.from && instant <= panel.x.range.to) instants.push_back(instant);
    panel.layers.emplace_back(onset_ticks(instants, highest));
    return panel;
}

drawing::Panel category_panel(const SoundAnalysis& analysis, const RecordingVerdict& verdict) {
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

// one scale for both spectrograms, so that a colour is a level
void set_colours(drawing::Scene& scene, const std::string& unit) {
    std::vector<drawing::ValueCells*> graphs;
    double top = -std::numeric_limits<double>::infinity();
    for (drawing::Panel& panel : scene.panels)
        for (drawing::Layer& layer : panel.layers)
            if (auto* cells = std::get_if<drawing::ValueCells>(&layer)) {
                graphs.push_back(cells);
                top = std::max(top, cells->colours.range.to);
            }
    for (drawing::ValueCells* cells : graphs)
        cells->colours.range = {top - spectrogram_depth, top};
    // beside the first of two
    const std::optional<std::size_t> row = graphs.size() > 1 ? std::optional<std::size_t>(2) : std::nullopt;
    if (!graphs.empty())
        scene.colour_bar =
            drawing::ColourBar{"level per hertz", signal::level_unit(unit), graphs.front()->colours, row};
}

std::vector<drawing::StyledText> caption_of(const SoundAnalysis& analysis, const RecordingVerdict& verdict) {
    std::string heard = fmt::format("{:.4g} s at {:g} Hz; levels in {}; heard as {}", analysis.duration, analysis.rate,
                                    signal::level_unit(analysis.unit), classification::name(verdict.category));
    if (verdict.passages.empty()) return {drawing::StyledText(heard)};
    std::vector<drawing::StyledText> caption;
    for (const std::string& reason : verdict.reasons)
        heard += "; " + reason;
    caption.emplace_back(heard);
    if (const classification::SoundSegment* loudest = verdict.loudest())
        for (const std::string& reason : loudest->verdict.reasons)
            caption.emplace_back(reason);
    return caption;
}

void add_track_legend(drawing::Scene& scene) {
    drawing::Points pitch;
    pitch.colour = pitch_colour;
    pitch.diameter = 3.0;
    scene.legend.push_back({drawing::StyledText("strongest tone"), pitch});
    scene.legend.push_back({drawing::StyledText("onset"), drawing::Stroke{drawing::ink, 0.8, drawing::Dash::solid}});
}

}  // namespace

drawing::Scene sound(const SoundAnalysis& analysis, const RecordingVerdict& verdict) {
    drawing::Scene scene;
    scene.title = analysis.name.empty() ? drawing::StyledText("Recording") : drawing::StyledText(analysis.name);
    scene.caption = caption_of(analysis, verdict);
    scene.height = height_by_the_rules;
    scene.row_heights = {1.0, 0.8, 1.8, 0.22};
    scene.panels.push_back(waveform_panel(analysis));
    scene.panels.push_back(level_panel(analysis));
    scene.panels.push_back(harmonics_panel(analysis));
    scene.panels.push_back(category_panel(analysis, verdict));
    scene.legend = category_legend({&verdict});
    if (!analysis.passages.empty()) add_track_legend(scene);
    if (has_cells(analysis.impulses)) {
        scene.height = height_by_the_ear;
        scene.row_heights.push_back(1.8);
        scene.panels.push_back(impulses_panel(analysis));
    }
    set_colours(scene, analysis.unit);
    return scene;
}

}  // namespace stridor::pictures
