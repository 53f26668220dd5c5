#include "stridor/console/results/case_text.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/contact/contact_compliance.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/model/laws/spring.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_spring.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <vector>

namespace stridor::console {

namespace {

std::string temperature_table_text(const parameters::Case& c) {
    std::string text = fmt::format("{:<20} = {}\n", "at", fmt::join(parameters::node_texts(c), ", "));
    for (const parameters::TemperatureColumn& column : c.temperature.columns)
        text += fmt::format("{:<20} = {}\n", column.key, fmt::join(parameters::value_texts(column), ", "));
    return text;
}

std::string field_line(parameters::CaseView at, const parameters::Field& field) {
    const std::string symbol = field.symbol.empty() ? "" : std::string(field.symbol) + ": ";
    std::string value = parameters::value_text(at, field);
    if (parameters::damping_ratio(at, field))
        value = fmt::format("{:.6g} {} ({})", parameters::get_quantity(at, field), parameters::unit_of(field), value);
    if (parameters::temperature_column(at, field) != nullptr) value += ", over temperature";
    if (parameters::follows_pair(at, field)) value += ", of contact.pair";
    return fmt::format("{:<20} = {:<16} ", field.name, value) +
           styled("# " + symbol + std::string(field.sentence), Style::dim, STDOUT_FILENO) + "\n";
}

// joint by joint, then what they share
std::string fields_text(const parameters::Case& c) {
    std::string text, title;
    for (const auto& [field, at, key] : parameters::fields_of(c)) {
        if (!field.belongs(at) || field.section.empty()) continue;
        const bool is_of_one = parameters::has_key_of_joint(c, field) && field.section == "joint";
        const std::string whose = is_of_one ? parameters::joint_name(c, at.joint) : "";
        const std::string opening = (whose.empty() ? "" : styled(whose, Style::bold, STDOUT_FILENO) + "\n") + "[" +
                                    std::string(field.section) + "]\n";
        if (opening != title) text += (text.empty() ? "" : "\n") + opening;
        title = opening;
        text += field_line(at, field);
        if (field.section == "temperature") text += temperature_table_text(c);
    }
    return text;
}

// an own structure has more than a line holds
constexpr std::size_t most_shown = 6;

std::string frequencies_text(const parameters::Case& c, const model::Structure& structure) {
    using model::ContactState;
    const auto row = [&](const char* name, ContactState state) {
        std::string text = fmt::format("{:<26}", name);
        const std::vector<double> all = model::natural_frequencies(structure, state);
        const std::size_t shown = parameters::has_plate(c) ? all.size() : std::min(all.size(), most_shown);
        for (std::size_t k = 0; k < shown; ++k)
            text += fmt::format("{:10.2f} Hz", all[k] / base::two_pi);
        return text + (shown < all.size() ? fmt::format(" ... {:.4g} Hz", all.back() / base::two_pi) : "") + "\n";
    };
    return row("sliding, mu = 0", ContactState::slip) + row("sticking", ContactState::stick) +
           row(parameters::has_plate(c) ? "separation (plate, joint)" : "separation", ContactState::separation);
}

std::string contacts_text(const parameters::Case& c, const model::Structure& structure) {
    TextTable table{{left("contact", 16), right("preload", 12), right("gap", 10), right("mu_d", 8), right("mu_s", 8),
                     right("drive", 8)}};
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const parameters::Contact laws = parameters::contact_of(c, k);
        const model::ContactPoint& contact = structure.contacts[k];
        // f0 = - sum of n N0 at rest: what presses this one is known where its preload is
        const std::string pressed =
            parameters::is_preloaded(c) ? fmt::format("{:.4g} N", laws.preload) : std::string("-");
        add_row(table, base::visible(parameters::contact_name(c, k)), pressed,
                fmt::format("{:.3g} m", contact.initial_gap), fmt::format("{:g}", laws.kinetic_friction),
                fmt::format("{:g}", laws.static_friction), fmt::format("{:g}", contact.drive_share));
    }
    return fmt::format("\n{}: {} rows\n", base::visible(parameters::origin_of(c)), parameters::coordinate_count(c)) +
           text_of(table) + "\n";
}

// springs that are not linear, as they are at rest
std::string springs_text(const parameters::Case& c, const model::Structure& structure) {
    if (structure.springs.empty()) return "";
    TextTable table{{left("spring", 16), right("deflection", 12), right("force", 12), right("slope", 14)}};
    const std::vector<std::string> names = parameters::names_of_springs(c);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const model::Spring& spring = structure.springs[k];
        add_row(table, base::visible(names[k]), fmt::format("{:.4g} m", spring.rest),
                fmt::format("{:.4g} N", force_of(spring.law, spring.rest)),
                fmt::format("{:.4g} N/m", stiffness_of(spring.law, spring.rest)));
    }
    return text_of(table) + "\n";
}

// [1] below it is rounding
constexpr double least_shared = 1e-12;

// can several contacts be believed?
std::string belief_text(const parameters::Case& c, const model::Structure& structure) {
    if (structure.contacts.size() < 2) return "";
    if (parameters::is_without_inertia(c)) return "\ncontacts have no inertia: no impacts, none throws another off\n";
    const Eigen::MatrixXd compliance = model::contact_compliance(structure);
    const model::SharedInertia shared = model::most_shared_inertia(compliance);
    const model::NormalGiving giving = model::least_normal_giving(structure, compliance);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < structure.contacts.size(); ++k)
        names.push_back(base::visible(parameters::contact_name(c, k)));
    std::string text = "\ncontacts\n";
    text += shared.share > least_shared ? fmt::format("inertia that {} and {} share: {:.2g} of their own\n",
                                                      names[shared.first], names[shared.second], shared.share)
                                        : "no two contacts share inertia\n";
    text += fmt::format("friction takes at most {:.2g} of what a normal force parts (1: Painleve), at {}\n",
                        1.0 - giving.share, names[giving.contact]);
    for (const base::Problem& doubt : model::doubts(structure, names))
        text += fmt::format("doubt: {} ({}). {}\n", doubt.what, doubt.why, doubt.suggestion);
    return text;
}

// friction that may add energy, of each law once
std::string friction_doubts(const model::Structure& structure) {
    std::string text;
    for (std::size_t k = 0; k < structure.contacts.size(); ++k) {
        const model::FrictionLaw& law = structure.contacts[k].friction;
        const auto is_same = [&](const model::ContactPoint& other) { return other.friction == law; };
        const auto first = std::find_if(structure.contacts.begin(), structure.contacts.end(), is_same);
        const std::optional<base::Problem> doubt = doubt_of(law);
        if (doubt && static_cast<std::size_t>(first - structure.contacts.begin()) == k)
            text += fmt::format("\ndoubt: {} ({}). {}\n", doubt->what, doubt->why, doubt->suggestion);
    }
    return text;
}

std::string cost_text(const parameters::Case& c, const integration::Cost& cost) {
    const std::string seconds = fmt::format("about {:.2g} s of one core", cost.seconds);
    if (parameters::engine_of(c) == parameters::Engine::exact)
        return fmt::format("\ncost: {:.3g} steps and the events, {}\n", cost.steps, seconds);
    return fmt::format("\ncost: {:.3g} steps at {:g} s and {:g} s, {}; largest {}step {:.4g} s\n", cost.steps,
                       c.run.step, 2.0 * c.run.step, seconds,
                       parameters::engine_of(c) == parameters::Engine::moreau ? "" : "stable ", cost.step_limit);
}

using Nodes = std::unordered_set<std::string_view>;

std::string set_text(const reduction::ElasticPart& part, const Nodes& with_rows) {
    std::string text;
    for (const reduction::NodeSet& set : part.sets) {
        const Nodes nodes(set.nodes.begin(), set.nodes.end());
        std::size_t free = 0;
        for (const std::string_view node : nodes)
            free += with_rows.count(node);
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", set.name, nodes.size());
        if (free != nodes.size()) text += fmt::format(" ({} with rows)", free);
    }
    return text;
}

// what is rounding depends on the machine
std::string statics_text(const std::optional<double>& error) {
    constexpr double rounding = 1e-11;
    if (!error) return "the part is free: it has no flexibility";
    if (*error < rounding) return "flexibility of the boundary as of the full part";
    return fmt::format("flexibility of the boundary within {:.0e}", *error);
}

// in percent; what rounding leaves is none
double shown_error(double error) {
    constexpr double shown = 0.5e-6;
    return std::abs(error) < shown ? 0.0 : 100.0 * error;
}

}  // namespace

std::string case_text(const parameters::Case& c, const integration::Cost& cost) {
    const model::Structure structure = model::structure_of(c);
    return styled(c.title.empty() ? "case" : c.title, Style::bold, STDOUT_FILENO) + "\n\n" + fields_text(c) +
           (parameters::has_plate(c) ? "\n" : contacts_text(c, structure)) + springs_text(c, structure) +
           "undamped natural frequencies\n" + frequencies_text(c, structure) + belief_text(c, structure) +
           friction_doubts(structure) + cost_text(c, cost);
}

std::string part_text(const reduction::ElasticPart& part, const reduction::PartSize& size) {
    Nodes nodes;
    for (const reduction::RowLabel& label : part.labels)
        if (label.component != 0) nodes.insert(label.node);
    std::string text = fmt::format("rows         {} of {} nodes, {} entries of stiffness{}\n", size.rows, nodes.size(),
                                   size.entries, part.damping.rows() != 0 ? ", with damping" : "");
    text += fmt::format("mass         {:.6g} kg along x, {:.6g} kg along y, {:.6g} kg along z\n", size.mass[0],
                        size.mass[1], size.mass[2]);
    if (size.extent)
        text += fmt::format("extent       {:.6g} x {:.6g} x {:.6g} m\n", (*size.extent)[0], (*size.extent)[1],
                            (*size.extent)[2]);
    if (!part.sets.empty()) text += "node sets    " + set_text(part, nodes) + "\n";
    return text;
}

std::string vibration_text(const reduction::PartVibration& vibration) {
    std::string text =
        "rigid body   " + counted(static_cast<std::size_t>(vibration.rigid_body_modes), "mode", "modes") + "\n";
    text += fmt::format("frequencies  {:.6g} Hz\n", fmt::join(vibration.frequencies, ", "));
    text += std::isfinite(vibration.highest_frequency)
                ? fmt::format("highest      {:.4g} Hz\n", vibration.highest_frequency)
                : std::string("highest      none: some motion has no mass\n");
    return text;
}

std::string part_contacts_text(const reduction::PartContacts& contacts) {
    constexpr double shown = 1e-9;
    std::string text = fmt::format("contact      {} rows; ", contacts.rows);
    text += contacts.shared_inertia < shown
                ? std::string("no inertia is shared\n")
                : fmt::format("{} and {} share {:.2g} of their inertia\n", describe(contacts.first),
                              describe(contacts.second), contacts.shared_inertia);
    if (!contacts.painleve_friction) return text;
    if (!(*contacts.painleve_friction < 1.0 / shown)) return text + "friction     never presses a contact together\n";
    return text + fmt::format("friction     presses {} together from mu = {:.3g} on (Painleve)\n",
                              describe(contacts.weakest), *contacts.painleve_friction);
}

std::string reduction_text(const reduction::Reduction& reduction, const reduction::ReductionErrors& errors) {
    const std::vector<double>& modes = reduction.mode_frequencies;
    std::string text = fmt::format("boundary     {} rows\n", reduction.boundary_rows);
    const bool is_free = reduction.method == reduction::ReductionMethod::macneal;
    text += modes.empty() ? std::string("modes        none\n")
                          : fmt::format("modes        {} from {:.6g} to {:.6g} Hz with the boundary {}\n", modes.size(),
                                        modes.front(), modes.back(), is_free ? "free" : "held");
    text += reduction.inertia == reduction::BoundaryInertia::massless
                ? std::string("inertia      none: the boundary follows at once\n")
                : fmt::format("inertia      {}: neighbours are coupled by {:.2g} of their own\n",
                              name_of(reduction.inertia), errors.coupling < 1e-9 ? 0.0 : errors.coupling);
    if (reduction.solver == reduction::LinearSolver::mumps)
        text += "solver       MUMPS: its last digits are this machine's\n";
    text += "statics      " + statics_text(errors.flexibility) + "\n";
    TextTable table{{left("contacts", 9), right("frequency", 13), right("reduced", 13), right("error ", 13)}};
    for (const reduction::StateErrors& state : errors.states)
        for (const reduction::FrequencyPair& pair : state.frequencies)
            add_row(table, state.name, fmt::format("{:.2f} Hz", pair.full), fmt::format("{:.2f} Hz", pair.reduced),
                    fmt::format("{:+.4f} %", shown_error(relative_error(pair))));
    return text + "\n" + text_of(table) + "\n";
}

}  // namespace stridor::console
