#include "stridor/pictures/contact_states.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <algorithm>
#include <array>

namespace stridor::pictures {

drawing::Panel state_panel(std::span<const record::ContactHistory> histories, const drawing::Extent& time) {
    using model::ContactState;
    drawing::Panel panel;
    panel.frame = drawing::Frame::open;
    panel.x.label = drawing::StyledText("time ") + drawing::symbol("t");
    panel.x.unit = "s";
    panel.x.range = time;
    panel.y.range = {0.0, static_cast<double>(model::contact_states * std::max<std::size_t>(1, histories.size()))};
    drawing::Strip strip;
    for (std::size_t contact = 0; contact < std::max<std::size_t>(1, histories.size()); ++contact) {
        // the only contact needs no number
        const std::string number = histories.size() > 1 ? " " + std::to_string(contact + 1) : "";
        const std::size_t first = contact * model::contact_states;
        for (const ContactState state : {ContactState::slip, ContactState::stick, ContactState::separation}) {
            const std::size_t row = model::index_of(state);
            panel.y.ticks.push_back({static_cast<double>(first + row) + 0.5,
                                     std::string(model::contact_state_names[row]) + number, drawing::TickSize::major});
            strip.rows.push_back(state_colour(state));
        }
        if (contact == histories.size()) break;
        for (const record::ContactInterval& interval : histories[contact])
            strip.intervals.push_back({interval.from, interval.to, first + model::index_of(interval.state)});
    }
    panel.layers.emplace_back(std::move(strip));
    return panel;
}

drawing::Scene contact_states(std::span<const StatesOfCase> cases, const drawing::Extent& time) {
    constexpr std::array<std::string_view, 5> told{"joint.incidence_angle", "contact.kinetic_friction",
                                                   "contact.static_friction", "contact.preload", "drive.velocity"};
    drawing::Scene scene;
    scene.title = "Contact states over time";
    scene.caption = {"Pale lines: states shorter than their line is wide."};
    scene.row_heights.assign(std::max<std::size_t>(1, cases.size()), 1.0);
    scene.height = 28.0 + 23.0 * static_cast<double>(cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) {
        drawing::Panel panel = state_panel(cases[i].histories, time);
        panel.title = lettered(i, drawing::StyledText(cases[i].name) + ": " + settings(cases[i].c, told));
        panel.row = i;
        // the time axis stands once, below all
        if (i + 1 < cases.size()) panel.x.text = drawing::AxisText::hidden;
        scene.panels.push_back(std::move(panel));
    }
    return scene;
}

}  // namespace stridor::pictures
