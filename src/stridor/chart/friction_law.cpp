#include "stridor/chart/friction_law.hpp"

#include "stridor/chart/palette.hpp"

#include <algorithm>

namespace stridor::chart {

namespace {

Text named(std::string_view sign, std::string_view name, double value) {
    return Text(sign) + symbol(name) + " = " + Text(sign) + number_text(value);
}

}  // namespace

Scene friction_law(const parameters::Contact& contact) {
    const double s = contact.static_friction;
    const double d = contact.kinetic_friction;
    const double top = 1.3 * std::max({s, d, 1e-3});
    Panel panel;
    panel.grid = Grid::none;
    panel.x.label = Text("relative velocity ") + symbol("V_rel") + " (any unit)";
    panel.x.range = {-1.0, 1.0};
    panel.x.ticks = {{0.0, "0", TickSize::major}};
    panel.y.label = Text("friction over normal force ") + symbol("T") + " / " + symbol("N");
    panel.y.unit = "1";
    panel.y.range = {-top, top};
    panel.y.ticks = {{0.0, "0", TickSize::major}};
    if (s > d)
        for (const double sign : {-1.0, 1.0})
            panel.y.ticks.push_back({sign * s, named(sign < 0.0 ? "−" : "", "mu_s", s), TickSize::major});
    for (const double sign : {-1.0, 1.0})
        panel.y.ticks.push_back({sign * d, named(sign < 0.0 ? "−" : "", "mu_d", d), TickSize::major});

    const Stroke axis{grid_ink, 0.5, Dash::solid};
    const Stroke helper{quiet_ink, 0.4, Dash::dotted};
    panel.layers.emplace_back(Rule{0.0, Orientation::vertical, axis});
    panel.layers.emplace_back(Rule{0.0, Orientation::horizontal, axis});
    panel.layers.emplace_back(Line{{-1.0, 0.0}, {s, s}, helper});
    panel.layers.emplace_back(Line{{-1.0, 0.0}, {d, d}, helper});
    panel.layers.emplace_back(Line{{-1.0, 0.0}, {-s, -s}, helper});
    panel.layers.emplace_back(Line{{-1.0, 0.0}, {-d, -d}, {accent, 1.6, Dash::solid}});
    panel.layers.emplace_back(Line{{0.0, 0.0}, {-s, s}, {state_colour(model::ContactState::stick), 1.6, Dash::solid}});
    panel.layers.emplace_back(Line{{0.0, 1.0}, {d, d}, {accent, 1.6, Dash::solid}});
    panel.layers.emplace_back(Note{"stick", 0.06, 0.5 * d, Anchor::data, Align::left, ink, 0.0, std::nullopt});
    panel.layers.emplace_back(Note{"slip", 0.5, d - 0.1 * top, Anchor::data, Align::centre, ink, 0.0, std::nullopt});
    panel.layers.emplace_back(Note{"slip", -0.5, -d + 0.1 * top, Anchor::data, Align::centre, ink, 0.0, std::nullopt});

    Scene scene;
    scene.title = "Friction law";
    scene.width = 85.0;
    scene.height = 62.0;
    scene.panels.push_back(std::move(panel));
    return scene;
}

}  // namespace stridor::chart
