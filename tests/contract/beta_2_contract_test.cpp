#include "contract/engine_contract.hpp"

namespace stridor::contract {
namespace {

void choose(parameters::Case& c) {
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 2e-6;
    c.run.beta_2 = 0.5;
}

void choose_falling_beta_2(parameters::Case& c) {
    choose(c);
    c.contact().friction = parameters::FrictionKind::linear;
    c.contact().friction_slope = 0.05;
}

void choose_stribeck_beta_2(parameters::Case& c) {
    choose(c);
    rub_by_stribeck(c);
}

void choose_resting_beta_2(parameters::Case& c) {
    choose(c);
    grow_by_rest(c);
}

// At beta_2 = 0.5 the balance is exact but for rounding. Each of the 1e4 steps rounds forces of the size K u by 2^-53;
// the sums are held against the turnover, of which elastic energy may be a large part many times over: 1e4 steps 1e-16.
const EngineUnderTest beta_2{"beta_2", choose, 1e-12, 1e-3};
const EngineUnderTest falling_beta_2{"beta_2_with_falling_friction", choose_falling_beta_2, 1e-12, 1e-3};
const EngineUnderTest stribeck_beta_2{"beta_2_with_stribeck_friction", choose_stribeck_beta_2, 1e-12, 1e-3};
const EngineUnderTest resting_beta_2{"beta_2_with_growth_by_rest", choose_resting_beta_2, 1e-12, 1e-3};

INSTANTIATE_TEST_SUITE_P(Beta2, EngineContract,
                         testing::Values(beta_2, falling_beta_2, stribeck_beta_2, resting_beta_2),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
