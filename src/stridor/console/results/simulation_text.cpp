#include "stridor/console/results/simulation_text.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/classification/interface_rules.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "stridor/parameters/system.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>

namespace stridor::console {

namespace {

using classification::Category;
using classification::Verdict;

// "sinusoidal drive of 4 mm at 5 Hz": its kind and the values that mean something for it
std::string drive_text(const parameters::Case& c) {
    const std::string kind = std::string(parameters::kind_name(c.drive)) + " drive";
    std::string values, rate;
    for (const parameters::Field& field : parameters::fields()) {
        if (field.section != "drive" || !field.belongs(c)) continue;
        if (parameters::names_file(field)) return kind + " " + parameters::value_text(c, field);
        if (!std::holds_alternative<parameters::Quantity>(field.kind)) continue;
        const std::string_view unit = parameters::unit_of(field);
        const double value = parameters::get_quantity(c, field);
        const std::string text =
            unit == "m" ? fmt::format("{:g} mm", 1e3 * value) : fmt::format("{:g} {}", value, unit);
        if (unit == "Hz")
            rate = " at " + text;
        else
            values += (values.empty() ? " of " : ", ") + text;
    }
    return kind + values + rate;
}

std::vector<TextColumn> verdict_columns(const parameters::Case& c) {
    return {left("phase", 8),   left("category", 10),    right("slip", 8),       right("stick", 8),
            right("separ.", 8), right("regularity", 13), right("frequency", 12), right(analysis::level_title(c), 12)};
}

std::vector<std::string> verdict_cells(const Verdict& verdict) {
    const analysis::Evidence& e = verdict.evidence;
    const bool locks = verdict.quiet == classification::Quiet::locks;
    const bool is_plain = verdict.category == Category::none && !locks;
    return {std::string(record::phase_names[static_cast<std::size_t>(e.phase)]),
            styled(classification::word(verdict), is_plain ? Style::plain : Style::bold, STDOUT_FILENO),
            number_or_dash(100.0 * e.rates.slip, "{:.1f} %"), number_or_dash(100.0 * e.rates.stick, "{:.1f} %"),
            number_or_dash(100.0 * e.rates.separation, "{:.1f} %"), number_or_dash(e.alternation.regularity, "{:.3f}"),
            number_or_dash(e.alternation.frequency, "{:.1f} Hz"),
            // what is left of a motion as it jams is no vibration
            locks ? "-" : number_or_dash(e.levels.joint.decibels, "{:.1f} dB")};
}

std::string solver_text(const parameters::Case& c) {
    if (parameters::engine_of(c) == parameters::Engine::beta_2)
        return fmt::format("beta_2 = {:g}, step {:g} s, compared with {:g} s", c.run.beta_2, c.run.step,
                           2.0 * c.run.step);
    if (parameters::engine_of(c) == parameters::Engine::moreau)
        return fmt::format("moreau{}, step {:g} s, compared with {:g} s",
                           parameters::is_without_inertia(c) ? " without inertia at the contacts" : "", c.run.step,
                           2.0 * c.run.step);
    return "exact, impact " + parameters::value_text(c, *parameters::find_field("contact.impact"));
}

// a case may leave the choice
std::string engine_text(const parameters::Case& c) {
    const std::optional<base::Problem> problem = parameters::why_not_exact(c);
    return solver_text(c) + (problem ? "; chosen, since " + problem->what : "");
}

// what is known of the rest of a run that ended early
std::string proof_text(const integration::Motion& motion) {
    if (motion.silence)
        return fmt::format("slips for ever from {:.4g} s on: N stays above {:.4g} N, |w| above {:.4g} m/s\n\n",
                           motion.silence->time, motion.silence->normal_force, motion.silence->slip_velocity);
    if (motion.cycle)
        return fmt::format("limit cycle from {:.4g} s on: period {:.9g} s, {} events, returns to {:.1e}\n\n",
                           motion.cycle->time, motion.cycle->period, motion.cycle->events, motion.cycle->residual);
    return "";
}

// what of the window no verdict looks at
std::string left_out(const parameters::Case& c, const std::vector<Verdict>& verdicts) {
    if (!parameters::has_one_phase(c.drive))
        return "shares are of the whole phase; the verdict is made from its steady part (verdict.settling, "
               "verdict.reversal).\n";
    const analysis::Evidence& e = verdicts.front().evidence;
    if (!(e.window_time > e.judged_time)) return "";
    return fmt::format(
        "shares are of the whole window; the verdict is made from its last {:.4g} s: what comes before is the start\n"
        "(verdict.start) and left out.\n",
        e.judged_time);
}

// what a silence is not said of: the other way and the other starts
std::string only_this(const parameters::Case& c, const std::vector<Verdict>& verdicts) {
    const bool is_one_way = c.drive.kind == parameters::DriveKind::constant && verdicts.size() == 1;
    if (!is_one_way || verdicts.front().category != Category::none) return "";
    return fmt::format("only {} from {} was looked at; `stridor advise` judges both ways and every start.\n",
                       parameters::direction_names[static_cast<std::size_t>(parameters::steady_direction(c.drive))],
                       parameters::value_text(c, *parameters::find_field("run.initial")));
}

// ", mu_s + 0.02 ln(1 + t/(1 s)) after a rest of t"
std::string rest_text(const parameters::Contact& contact) {
    if (!parameters::grows_with_rest(contact)) return "";
    const std::string ratio = fmt::format("t/({:g} s)", contact.rest_time);
    if (contact.rest == parameters::RestKind::logarithmic)
        return fmt::format(", mu_s + {:g} ln(1 + {}) after a rest of t", contact.rest_growth, ratio);
    return fmt::format(", mu_s + {:g} (1 - exp(-({})^{:g})) after a rest of t", contact.rest_growth, ratio,
                       contact.rest_exponent);
}

// "mu_d 0.6, mu_s 0.8", and what else the law has
std::string law_text(const parameters::Contact& contact) {
    using parameters::FrictionKind;
    if (parameters::is_regularised(contact.friction))
        return fmt::format("mu_d {:g}, v_r {:g} m/s, no stick", contact.kinetic_friction, contact.regularisation);
    if (contact.friction == FrictionKind::table)
        return fmt::format("friction by a table of {} rows, mu_s {:g}", contact.friction_table.speeds.size(),
                           contact.static_friction);
    if (contact.friction == FrictionKind::dieterich || contact.friction == FrictionKind::ruina)
        return fmt::format("mu_d {:g} at {:g} m/s, a {:g}, b {:g}, D_c {:g} m", contact.kinetic_friction,
                           contact.reference_velocity, contact.direct_effect, contact.evolution_effect,
                           contact.slip_length);
    const bool has_bristles = contact.friction == FrictionKind::lugre;
    const bool is_stribeck = contact.friction == FrictionKind::stribeck ||
                             contact.friction == FrictionKind::stribeck_rational || has_bristles;
    return fmt::format("mu_d {:g}, mu_s {:g}", contact.kinetic_friction, contact.static_friction) +
           (is_stribeck ? fmt::format(", v_s {:g} m/s", contact.stribeck_velocity) : "") +
           (has_bristles ? fmt::format(", sigma_0 {:g} 1/m", contact.bristle_stiffness) : "");
}

std::string coefficients_text(const parameters::Contact& contact) {
    return law_text(contact) + rest_text(contact);
}

// what an own structure is pressed and rubs with
std::string structure_text(const parameters::Case& c) {
    std::string text = fmt::format(", {}: {} rows, {}\n", parameters::origin_of(c), parameters::coordinate_count(c),
                                   counted(parameters::contact_count(c), "contact", "contacts"));
    text += parameters::is_preloaded(c) ? fmt::format("preload {:g} N, ", c.contact().preload)
                                        : std::string("without a preload, ");
    return text + coefficients_text(c.contact()) + "\n";
}

// what the joints rub with
std::string joints_text(const parameters::Case& c) {
    if (!parameters::has_plate(c)) return structure_text(c);
    std::string text;
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        const parameters::Contact& contact = c.joints[k].contact;
        text += parameters::has_one_joint(c) ? "" : "  " + c.joints[k].name + ": ";
        text += fmt::format("preload {:g} N, {}, incidence angle {:g} deg\n", contact.preload,
                            coefficients_text(contact), c.joints[k].joint.incidence_angle);
    }
    return parameters::has_one_joint(c) ? ", " + text : fmt::format(", {} joints\n", c.joints.size()) + text;
}

// names of an own structure's contacts are a file's
std::string contact_text(const parameters::Case& c, std::size_t contact) {
    return base::visible(parameters::contact_name(c, contact));
}

std::string rates_text(const analysis::Rates& rates) {
    return fmt::format("slip {:.2f} %, stick {:.2f} %, separation {:.2f} %", 100.0 * rates.slip, 100.0 * rates.stick,
                       100.0 * rates.separation);
}

void widen(analysis::Rates& most, const analysis::Rates& change) {
    most.slip = std::max(most.slip, std::abs(change.slip));
    most.stick = std::max(most.stick, std::abs(change.stick));
    most.separation = std::max(most.separation, std::abs(change.separation));
}

// by how much the shares of the contacts changed from twice the step, in all phases
std::string step_change_text(const std::vector<record::Tally>& phases) {
    analysis::Rates most;
    bool was_compared = false;
    for (const record::Tally& phase : phases)
        for (std::size_t k = 0; k < phase.contacts.size(); ++k) {
            const std::optional<analysis::Rates> change = analysis::evidence(phase, k).step_change;
            if (!change) continue;
            was_compared = true;
            widen(most, *change);
        }
    if (!was_compared) return "";
    return "shares changed from twice the step by at most: " + rates_text(most) + "\n";
}

// what the same run makes of contacts without inertia, and whether its verdicts agree
std::string massless_text(const parameters::Case& c, const integration::Motion& motion) {
    if (!motion.massless) return "";
    if (!integration::has_result(motion.massless->outcome))
        return fmt::format("without inertia at the contacts it has no result: {}\n",
                           integration::reason_names[static_cast<std::size_t>(motion.massless->outcome.reason)]);
    std::string text;
    for (std::size_t n = 0; n < motion.massless->phases.size(); ++n) {
        const record::Tally& with = motion.record.phases[n];
        const record::Tally& without = motion.massless->phases[n];
        analysis::Rates most;
        for (std::size_t k = 0; k < with.contacts.size(); ++k) {
            const analysis::Rates a = analysis::rates(with.contacts[k].time);
            const analysis::Rates b = analysis::rates(without.contacts[k].time);
            widen(most, {a.slip - b.slip, a.stick - b.stick, a.separation - b.separation});
        }
        const Category first = classification::classify_all(with, c.verdict).whole.category;
        const Category second = classification::classify_all(without, c.verdict).whole.category;
        const std::string phase = fmt::format("{}: ", record::phase_names[static_cast<std::size_t>(with.phase)]);
        if (motion.massless->phases.size() > 1) text += phase;
        text += "without inertia at the contacts shares differ by at most: " + rates_text(most) + "\n";
        if (first != second)
            text += fmt::format("{}the formulations disagree: {} with inertia at the contacts, {} without\n", phase,
                                classification::name(first), classification::name(second));
    }
    const std::string change = step_change_text(motion.massless->phases);
    return change.empty() ? text : text + "without inertia, " + change;
}

// what the contacts of an interface do as a whole
std::string interface_text(const parameters::Case& c, const classification::InterfaceVerdict& verdict) {
    const analysis::Interface& figures = verdict.figures;
    std::string text = fmt::format("{} contacts as a whole:", figures.contacts.size());
    constexpr std::array<std::string_view, 4> words{"all stick", "some slip", "all slip", "all separated"};
    for (std::size_t state = 0; state < words.size(); ++state)
        text += fmt::format("{} {} {:.1f} %", state == 0 ? "" : ",", words[state], 100.0 * figures.rates[state]);
    text += "\n";
    if (std::isfinite(verdict.free_together))
        text += fmt::format("while one does not stick, {:.0f} % of the load of the noisy ones does not\n",
                            100.0 * verdict.free_together);
    const std::size_t leading = verdict.whole.evidence.contact;
    for (std::size_t k = 0; k < figures.contacts.size(); ++k)
        if (figures.contacts[k] == leading)
            text += fmt::format("{} leads: {:.1f} % of the load, {:.3g} W of friction{}\n", contact_text(c, leading),
                                100.0 * figures.loads[k].share, figures.loads[k].friction_power,
                                verdict.differs ? "; the contacts differ" : "");
    return text;
}

// a row for each contact of several, the phase's verdict being that of the loudest interface
std::string contacts_text(const parameters::Case& c, const integration::Motion& motion) {
    const std::size_t contacts = parameters::contact_count(c);
    if (contacts < 2) return "";
    std::string wholes;
    std::size_t widest = 8;
    for (std::size_t k = 0; k < contacts; ++k)
        widest = std::max(widest, width_of(contact_text(c, k)) + 2);
    TextTable table{verdict_columns(c)};
    for (TextColumn& column : table.columns)
        column.heading.clear();
    table.columns.insert(table.columns.begin(), left("", widest));
    for (const record::Tally& phase : motion.record.phases) {
        const classification::PhaseVerdicts all =
            classification::classify_all(phase, c.verdict, classification::contact_names(c));
        for (std::size_t k = 0; k < contacts; ++k) {
            table.rows.push_back(all.contacts[k] ? verdict_cells(*all.contacts[k])
                                                 : std::vector<std::string>{"unloaded"});
            table.rows.back().insert(table.rows.back().begin(), contact_text(c, k));
        }
        for (const classification::InterfaceVerdict& verdict : all.interfaces)
            wholes += "\n" + interface_text(c, verdict);
    }
    const std::string_view heading =
        wholes.empty() ? "a phase takes the loudest verdict" : "a phase takes the verdict of the interface";
    return fmt::format("\neach contact by itself; {}:\n", heading) + text_of(table) + wholes;
}

}  // namespace

std::string simulation_text(const parameters::Case& c, const integration::Motion& motion,
                            const std::vector<Verdict>& verdicts) {
    std::string text = styled(c.title.empty() ? "case" : c.title, Style::bold, STDOUT_FILENO) + "\n";
    text += drive_text(c) + joints_text(c);
    text += fmt::format("engine {}; start: {}; energy balance closes to {:.1e}\n\n", engine_text(c),
                        parameters::value_text(c, *parameters::find_field("run.initial")),
                        std::abs(motion.energy.relative_residual()));
    text += proof_text(motion);
    TextTable table{verdict_columns(c)};
    for (const Verdict& verdict : verdicts)
        table.rows.push_back(verdict_cells(verdict));
    text += text_of(table) + contacts_text(c, motion) + step_change_text(motion.record.phases) +
            massless_text(c, motion) + "\n";
    for (const Verdict& verdict : verdicts) {
        text += fmt::format("{}: {}\n", record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)],
                            fmt::join(verdict.reasons, "; "));
        for (const std::string& warning : verdict.warnings)
            text += "warning: " + warning + "\n";
        text += margin_lines(verdict.margins, 19, 17);
    }
    text += "\n" + left_out(c, verdicts) + only_this(c, verdicts) +
            "A category names a vibration pattern of the model.\n" + std::string(analysis::level_note(c)) + "\n";
    return text;
}

}  // namespace stridor::console
