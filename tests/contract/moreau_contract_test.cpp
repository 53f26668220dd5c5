#include "contract/engine_contract.hpp"
#include "contract/joint_as_structure.hpp"

namespace stridor::contract {
namespace {

void choose_moreau(parameters::Case& c) {
    c.run.engine = parameters::Engine::moreau;
    c.run.step = 2e-6;
}

void choose_falling_moreau(parameters::Case& c) {
    choose_moreau(c);
    c.contact().friction = parameters::FrictionKind::linear;
    c.contact().friction_slope = 0.05;
}

void choose_stribeck_moreau(parameters::Case& c) {
    choose_moreau(c);
    rub_by_stribeck(c);
}

void choose_resting_moreau(parameters::Case& c) {
    choose_moreau(c);
    grow_by_rest(c);
}

void choose_massless(parameters::Case& c) {
    choose_moreau(c);
    c.run.formulation = parameters::Formulation::massless;
}

void choose_resting_massless(parameters::Case& c) {
    choose_massless(c);
    grow_by_rest(c);
}

// a step in which a contact changes its state has one force for all of it: the balance is of first order there
const EngineUnderTest moreau{
    .name = "moreau", .choose = choose_moreau, .energy_tolerance = 1e-5, .unstable_step = 1e-3};

const EngineUnderTest falling_moreau{.name = "moreau_with_falling_friction",
                                     .choose = choose_falling_moreau,
                                     .energy_tolerance = 1e-5,
                                     .unstable_step = 1e-3};

const EngineUnderTest stribeck_moreau{.name = "moreau_with_stribeck_friction",
                                      .choose = choose_stribeck_moreau,
                                      .energy_tolerance = 1e-5,
                                      .unstable_step = 1e-3};

const EngineUnderTest resting_moreau{.name = "moreau_with_growth_by_rest",
                                     .choose = choose_resting_moreau,
                                     .energy_tolerance = 1e-5,
                                     .unstable_step = 1e-3};

// Forces are those that hold places: at rest they answer the flexibility of what has no inertia to 1e-4.
const EngineUnderTest massless{.name = "massless",
                               .choose = choose_massless,
                               .energy_tolerance = 1e-3,
                               .unstable_step = 1e-2,
                               .as_solved = on_massless_foot,
                               .force_share = 1e-4,
                               .starts_stuck = false};

const EngineUnderTest resting_massless{.name = "massless_with_growth_by_rest",
                                       .choose = choose_resting_massless,
                                       .energy_tolerance = 1e-3,
                                       .unstable_step = 1e-2,
                                       .as_solved = on_massless_foot,
                                       .force_share = 1e-4,
                                       .starts_stuck = false};

INSTANTIATE_TEST_SUITE_P(Steps, EngineContract,
                         testing::Values(moreau, falling_moreau, stribeck_moreau, resting_moreau, massless,
                                         resting_massless),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
