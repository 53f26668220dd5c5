#include "stridor/pictures/side_by_side.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/contact_states.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/pictures/parts/sound_panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

using classification::ComparedFigure;
using classification::ComparedSound;

// rows of panels from the top, with their heights [mm]
enum ComparedRow : std::size_t { waveform, spectrogram, category, detail, states, figures, rows };
constexpr std::array<double, rows> heights{22.0, 40.0, 4.5, 22.0, 15.0, 38.0};

constexpr double column_width = 52.0;  // [mm] with what parts it from the next
constexpr std::array<std::string_view, 7> told{"frequency",  "tonality", "regularity",      "movement",
                                               "abruptness", "kurtosis", "impulse_interval"};

drawing::Panel panel_at(std::size_t row, std::size_t column) {
    drawing::Panel panel;
    panel.row = row;
    panel.column = column;
    panel.x.text = drawing::AxisText::hidden;
    if (column > 0) panel.y.text = drawing::AxisText::hidden;
    return panel;
}

double greatest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

// on the sound's own scale
drawing::Line scaled(drawing::Line line) {
    const double most = greatest(line.y);
    for (double& value : line.y)
        value = most > 0.0 ? value / most : 0.0;
    return line;
}

// in the middle of a panel that has nothing to show
drawing::Note remark(const char* text) {
    drawing::Note note;
    note.text = text;
    note.x = note.y = 0.5;
    note.anchor = drawing::Anchor::panel;
    note.align = drawing::Align::centre;
    note.colour = drawing::quiet_ink;
    return note;
}

void set_amplitude_axis(drawing::Panel& panel) {
    panel.grid = drawing::Grid::both;
    panel.y.label = "signal";
    panel.y.range = {-1.1, 1.1};
    panel.y.ticks = {{-1.0, "-1", drawing::TickSize::major},
                     {0.0, "0", drawing::TickSize::major},
                     {1.0, "1", drawing::TickSize::major}};
}

drawing::Extent detail_range(const ComparedSound& sound) {
    const double length = sound.detail.signal.samples.empty() ? 0.0 : signal::duration(sound.detail.signal);
    return {sound.detail.from, sound.detail.from + std::max(length, 1e-6)};
}

drawing::Panel waveform_panel(const ComparedSound& sound, std::size_t column) {
    drawing::Panel panel = panel_at(waveform, column);
    set_amplitude_axis(panel);
    panel.x.range = {0.0, sound.analysis.duration};
    panel.title = fmt::format("{}) {}", static_cast<char>('a' + column), sound.label);
    panel.layers.emplace_back(drawing::Boxes{{{detail_range(sound), panel.y.range}},
                                             {drawing::highlight, drawing::Texture::none, drawing::ink}});
    panel.layers.emplace_back(scaled(waveform_line(sound.analysis)));
    return panel;
}

drawing::Panel spectrogram_panel(const ComparedSound& sound, std::size_t column, double highest) {
    drawing::Panel panel = panel_at(spectrogram, column);
    panel.frame = drawing::Frame::closed;
    panel.x.range = {0.0, sound.analysis.duration};
    panel.y.label = "frequency";
    panel.y.unit = "Hz";
    panel.y.range = {0.0, highest};
    if (is_silent(sound.profile) || sound.analysis.spectrogram.columns() == 0) {
        panel.layers.emplace_back(remark("nothing to be heard"));
        return panel;
    }
    drawing::ValueCells cells = spectrogram_cells(sound.analysis.spectrogram, highest);
    const double strongest = *std::max_element(cells.values.begin(), cells.values.end());
    for (double& value : cells.values)
        value -= strongest;
    cells.colours = {{-spectrogram_depth, 0.0}, drawing::AxisScale::linear};
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

drawing::Panel category_panel(const ComparedSound& sound, std::size_t column) {
    drawing::Panel panel = panel_at(category, column);
    panel.frame = drawing::Frame::closed;
    panel.x.text = drawing::AxisText::shown;
    panel.x.label = "time";
    panel.x.unit = "s";
    panel.x.range = {0.0, sound.analysis.duration};
    panel.y.range = {0.0, 1.0};
    panel.y.ticks = {{0.5, "by ear", drawing::TickSize::major}};
    panel.layers = segment_layers(sound.heard, sound.analysis.duration);
    return panel;
}

// [ms] from its beginning
drawing::Panel detail_panel(const ComparedSound& sound, std::size_t column) {
    drawing::Panel panel = panel_at(detail, column);
    set_amplitude_axis(panel);
    const drawing::Extent range = detail_range(sound);
    panel.x.range = {0.0, 1e3 * (range.to - range.from)};
    drawing::Line line;
    line.stroke = {drawing::accent, 0.6, drawing::Dash::solid};
    line.y = sound.detail.signal.samples;
    for (std::size_t k = 0; k < line.y.size(); ++k)
        line.x.push_back(1e3 * static_cast<double>(k) / sound.detail.signal.rate);
    panel.layers.emplace_back(scaled(std::move(line)));
    panel.title = drawing::StyledText(fmt::format("from {:.3f} s", range.from));
    return panel;
}

bool has_states(const ComparedSound& sound) {
    return std::any_of(sound.contact.histories.begin(), sound.contact.histories.end(),
                       [](const record::ContactHistory& history) { return !history.empty(); });
}

drawing::Panel states_panel(const ComparedSound& sound, std::size_t column) {
    const drawing::Extent range = detail_range(sound);
    std::vector<record::ContactHistory> histories = sound.contact.histories;
    for (record::ContactHistory& history : histories)
        for (record::ContactInterval& interval : history) {
            interval.from = 1e3 * (interval.from - range.from);
            interval.to = 1e3 * (interval.to - range.from);
        }
    drawing::Panel panel = state_panel(histories, {0.0, 1e3 * (range.to - range.from)});
    panel.row = states;
    panel.column = column;
    if (column > 0) panel.y.text = drawing::AxisText::hidden;
    if (has_states(sound)) return panel;
    panel.layers.clear();
    panel.layers.emplace_back(remark("contact states not known"));
    return panel;
}

void label_detail(drawing::Panel& panel) {
    panel.x.text = drawing::AxisText::shown;
    panel.x.label = "time within the detail";
    panel.x.unit = "ms";
}

std::vector<std::pair<std::string, std::string>> figure_lines(const ComparedSound& sound) {
    std::vector<std::pair<std::string, std::string>> lines;
    lines.emplace_back("by ear", classification::name(sound.heard.category));
    const classification::Verdict* phase = classification::loudest_phase(sound.contact);
    lines.emplace_back("by contact states", phase == nullptr ? "not known" : std::string(name(phase->category)));
    for (const ComparedFigure& figure : classification::compared_figures())
        if (std::find(told.begin(), told.end(), figure.name) != told.end())
            lines.emplace_back(figure.words, figure_text(figure, sound));
    return lines;
}

drawing::Panel figures_panel(const ComparedSound& sound, std::size_t column) {
    drawing::Panel panel = panel_at(figures, column);
    panel.frame = drawing::Frame::closed;
    panel.y.text = drawing::AxisText::hidden;
    // ticks beyond the frame are none
    panel.x.ticks = panel.y.ticks = {{2.0, "", drawing::TickSize::major}};
    const auto lines = figure_lines(sound);
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const double y = 1.0 - (static_cast<double>(k) + 0.75) / (static_cast<double>(lines.size()) + 0.5);
        drawing::Note head;
        head.text = lines[k].first;
        head.x = 0.03;
        head.y = y;
        head.anchor = drawing::Anchor::panel;
        head.colour = drawing::quiet_ink;
        drawing::Note value = head;
        value.text = drawing::StyledText(lines[k].second, k < 2 ? drawing::TextStyle::bold : drawing::TextStyle::plain);
        value.x = 0.97;
        value.align = drawing::Align::right;
        value.colour = drawing::ink;
        panel.layers.emplace_back(std::move(head));
        panel.layers.emplace_back(std::move(value));
    }
    return panel;
}

std::string caption_of(std::span<const ComparedSound> sounds) {
    std::string text;
    for (std::size_t k = 0; k < sounds.size(); ++k) {
        const ComparedSound& sound = sounds[k];
        text += fmt::format("{}{}) {}{}{}", k == 0 ? "" : "; ", static_cast<char>('a' + k), sound.origin,
                            sound.what.empty() ? "" : ", ", sound.what);
    }
    return text + ". Each on its own scale of amplitude and time; levels re its own strongest.";
}

}  // namespace

drawing::Scene side_by_side(std::span<const ComparedSound> sounds) {
    drawing::Scene scene;
    scene.title = "Sounds side by side";
    scene.caption = {drawing::StyledText(caption_of(sounds))};
    scene.row_heights.assign(heights.begin(), heights.end());
    scene.column_widths.assign(sounds.size(), 1.0);
    double highest = 2000.0;
    for (const ComparedSound& sound : sounds)
        if (!is_silent(sound.profile)) highest = std::max(highest, highest_frequency(sound.analysis.spectrum));
    const bool is_known = std::any_of(sounds.begin(), sounds.end(), has_states);
    if (!is_known) scene.row_heights[states] = 0.01;
    std::vector<const classification::RecordingVerdict*> verdicts;
    for (std::size_t k = 0; k < sounds.size(); ++k) {
        const ComparedSound& sound = sounds[k];
        verdicts.push_back(&sound.heard);
        scene.panels.push_back(waveform_panel(sound, k));
        scene.panels.push_back(spectrogram_panel(sound, k, highest));
        scene.panels.push_back(category_panel(sound, k));
        scene.panels.push_back(detail_panel(sound, k));
        if (is_known) scene.panels.push_back(states_panel(sound, k));
        label_detail(scene.panels.back());
        scene.panels.push_back(figures_panel(sound, k));
    }
    scene.legend = category_legend(verdicts);
    scene.colour_bar = drawing::ColourBar{"level per hertz", "dB", {{-spectrogram_depth, 0.0}}, spectrogram};
    scene.width = std::max(120.0, 34.0 + column_width * static_cast<double>(sounds.size()));
    scene.height = is_known ? 205.0 : 185.0;
    return scene;
}

}  // namespace stridor::pictures
