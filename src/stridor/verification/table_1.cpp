#include "stridor/verification/table_1.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/verification/check.hpp"

#include <fmt/format.h>

#include <string_view>

namespace stridor::verification {

namespace {

void add_checks(std::vector<Check>& checks, const Table1Column& column, parameters::Engine engine) {
    parameters::Case c = parameters::paper_case(column.which);
    c.run.engine = engine;
    c.run.step = 1e-6;  // [s] beta_2
    const bool is_exact = engine == parameters::Engine::exact;
    const double tolerance = is_exact ? table_1_exact_tolerance : beta_2_tolerance(column);
    const std::string_view name = parameters::paper_case_names[static_cast<std::size_t>(column.which)];
    for (const record::Tally& tally : integration::simulate(c).record.phases) {
        const analysis::Rates computed = analysis::rates(tally.contacts.at(0).time);
        const bool is_going = tally.phase == record::Phase::going;
        const analysis::Rates& expected = column.rates[is_going ? 0 : 1];
        const auto add = [&](const char* share, double analysis::Rates::*member) {
            checks.push_back(
                {fmt::format("{} {} {}, {}", name, is_going ? "going" : "coming", share, is_exact ? "exact" : "beta_2"),
                 expected.*member, computed.*member, tolerance});
        };
        add("stick", &analysis::Rates::stick);
        add("slip", &analysis::Rates::slip);
        add("separation", &analysis::Rates::separation);
    }
}

using model::ContactState;
using parameters::Case;
using parameters::Direction;
using parameters::PaperCase;

Case with_friction(Case c, double mu) {
    c.contact().kinetic_friction = mu;
    return c;
}

Case undamped(Case c) {
    c.joint().axial_damping = c.joint().flexural_damping = c.plate.damping = 0.0;
    return c;
}

analysis::StabilityPath over_friction(const Case& c, double to) {
    return analysis::stability_path(
        [&](double mu) {
            return analysis::sliding_stability(model::rubbing_system(with_friction(c, mu)), Direction::going);
        },
        0.0, to, 401);
}

}  // namespace

std::vector<Check> table_1_checks() {
    std::vector<Check> checks;
    for (const Table1Column& column : table_1)
        for (const auto engine : {parameters::Engine::exact, parameters::Engine::beta_2})
            add_checks(checks, column, engine);
    return checks;
}

// over the window from 1 to 2 s, its ends wherever they fall in a period
std::vector<Check> constant_drive_checks() {
    std::vector<Check> checks;
    for (const StickSlip& known : stick_slips) {
        parameters::Case c = parameters::paper_case(parameters::PaperCase::squeak);
        c.contact().preload = known.preload;
        c.drive = constant_drive(-0.1257);
        c.run.initial = parameters::Initial::stuck;
        c.run.duration = 2.0;
        const analysis::Evidence evidence = analysis::evidence(integration::simulate(c).record.phases.at(0), 0);
        checks.push_back({fmt::format("stick share, V = -0.1257, F = {:g} N", known.preload), known.stick_fraction,
                          evidence.rates.stick, 2e-6});
        checks.push_back({"its period [s]", known.period, evidence.alternation.period, 1e-7 * known.period});
    }
    return checks;
}

std::vector<Check> natural_frequency_checks() {
    const auto structure = model::rubbing_system(parameters::paper_case(PaperCase::squeal));
    std::vector<Check> checks;
    const auto add = [&](const char* name, ContactState state, std::size_t number, double expected) {
        const double computed = model::natural_frequencies(structure, state)[number] / base::two_pi;
        checks.push_back({name, expected, computed, 1e-4 * expected});
    };
    add("slip, mu = 0, first [Hz]", ContactState::slip, 0, slip_frequencies[0]);
    add("slip, mu = 0, second [Hz]", ContactState::slip, 1, slip_frequencies[1]);
    add("stick [Hz]", ContactState::stick, 0, stick_frequencies[0]);
    add("separation, plate [Hz]", ContactState::separation, 0, open_frequencies[0]);
    add("separation, joint flexural [Hz]", ContactState::separation, 1, open_frequencies[1]);
    add("separation, joint axial [Hz]", ContactState::separation, 2, open_frequencies[2]);
    return checks;
}

std::vector<Check> stability_checks() {
    const Case c = parameters::paper_case(PaperCase::squeal);
    std::vector<Check> checks;
    const auto add = [&](const char* name, double expected, double computed, double tolerance) {
        checks.push_back({name, expected, computed, tolerance});
    };
    add("flutter onset mu, damped", damped_flutter_onset, over_friction(c, 1.0).boundaries.at(0).value, 5e-4);
    const analysis::StabilityPath free = over_friction(undamped(c), 5.0);
    add("flutter onset mu, undamped", undamped_flutter_onset, free.boundaries.at(0).value, 5e-4);
    add("its frequency [Hz]", undamped_flutter_frequency, free.boundaries.at(0).frequency, 0.05);
    add("flutter gives way to divergence, mu, undamped", undamped_divergence_onset, free.boundaries.at(1).value, 5e-4);
    add("no sliding equilibrium from mu (sprag-slip)", locking_onset, free.boundaries.at(2).value, 5e-4);
    const auto grown = analysis::sliding_stability(model::rubbing_system(with_friction(c, 0.6)), Direction::going);
    add("growth at mu = 0.6 [1/s]", squeal_growth, grown.growth, 0.01);
    add("its frequency [Hz]", squeal_frequency, grown.frequency, 0.05);
    for (const auto& [angle, onset] : flutter_onsets) {
        Case tilted = c;
        tilted.joint().incidence_angle = angle;
        checks.push_back({fmt::format("flutter onset mu at {:g} deg", angle), onset,
                          over_friction(tilted, 1.0).boundaries.at(0).value, 5e-4});
    }
    return checks;
}

}  // namespace stridor::verification
