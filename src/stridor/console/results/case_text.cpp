#include "stridor/console/results/case_text.hpp"

#include "stridor/console/terminal.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/temperature_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <numbers>

namespace stridor::console {

namespace {

// what the beta_2 loop needs for one step on a present-day core [s]; only for the estimate that is printed
constexpr double seconds_per_step = 25e-9;
// with two thousand events a second of motion
constexpr double seconds_per_exact_step = 1e-7;

std::string temperature_table_text(const parameters::Case& c) {
    std::string text = fmt::format("{:<20} = {}\n", "at", fmt::join(parameters::node_texts(c), ", "));
    for (const parameters::TemperatureColumn& column : c.temperature.columns)
        text += fmt::format("{:<20} = {}\n", column.key, fmt::join(parameters::value_texts(column), ", "));
    return text;
}

enum class Shown { all, joint, but_joint };

std::string fields_text(const parameters::Case& c, Shown shown) {
    std::string text;
    std::string_view section;
    for (const parameters::Field& field : parameters::fields()) {
        if (!field.belongs(c) || field.section.empty()) continue;
        const bool is_of_joint = parameters::is_of_joint(field);
        if (shown != Shown::all && is_of_joint != (shown == Shown::joint)) continue;
        if (field.section != section) text += (section.empty() ? "[" : "\n[") + std::string(field.section) + "]\n";
        section = field.section;
        const std::string symbol = field.symbol.empty() ? "" : std::string(field.symbol) + ": ";
        std::string value = parameters::value_text(c, field);
        if (parameters::damping_ratio(c, field))
            value =
                fmt::format("{:.6g} {} ({})", parameters::get_quantity(c, field), parameters::unit_of(field), value);
        if (parameters::temperature_column(c, parameters::key_of(field)) != nullptr) value += ", over temperature";
        text += fmt::format("{:<20} = {:<16} ", field.name, value) +
                styled("# " + symbol + std::string(field.sentence), Style::dim, STDOUT_FILENO) + "\n";
        if (field.section == "temperature") text += temperature_table_text(c);
    }
    return text;
}

// joint by joint, then what they share
std::string fields_text(const parameters::Case& c) {
    if (c.further_joints.empty()) return fields_text(c, Shown::all);
    std::string text;
    for (std::size_t k = 0; k < parameters::joint_count(c); ++k)
        text += styled(parameters::joint_name(c, k), Style::bold, STDOUT_FILENO) + "\n" +
                fields_text(parameters::alone(c, k), Shown::joint) + "\n";
    return text + fields_text(c, Shown::but_joint);
}

std::string frequencies_text(const parameters::Case& c) {
    using model::ContactState;
    const auto structure = model::rubbing_system(c);
    const auto row = [&](const char* name, ContactState state) {
        std::string text = fmt::format("{:<22}", name);
        for (const double omega : model::natural_frequencies(structure, state))
            text += fmt::format("{:10.2f} Hz", omega / (2.0 * std::numbers::pi));
        return text + "\n";
    };
    return row("sliding, mu = 0", ContactState::slip) + row("sticking", ContactState::stick) +
           row("open (plate, joint)", ContactState::separation);
}

std::string cost_text(const parameters::Case& c, const integration::Cost& cost) {
    if (c.run.engine == parameters::Engine::exact)
        return fmt::format("\ncost: {:.3g} steps and the events, about {:.2g} s of one core\n", cost.steps,
                           cost.steps * seconds_per_exact_step);
    return fmt::format("\ncost: {:.3g} steps, about {:.2g} s of one core; largest stable step {:.4g} s\n", cost.steps,
                       cost.steps * seconds_per_step, cost.step_limit);
}

}  // namespace

std::string case_text(const parameters::Case& c, const integration::Cost& cost) {
    return styled(c.title.empty() ? "case" : c.title, Style::bold, STDOUT_FILENO) + "\n\n" + fields_text(c) + "\n" +
           "undamped natural frequencies\n" + frequencies_text(c) + cost_text(c, cost);
}

}  // namespace stridor::console
