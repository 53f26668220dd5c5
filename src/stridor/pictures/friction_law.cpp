#include "stridor/pictures/friction_law.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/model/friction.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <algorithm>

namespace stridor::pictures {

namespace {

// of one way to slip, as drawn: V_rel > 0 is a plate that goes
struct LawBranch {
    double sign;
    double limit;    // [1] of the stick
    double sliding;  // [1] of a slip that begins
    double fast;     // [1] of one at the edge of the picture
    const char* limit_symbol;
    const char* sliding_symbol;
};

drawing::StyledText named(double sign, std::string_view name, double value) {
    const char* const minus = sign < 0.0 ? "−" : "";
    return drawing::StyledText(minus) + drawing::symbol(name) + " = " + drawing::StyledText(minus) +
           drawing::number_text(value);
}

void add_branch(drawing::Panel& panel, const LawBranch& branch, double top) {
    const double x = branch.sign, s = branch.sign * branch.limit, d = branch.sign * branch.sliding;
    const double fast = branch.sign * branch.fast;
    if (branch.limit > branch.sliding)
        panel.y.ticks.push_back({s, named(x, branch.limit_symbol, branch.limit), drawing::TickSize::major});
    panel.y.ticks.push_back({d, named(x, branch.sliding_symbol, branch.sliding), drawing::TickSize::major});
    panel.layers.emplace_back(drawing::Line{{std::min(x, 0.0), std::max(x, 0.0)},
                                            {x < 0.0 ? fast : d, x < 0.0 ? d : fast},
                                            {drawing::accent, 1.6, drawing::Dash::solid}});
    panel.layers.emplace_back(drawing::Note{"slip", 0.5 * x, d - 0.1 * x * top, drawing::Anchor::data,
                                            drawing::Align::centre, drawing::ink, 0.0, std::nullopt});
}

// contacts of an own structure may have coefficients of their own
parameters::Contact one_law(const parameters::Case& c) {
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

drawing::Scene friction_law(const parameters::Contact& contact) {
    const model::FrictionLaw law = model::friction_law(contact);
    const bool is_the_same = contact.friction != parameters::FrictionKind::directional;
    const auto branch = [&](model::Slip way, double sign, const char* limit, const char* sliding) {
        return LawBranch{
            sign,   stick_limit(law, way), sign * slip_ratio(law, way), sign * slip_ratio(law, way, -sign), limit,
            sliding};
    };
    const LawBranch going = branch(model::Slip::backward, 1.0, "mu_s", "mu_d");
    const LawBranch coming =
        branch(model::Slip::forward, -1.0, is_the_same ? "mu_s" : "mu_sc", is_the_same ? "mu_d" : "mu_dc");
    const double most = std::max({going.limit, coming.limit, going.sliding, coming.sliding});
    const double top = most > 0.0 ? 1.3 * most : 1.0;
    drawing::Panel panel;
    panel.grid = drawing::Grid::none;
    panel.x.label = drawing::StyledText("relative velocity ") + drawing::symbol("V_rel") +
                    (is_state_wise(law) ? " (any unit)" : " [m/s]");
    panel.x.range = {-1.0, 1.0};
    panel.x.ticks = {{0.0, "0", drawing::TickSize::major}};
    panel.y.label =
        drawing::StyledText("friction over normal force ") + drawing::symbol("T") + " / " + drawing::symbol("N");
    panel.y.unit = "1";
    panel.y.range = {-top, top};
    panel.y.ticks = {{0.0, "0", drawing::TickSize::major}};
    const drawing::Stroke axis{drawing::grid_ink, 0.5, drawing::Dash::solid};
    const drawing::Stroke helper{drawing::quiet_ink, 0.4, drawing::Dash::dotted};
    panel.layers.emplace_back(drawing::Rule{0.0, drawing::Orientation::vertical, axis});
    panel.layers.emplace_back(drawing::Rule{0.0, drawing::Orientation::horizontal, axis});
    for (const double level : {going.limit, going.sliding, -coming.limit})
        panel.layers.emplace_back(drawing::Line{{-1.0, 0.0}, {level, level}, helper});
    add_branch(panel, coming, top);
    panel.layers.emplace_back(drawing::Line{{0.0, 0.0},
                                            {-coming.limit, going.limit},
                                            {state_colour(model::ContactState::stick), 1.6, drawing::Dash::solid}});
    add_branch(panel, going, top);
    panel.layers.emplace_back(drawing::Note{"stick", 0.06, 0.5 * going.sliding, drawing::Anchor::data,
                                            drawing::Align::left, drawing::ink, 0.0, std::nullopt});

    drawing::Scene scene;
    scene.title = "Friction law";
    scene.width = 85.0;
    scene.height = 62.0;
    scene.panels.push_back(std::move(panel));
    return scene;
}

drawing::Scene friction_law_of(const parameters::Case& c) {
    for (const char* key :
         {"contact.friction", "contact.static_friction", "contact.kinetic_friction", "contact.friction_slope",
          "contact.static_friction_coming", "contact.kinetic_friction_coming"})
        if (!parameters::has_one_value(c, key))
            base::refuse("the joints differ: " + std::string(key) + " = " + parameters::value_text(c, key),
                         "this is the picture of one law of friction", "");
    return friction_law(one_law(c));
}

}  // namespace stridor::pictures
