#include "stridor/verification/sliding.hpp"

#include "stridor/analysis/stability_path.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/model/frequencies.hpp"
#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <fmt/format.h>

namespace stridor::verification {

namespace {

using model::ContactState;
using parameters::Case;
using parameters::Direction;
using parameters::PaperCase;

Case with_friction(Case c, double mu) {
    c.contact.kinetic_friction = mu;
    return c;
}

Case undamped(Case c) {
    c.joint.axial_damping = c.joint.flexural_damping = c.plate.damping = 0.0;
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
    add("open, plate [Hz]", ContactState::separation, 0, open_frequencies[0]);
    add("open, joint flexural [Hz]", ContactState::separation, 1, open_frequencies[1]);
    add("open, joint axial [Hz]", ContactState::separation, 2, open_frequencies[2]);
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
        tilted.joint.incidence_angle = angle;
        checks.push_back({fmt::format("flutter onset mu at {:g} deg", angle), onset,
                          over_friction(tilted, 1.0).boundaries.at(0).value, 5e-4});
    }
    return checks;
}

}  // namespace stridor::verification
