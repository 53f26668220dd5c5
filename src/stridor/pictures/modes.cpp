#include "stridor/pictures/modes.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/parts/field_axis.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

using analysis::SlidingMode;
using analysis::SlidingModes;

constexpr drawing::Colour feeding{0xBB, 0x55, 0x66};  // what adds to the growth
constexpr drawing::Colour taking{0x00, 0x66, 0x99};   // what takes from it
constexpr double half_bar = 0.4;                      // [1] of a contact's bar
constexpr double least_drawn = 0.01;                  // [1] share of energy below which a free mode is left out

drawing::Panel contact_panel(const parameters::Case& c) {
    const std::size_t contacts = parameters::contact_count(c);
    drawing::Panel panel;
    panel.x.label = "contact";
    panel.x.range = {0.5, static_cast<double>(contacts) + 0.5};
    for (std::size_t k = 0; k < contacts; ++k)
        panel.x.ticks.push_back({static_cast<double>(k + 1), parameters::contact_name(c, k), drawing::TickSize::major});
    return panel;
}

drawing::Rule zero_line() {
    return {0.0, drawing::Orientation::horizontal, {drawing::quiet_ink, 0.5, drawing::Dash::solid}};
}

// along the surface, the largest of all contacts being 1
drawing::Panel motion_panel(const parameters::Case& c, const model::Structure& structure, const SlidingMode& mode) {
    drawing::Panel panel = contact_panel(c);
    panel.y.label = "motion along";
    panel.y.unit = "1";
    panel.y.range = {-1.15, 1.15};
    std::vector<std::complex<double>> motion;
    std::complex<double> largest = 0.0;
    for (const model::ContactPoint& contact : structure.contacts) {
        motion.push_back(contact.tangent.cast<std::complex<double>>().dot(mode.shape));
        if (std::abs(motion.back()) > std::abs(largest)) largest = motion.back();
    }
    drawing::Line real{{}, {}, {drawing::ink, 1.2, drawing::Dash::solid}};
    drawing::Line imaginary{{}, {}, {drawing::accent, 1.0, drawing::Dash::dashed}};
    drawing::Points places{{}, {}, drawing::ink, 2.5, {}, drawing::Mark::disc, {}};
    for (std::size_t k = 0; k < motion.size(); ++k) {
        const std::complex<double> share = std::abs(largest) > 0.0 ? motion[k] / largest : 0.0;
        real.x.push_back(static_cast<double>(k + 1));
        real.y.push_back(share.real());
        imaginary.y.push_back(share.imag());
    }
    imaginary.x = places.x = real.x;
    places.y = real.y;
    drawing::Points others = places;
    others.y = imaginary.y;
    others.colour = drawing::accent;
    others.mark = drawing::Mark::diamond;
    panel.layers = {zero_line(), std::move(imaginary), std::move(others), std::move(real), std::move(places)};
    return panel;
}

// what the contacts add to the growth, and what damping takes as a line
drawing::Panel growth_panel(const parameters::Case& c, const SlidingMode& mode) {
    drawing::Panel panel = contact_panel(c);
    panel.y.label = "growth by friction";
    panel.y.unit = "1/s";
    drawing::Boxes adds{{}, {feeding, drawing::Texture::none, {}}};
    drawing::Boxes takes{{}, {taking, drawing::Texture::none, {}}};
    double low = 0.0, high = 0.0;
    for (std::size_t k = 0; k < mode.contact_growth.size(); ++k) {
        const double growth = mode.contact_growth[k];
        const double middle = static_cast<double>(k + 1);
        const drawing::Extent across{middle - half_bar, middle + half_bar};
        if (growth > 0.0) adds.boxes.push_back({across, {0.0, growth}});
        if (growth < 0.0) takes.boxes.push_back({across, {growth, 0.0}});
        low = std::min(low, growth);
        high = std::max(high, growth);
    }
    const double air = high > low ? 0.1 * (high - low) : 1.0;
    panel.y.range = {low < 0.0 ? low - air : 0.0, high + air};
    panel.layers = {std::move(adds), std::move(takes), zero_line()};
    return panel;
}

drawing::Panel share_panel_of(const SlidingModes& modes, const SlidingMode& mode) {
    drawing::Panel panel;
    panel.x.label = "frequency of the free mode";
    panel.x.unit = "Hz";
    panel.y.label = "share of energy";
    panel.y.unit = "1";
    panel.y.range = {0.0, 1.05};
    double highest = 0.0;
    for (std::size_t k = 0; k < mode.energy_shares.size(); ++k)
        if (mode.energy_shares[k] >= least_drawn) highest = std::max(highest, modes.free_frequencies[k]);
    const double end = highest > 0.0 ? 1.1 * highest : 1.0;
    panel.x.range = {0.0, end};
    const double half = 0.012 * end;
    drawing::Boxes shares{{}, {drawing::quiet_ink, drawing::Texture::none, {}}};
    drawing::Points mac{{}, {}, drawing::white, 3.5, {}, drawing::Mark::diamond, drawing::ink};
    for (std::size_t k = 0; k < mode.energy_shares.size(); ++k) {
        const double frequency = modes.free_frequencies[k];
        if (mode.energy_shares[k] < least_drawn) continue;
        shares.boxes.push_back({{frequency - half, frequency + half}, {0.0, mode.energy_shares[k]}});
        mac.x.push_back(frequency);
        mac.y.push_back(mode.mac[k]);
    }
    panel.layers = {std::move(shares), std::move(mac)};
    return panel;
}

const analysis::DirectionScan& faster(const analysis::StabilityScan& scan) {
    const auto growth = [](const analysis::DirectionScan& direction) {
        STRIDOR_EXPECT(direction.modes);
        return direction.modes->modes.empty() ? -HUGE_VAL : direction.modes->modes.front().eigenvalue.real();
    };
    return *std::max_element(scan.directions.begin(), scan.directions.end(),
                             [&](const auto& a, const auto& b) { return growth(a) < growth(b); });
}

drawing::Scene scene_of(const parameters::Case& c, parameters::Direction direction, std::size_t columns) {
    drawing::Scene scene;
    scene.title = c.title.empty() ? drawing::StyledText("Modes of steady sliding") : drawing::StyledText(c.title);
    scene.caption = {
        drawing::StyledText(fmt::format("Modes of steady sliding, {}. What friction and damping add is the growth.",
                                        parameters::direction_names[static_cast<std::size_t>(direction)]))};
    scene.height = 150.0;
    scene.column_widths.assign(columns, 1.0);
    scene.row_heights = {1.0, 1.0, 1.0};
    scene.legend = {{"real part", drawing::Stroke{drawing::ink, 1.2, drawing::Dash::solid}},
                    {"imaginary part", drawing::Stroke{drawing::accent, 1.0, drawing::Dash::dashed}},
                    {"adds to the growth", drawing::Fill{feeding, drawing::Texture::none, {}}},
                    {"takes from it", drawing::Fill{taking, drawing::Texture::none, {}}},
                    {"MAC", drawing::Points{{}, {}, drawing::white, 3.5, {}, drawing::Mark::diamond, drawing::ink}}};
    return scene;
}

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

drawing::Scene mode_shapes(const analysis::StabilityScan& scan) {
    const analysis::DirectionScan& direction = faster(scan);
    const SlidingModes& modes = *direction.modes;
    if (modes.modes.empty())
        base::refuse("this case has no modes of steady sliding",
                     "it locks both ways, or its closed contacts leave no motion free", "");
    const model::Structure structure = model::structure_of(scan.base);
    const std::size_t columns = std::min(most_mode_shapes, modes.modes.size());
    drawing::Scene scene = scene_of(scan.base, direction.direction, columns);
    for (std::size_t column = 0; column < columns; ++column) {
        const SlidingMode& mode = modes.modes[column];
        std::vector<drawing::Panel> panels{motion_panel(scan.base, structure, mode), growth_panel(scan.base, mode),
                                           share_panel_of(modes, mode)};
        panels[0].title = lettered(column, fmt::format("{:.1f} Hz, {:+.1f} 1/s", mode.eigenvalue.imag() / base::two_pi,
                                                       mode.eigenvalue.real()));
        panels[1].title = drawing::StyledText(fmt::format("damping {:+.1f} 1/s", mode.damping_growth));
        for (std::size_t row = 0; row < panels.size(); ++row) {
            panels[row].row = row;
            panels[row].column = column;
            if (column > 0) panels[row].y.label = {};
            scene.panels.push_back(std::move(panels[row]));
        }
    }
    return scene;
}

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
