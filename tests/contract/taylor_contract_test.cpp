#include "contract/engine_contract.hpp"
#include "contract/joint_as_structure.hpp"

namespace stridor::contract {
namespace {

void choose_taylor(parameters::Case& c) {
    c.run.engine = parameters::Engine::exact;
    c.run.step = 2e-6;  // where the suite samples its traces
}

// Terms of the balance are sums over blocks of states known to rounding. Blocks end where judged spans do: these move
// instants by rounding, which grows through impacts.
const EngineUnderTest taylor{.name = "taylor",
                             .choose = choose_taylor,
                             .energy_tolerance = 1e-10,
                             .as_solved = as_own_structure,
                             .change_moves = 1e-9};

// friction that falls with the slip velocity goes by Taylor series, a joint alone, too
void choose_falling_taylor(parameters::Case& c) {
    choose_taylor(c);
    c.contact().friction = parameters::FrictionKind::linear;
    c.contact().friction_slope = 0.05;
}

const EngineUnderTest falling_taylor{.name = "taylor_with_falling_friction",
                                     .choose = choose_falling_taylor,
                                     .energy_tolerance = 1e-10,
                                     .change_moves = 1e-9};

void choose_resting_taylor(parameters::Case& c) {
    choose_taylor(c);
    grow_by_rest(c);
}

const EngineUnderTest resting_taylor{.name = "taylor_with_growth_by_rest",
                                     .choose = choose_resting_taylor,
                                     .energy_tolerance = 1e-10,
                                     .change_moves = 1e-9};

INSTANTIATE_TEST_SUITE_P(Taylor, EngineContract, testing::Values(taylor, falling_taylor, resting_taylor),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
