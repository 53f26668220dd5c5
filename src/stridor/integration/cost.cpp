#include "stridor/integration/cost.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/steps/massless_structure.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/parameters/rules/engines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stridor::integration {

namespace {

using parameters::Engine;

// [s] of one step by Taylor series
double step_of_series(const model::Structure& structure) {
    constexpr double step = 5e-7;
    constexpr double contact = 5e-7, mode_and_contact = 4.2e-8;
    constexpr double blocks_of_changing_friction = 2.0;  // they are shorter
    constexpr double with_springs = 1e-6, spring = 2e-6, mode_and_spring = 1.2e-8;
    const auto modes = static_cast<double>(model::dofs_of(structure));
    const auto contacts = static_cast<double>(structure.contacts.size());
    const auto springs = static_cast<double>(structure.springs.size());
    const bool changes =
        std::any_of(structure.contacts.begin(), structure.contacts.end(),
                    [](const model::ContactPoint& point) { return !model::is_state_wise(point.friction); });
    const double linear = step + contacts * (contact + modes * mode_and_contact);
    return (changes ? blocks_of_changing_friction : 1.0) * linear +
           (springs > 0.0 ? with_springs + springs * (spring + modes * mode_and_spring) : 0.0);
}

// [s] of one step on a core of 2025, by the engine of the case
double step_seconds(const parameters::Case& c, const model::Structure& structure) {
    constexpr double beta_2_step = 2.5e-8;
    constexpr double moreau_step = 1e-7, moreau_mode_and_contact = 2e-9;
    constexpr double exact_step = 1e-7;  // with two thousand events a second of motion
    switch (parameters::engine_of(c)) {
        case Engine::exact:
            return parameters::is_solved_by_series(c) ? step_of_series(structure) : exact_step;
        case Engine::moreau:
            return moreau_step + moreau_mode_and_contact * static_cast<double>(model::dofs_of(structure)) *
                                     static_cast<double>(structure.contacts.size());
        default:
            return beta_2_step;
    }
}

// [1] at the step and at twice the step, by each formulation; exact: whole ones
double step_count(const parameters::Case& c, double fastest) {
    if (parameters::engine_of(c) == Engine::exact) return std::ceil(c.run.duration * fastest);
    return std::ceil(1.5 * c.run.duration / c.run.step) * static_cast<double>(parameters::methods_of(c).size());
}

double stable_limit(const parameters::Case& c, const model::Structure& structure, double fastest) {
    const auto without_inertia = [&] { return longest_step(massless_structure(structure, c.run.massless_above)); };
    if (parameters::is_without_inertia(c)) return without_inertia();
    if (parameters::engine_of(c) == Engine::exact) return std::numeric_limits<double>::infinity();
    const double limit =
        parameters::engine_of(c) == Engine::moreau ? std::numbers::pi / fastest : stable_step(c.run.beta_2, fastest);
    return parameters::methods_of(c).size() > 1 ? std::min(limit, without_inertia()) : limit;
}

}  // namespace

Cost cost(const parameters::Case& c) {
    const model::Structure structure = model::structure_of(c);
    const double fastest = parameters::is_without_inertia(c)
                               ? 0.0  // it limits nothing
                               : model::natural_frequencies(structure, model::ContactState::separation).back();
    const double steps = step_count(c, fastest);
    // the step that it is compared with is twice as long
    return {steps, steps * step_seconds(c, structure), 0.5 * stable_limit(c, structure, fastest)};
}

}  // namespace stridor::integration
