#include "stridor/pictures/modal_spectrum.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

using analysis::ModalLine;
using analysis::ModalSpectrum;
using analysis::OpenModes;

constexpr drawing::Colour against{0xBB, 0x55, 0x66};  // of a mode that works against the others
constexpr double least_share = 0.05;                  // [1] of one line at least, else a mode is one of the others
constexpr double least_written = 0.005;               // [1] less is 0 %
constexpr std::size_t most_modes = 12;                // that have a row of their own
constexpr double spectrum_height = 42.0;              // [mm]
constexpr double row_of_mode = 5.5;                   // [mm]
constexpr double depth_drawn = 80.0;                  // [dB] below the highest level
constexpr double beyond_lines = 1.25;                 // [1] of the highest line's frequency

/// A row of the table: one mode, or those that are left.
struct ShareRow {
    std::string name;
    std::vector<double> shares{};  // [1] shape [line]
};

double greatest_share(const std::vector<ModalLine>& lines, std::size_t mode) {
    double most = 0.0;
    for (const ModalLine& line : lines)
        most = std::max(most, std::abs(line.shares[mode]));
    return most;
}

std::string frequency_text(double frequency) {
    if (frequency >= 1e4) return fmt::format("{:.1f} kHz", frequency / 1e3);
    if (frequency >= 100.0) return fmt::format("{:.0f} Hz", frequency);
    return fmt::format("{:.3g} Hz", frequency);
}

// the modes that matter, by rising frequency, and all others as one
std::vector<ShareRow> share_rows(const OpenModes& modes, const std::vector<ModalLine>& lines) {
    std::vector<std::size_t> chosen;
    for (std::size_t mode = 0; mode < modes.frequencies.size(); ++mode)
        if (greatest_share(lines, mode) >= least_share) chosen.push_back(mode);
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](std::size_t a, std::size_t b) { return greatest_share(lines, a) > greatest_share(lines, b); });
    chosen.resize(std::min(chosen.size(), most_modes));
    std::sort(chosen.begin(), chosen.end());
    std::vector<ShareRow> rows;
    ShareRow others{"others", std::vector<double>(lines.size(), 1.0)};
    for (const std::size_t mode : chosen) {
        ShareRow row{fmt::format("{}: {}", mode + 1, frequency_text(modes.frequencies[mode]))};
        for (std::size_t k = 0; k < lines.size(); ++k) {
            row.shares.push_back(lines[k].shares[mode]);
            others.shares[k] -= lines[k].shares[mode];
        }
        rows.push_back(std::move(row));
    }
    const bool has_others = std::any_of(others.shares.begin(), others.shares.end(),
                                        [](double share) { return std::abs(share) >= least_written; });
    if (has_others) rows.push_back(std::move(others));
    return rows;
}

drawing::Panel level_panel(const OpenModes& modes, const ModalSpectrum& spectrum, const std::vector<ModalLine>& lines) {
    drawing::Panel panel;
    panel.title = drawing::StyledText("(a) level, and free frequencies");
    panel.x.label = "frequency";
    panel.x.unit = "Hz";
    panel.x.range = {0.0, beyond_lines * lines.back().frequency};
    panel.y.label = "level";
    panel.y.unit = "dB";
    const std::vector<double> squares = signal::line_squares(spectrum.whole);
    const double reference = signal::reference_of(spectrum.whole.unit);
    drawing::Line curve{{}, {}, {drawing::accent, 0.8, drawing::Dash::solid}};
    double top = -std::numeric_limits<double>::infinity();
    for (std::size_t line = 1; line < squares.size(); ++line) {
        const double frequency = static_cast<double>(line) * spectrum.whole.spacing;
        if (frequency > panel.x.range.to) break;
        curve.x.push_back(frequency);
        curve.y.push_back(signal::level_of(std::max(squares[line], 1e-300), reference));
        top = std::max(top, curve.y.back());
    }
    const double least = *std::min_element(curve.y.begin(), curve.y.end());
    // with room for the free frequencies below
    panel.y.range = {std::max(top - depth_drawn, least - 0.15 * depth_drawn), top + 0.08 * depth_drawn};
    for (double& level : curve.y)
        level = std::max(level, panel.y.range.from);
    drawing::Points free{{}, {}, drawing::white, 3.0, {}, drawing::Mark::triangle, drawing::ink};
    for (const double frequency : modes.frequencies) {
        if (frequency > panel.x.range.to) break;
        free.x.push_back(frequency);
        free.y.push_back(panel.y.range.from + 0.04 * depth_drawn);
    }
    drawing::Points peaks{{}, {}, drawing::ink, 2.5, {}, drawing::Mark::disc, {}};
    for (const ModalLine& line : lines) {
        const auto number = static_cast<std::size_t>(std::lround(line.frequency / spectrum.whole.spacing));
        peaks.x.push_back(line.frequency);
        peaks.y.push_back(signal::level_of(squares[number], reference));
    }
    panel.layers = {std::move(curve), std::move(free), std::move(peaks)};
    return panel;
}

// the darker the more, on white; the number says it, too
void add_share(std::vector<drawing::Layer>& grounds, std::vector<drawing::Layer>& numbers, const drawing::Box& cell,
               double share) {
    if (std::abs(share) < least_written) return;
    const drawing::Colour colour =
        drawing::tint(share > 0.0 ? drawing::accent : against, std::min(std::abs(share), 1.0));
    grounds.emplace_back(drawing::Boxes{{cell}, {colour, drawing::Texture::none, drawing::ink}});
    drawing::Note note;
    note.text = drawing::StyledText(fmt::format("{:.0f}", 100.0 * share));
    note.x = 0.5 * (cell.x.from + cell.x.to);
    note.y = 0.5 * (cell.y.from + cell.y.to);
    note.align = drawing::Align::centre;
    note.colour = drawing::text_colour_on(colour);
    note.size = 7.0;
    numbers.emplace_back(std::move(note));
}

drawing::Panel share_panel(const std::vector<ShareRow>& rows, const std::vector<ModalLine>& lines) {
    drawing::Panel panel;
    panel.title = drawing::StyledText("(b) share of each free mode in the power of each line, %");
    panel.frame = drawing::Frame::closed;
    panel.x.label = "line";
    panel.x.range = {0.0, static_cast<double>(lines.size())};
    panel.y.range = {0.0, static_cast<double>(rows.size())};
    for (std::size_t k = 0; k < lines.size(); ++k)
        panel.x.ticks.push_back({static_cast<double>(k) + 0.5, drawing::StyledText(frequency_text(lines[k].frequency)),
                                 drawing::TickSize::major});
    std::vector<drawing::Layer> numbers;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        const double low = static_cast<double>(row);
        panel.y.ticks.push_back({low + 0.5, drawing::StyledText(rows[row].name), drawing::TickSize::major});
        for (std::size_t k = 0; k < lines.size(); ++k) {
            const double left = static_cast<double>(k);
            add_share(panel.layers, numbers, {{left, left + 1.0}, {low, low + 1.0}}, rows[row].shares[k]);
        }
    }
    std::move(numbers.begin(), numbers.end(), std::back_inserter(panel.layers));
    return panel;
}

}  // namespace

drawing::Scene modal_spectrum(const std::string& title, const std::string& of, const OpenModes& modes,
                              const ModalSpectrum& spectrum) {
    const std::vector<ModalLine> lines = analysis::modal_lines(spectrum);
    if (lines.empty())
        base::refuse("the " + of + " has no line in its spectrum", "it does not vibrate",
                     "Take a case that makes a noise, or a longer run.");
    const std::vector<ShareRow> rows = share_rows(modes, lines);
    drawing::Scene scene;
    scene.title = drawing::StyledText(title.empty() ? "Free modes in a spectrum" : title);
    scene.caption = {drawing::StyledText("Spectrum of the " + of +
                                         ", dB re 1 nm/s, and which modes of the structure with open contacts carry "
                                         "its lines. Shares of a line add up to 100; a negative one is of a mode that "
                                         "works against the others.")};
    const double share_height = row_of_mode * static_cast<double>(std::max<std::size_t>(rows.size(), 3));
    scene.row_heights = {spectrum_height, share_height};
    scene.height = 62.0 + spectrum_height + share_height;
    scene.panels = {level_panel(modes, spectrum, lines), share_panel(rows, lines)};
    scene.panels[1].row = 1;
    scene.legend = {
        {"free frequencies", drawing::Points{{}, {}, drawing::white, 3.0, {}, drawing::Mark::triangle, drawing::ink}},
        {"lines of (b)", drawing::Points{{}, {}, drawing::ink, 2.5, {}, drawing::Mark::disc, {}}}};
    return scene;
}

}  // namespace stridor::pictures
