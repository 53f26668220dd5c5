#include "stridor/pictures/mode_shapes.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/model/case_structure.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
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

}  // namespace stridor::pictures
