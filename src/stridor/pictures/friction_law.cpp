#include "stridor/pictures/friction_law.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/model/laws/rest.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::pictures {

namespace {

constexpr std::size_t curve_points = 241;           // of a law that changes with the slip velocity
constexpr std::array rest_times{1.0, 10.0, 100.0};  // [1] of t_0, for which it has stuck

// of one way to slip, as drawn: V_rel > 0 is a plate that goes
struct LawBranch {
    double sign;
    double limit;                 // [1] of the stick
    std::vector<double> speeds;   // rising from 0, up to the edge of the picture
    std::vector<double> sliding;  // [1] there
    const char* limit_symbol;
    const char* sliding_symbol;
};

// [m/s] at the edge of the picture
double edge_of(const parameters::Contact& contact) {
    switch (contact.friction) {
        case parameters::FrictionKind::stribeck:
        case parameters::FrictionKind::stribeck_rational:
        case parameters::FrictionKind::lugre:
            return 10.0 * contact.stribeck_velocity;
        case parameters::FrictionKind::table:
            return contact.friction_table.speeds.empty() ? 1.0 : contact.friction_table.speeds.back();
        case parameters::FrictionKind::dieterich:
        case parameters::FrictionKind::ruina:
            return 10.0 * contact.reference_velocity;
        case parameters::FrictionKind::tanh:
        case parameters::FrictionKind::arctan:
            return 10.0 * contact.regularisation;
        case parameters::FrictionKind::coulomb:
        case parameters::FrictionKind::directional:
        case parameters::FrictionKind::linear:
            break;
    }
    return 1.0;
}

drawing::StyledText named(double sign, std::string_view name, double value) {
    const char* const minus = sign < 0.0 ? "−" : "";
    return drawing::StyledText(minus) + drawing::symbol(name) + " = " + drawing::StyledText(minus) +
           drawing::number_text(value);
}

void add_branch(drawing::Panel& panel, const LawBranch& branch, double top) {
    const double x = branch.sign, s = branch.sign * branch.limit, d = branch.sign * branch.sliding.front();
    const double edge = branch.speeds.back();
    if (branch.limit > branch.sliding.front())
        panel.y.ticks.push_back({s, named(x, branch.limit_symbol, branch.limit), drawing::TickSize::major});
    if (branch.sliding_symbol != nullptr)
        panel.y.ticks.push_back({d, named(x, branch.sliding_symbol, branch.sliding.front()), drawing::TickSize::major});
    drawing::Line line{branch.speeds, branch.sliding, {drawing::accent, 1.6, drawing::Dash::solid}};
    for (std::size_t k = 0; k < line.x.size(); ++k) {
        line.x[k] *= x;
        line.y[k] *= x;
    }
    if (x < 0.0) {
        std::reverse(line.x.begin(), line.x.end());
        std::reverse(line.y.begin(), line.y.end());
    }
    const double middle = branch.sign * branch.sliding[branch.sliding.size() / 2];
    panel.layers.emplace_back(std::move(line));
    panel.layers.emplace_back(drawing::Note{"slip", 0.5 * x * edge, middle - 0.1 * x * top, drawing::Anchor::data,
                                            drawing::Align::centre, drawing::ink, 0.0, std::nullopt});
}

// what times of rest add to the limit of the stick; nothing where rest changes nothing
void add_rest(drawing::Panel& panel, const model::RestGrowth& rest, double going_limit, double coming_limit) {
    if (!grows(rest)) return;
    const drawing::Colour colour = state_colour(model::ContactState::stick);
    for (const double sign : {1.0, -1.0}) {
        const double limit = sign > 0.0 ? going_limit : coming_limit;
        drawing::Line line{{0.0}, {sign * limit}, {colour, 1.2, drawing::Dash::dotted}};
        drawing::Points points;
        points.colour = colour;
        points.diameter = 2.6;
        for (const double times : rest_times) {
            points.x.push_back(0.0);
            points.y.push_back(sign * (limit + grown(rest, times * rest.time)));
        }
        line.x.push_back(0.0);
        line.y.push_back(points.y.back());
        panel.layers.emplace_back(std::move(line));
        panel.layers.emplace_back(std::move(points));
    }
    std::string times;
    for (const double each : rest_times)
        times += (times.empty() ? "" : ", ") + base::shortest(each * rest.time);
    panel.layers.emplace_back(drawing::Note{"rest of " + times + " s", 0.04 * panel.x.range.to,
                                            going_limit + grown(rest, rest_times.back() * rest.time),
                                            drawing::Anchor::data, drawing::Align::left, colour, 0.0, std::nullopt});
}

// contacts of an own structure may have coefficients of their own
parameters::Contact one_law_of_contacts(const parameters::Case& c) {
    const parameters::Contact first = parameters::contact_of(c, 0);
    for (std::size_t contact = 1; contact < parameters::contact_count(c); ++contact) {
        const parameters::Contact other = parameters::contact_of(c, contact);
        if (other.static_friction != first.static_friction || other.kinetic_friction != first.kinetic_friction)
            base::refuse("the contacts " + parameters::contact_name(c, 0) + " and " +
                             parameters::contact_name(c, contact) + " differ",
                         "this is the picture of one law of friction", "");
    }
    return first;
}

}  // namespace

LawCurve law_curve(const parameters::Contact& contact, std::optional<drawing::Extent> visited) {
    const model::FrictionLaw law = model::friction_law(contact);
    double edge = edge_of(contact);
    if (visited) edge = std::max({edge, 1.1 * visited->to, -1.1 * visited->from});
    LawCurve curve;
    const std::size_t points = is_state_wise(law) ? 2 : curve_points;
    for (std::size_t k = 0; k < points; ++k)
        curve.speeds.push_back(edge * static_cast<double>(k) / static_cast<double>(points - 1));
    for (const model::Slip way : model::slips) {
        const double sign = way == model::Slip::forward ? 1.0 : -1.0;
        curve.limits[index_of(way)] = stick_limit(law, way);
        for (const double speed : curve.speeds)
            curve.resistances[index_of(way)].push_back(-sign * slip_ratio(law, way, sign * speed));
    }
    return curve;
}

drawing::Scene friction_law(const parameters::Contact& contact, std::optional<drawing::Extent> visited) {
    const model::FrictionLaw law = model::friction_law(contact);
    const bool is_the_same = contact.friction != parameters::FrictionKind::directional;
    const LawCurve curve = law_curve(contact, visited);
    const double edge = curve.speeds.back();
    const auto branch = [&](model::Slip way, double sign, const char* limit, const char* sliding) {
        return LawBranch{sign,   curve.limits[index_of(way)], curve.speeds, curve.resistances[index_of(way)], limit,
                         sliding};
    };
    // a continuous curve begins with mu_s
    const bool begins_with_limit = stick_limit(law, model::Slip::backward) == slip_ratio(law, model::Slip::backward);
    const bool is_rate_and_state = std::holds_alternative<model::RateAndState>(law);
    const bool sticks = !parameters::is_regularised(contact.friction) && !is_rate_and_state;
    const char* const begin = !sticks ? nullptr : !is_state_wise(law) && begins_with_limit ? "mu_s" : "mu_d";
    const LawBranch going = branch(model::Slip::backward, 1.0, "mu_s", begin);
    const LawBranch coming =
        branch(model::Slip::forward, -1.0, is_the_same ? "mu_s" : "mu_sc", is_the_same ? begin : "mu_dc");
    double most = std::max(going.limit, coming.limit);
    for (const LawBranch* each : {&going, &coming})
        most = std::max(most, *std::max_element(each->sliding.begin(), each->sliding.end()));
    const model::RestGrowth rest = model::rest_growth(contact);
    if (grows(rest)) most += grown(rest, rest_times.back() * rest.time);
    const double top = most > 0.0 ? 1.3 * most : 1.0;
    drawing::Panel panel;
    panel.grid = drawing::Grid::none;
    panel.x.label = drawing::StyledText("relative velocity ") + drawing::symbol("V_rel") +
                    (is_state_wise(law) && !visited ? " (any unit)" : " [m/s]");
    panel.x.range = {-edge, edge};
    const bool has_numbers = !is_state_wise(law) || visited;
    if (!has_numbers) panel.x.ticks = {{0.0, "0", drawing::TickSize::major}};
    panel.y.label =
        drawing::StyledText("friction over normal force ") + drawing::symbol("T") + " / " + drawing::symbol("N");
    panel.y.unit = "1";
    panel.y.range = {-top, top};
    panel.y.ticks = {{0.0, "0", drawing::TickSize::major}};
    for (const double sign : {-1.0, 1.0})
        if (!sticks)
            panel.y.ticks.push_back({sign * contact.kinetic_friction, named(sign, "mu_d", contact.kinetic_friction),
                                     drawing::TickSize::major});
    if (visited) {
        panel.layers.emplace_back(
            drawing::Boxes{{{*visited, {-top, top}}}, {drawing::highlight, drawing::Texture::none, drawing::ink}});
        panel.layers.emplace_back(drawing::Note{"visited", 0.5 * (visited->from + visited->to), -0.92 * top,
                                                drawing::Anchor::data, drawing::Align::centre, drawing::quiet_ink, 0.0,
                                                std::nullopt});
    }
    const drawing::Stroke axis{drawing::grid_ink, 0.5, drawing::Dash::solid};
    const drawing::Stroke helper{drawing::quiet_ink, 0.4, drawing::Dash::dotted};
    panel.layers.emplace_back(drawing::Rule{0.0, drawing::Orientation::vertical, axis});
    panel.layers.emplace_back(drawing::Rule{0.0, drawing::Orientation::horizontal, axis});
    for (const double level : {going.limit, going.sliding.front(), -coming.limit})
        panel.layers.emplace_back(drawing::Line{{-edge, 0.0}, {level, level}, helper});
    add_branch(panel, coming, top);
    panel.layers.emplace_back(drawing::Line{{0.0, 0.0},
                                            {-coming.limit, going.limit},
                                            {state_colour(model::ContactState::stick), 1.6, drawing::Dash::solid}});
    add_branch(panel, going, top);
    add_rest(panel, rest, going.limit, coming.limit);
    // a curve that falls may lie where a level one leaves room
    const double beside = is_state_wise(law) ? 0.5 * going.sliding.front() : -0.5 * going.limit;
    if (sticks)
        panel.layers.emplace_back(drawing::Note{has_friction_state(law) ? "creep" : "stick", 0.06 * edge, beside,
                                                drawing::Anchor::data, drawing::Align::left, drawing::ink, 0.0,
                                                std::nullopt});

    drawing::Scene scene;
    scene.title = "Friction law";
    scene.width = 85.0;
    scene.height = 62.0;
    scene.panels.push_back(std::move(panel));
    return scene;
}

parameters::Contact one_law(const parameters::Case& c) {
    for (const parameters::Field& field : parameters::fields()) {
        const bool is_of_law = field.section == "contact" && field.name != "preload" && field.name != "impact" &&
                               field.name != "restitution";
        const std::string key = parameters::key_of(field);
        if (is_of_law && !parameters::has_one_value(c, key))
            base::refuse("the joints differ: " + key + " = " + parameters::value_text(c, key),
                         "this is the picture of one law of friction", "");
    }
    return one_law_of_contacts(c);
}

drawing::Scene friction_law_of(const parameters::Case& c, std::optional<drawing::Extent> visited) {
    return friction_law(one_law(c), visited);
}

std::optional<drawing::Extent> visited_velocities(const parameters::Case& c, const record::Trace& trace) {
    const std::vector<double> along = parameters::point_weights(c, 0, parameters::PointAxis::sliding);
    const double share = parameters::drive_share_at(c, 0);
    std::optional<drawing::Extent> visited;
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        if (trace.contacts.front().state[k] != model::ContactState::slip) continue;
        double velocity = share * trace.surface_velocity[k];
        for (std::size_t coordinate = 0; coordinate < along.size(); ++coordinate)
            if (along[coordinate] != 0.0) velocity -= along[coordinate] * trace.velocity[coordinate][k];
        if (!visited) visited = {velocity, velocity};
        visited->from = std::min(visited->from, velocity);
        visited->to = std::max(visited->to, velocity);
    }
    return visited;
}

}  // namespace stridor::pictures
