#include "contract/engine_contract.hpp"

namespace stridor::contract {
namespace {

void choose_exact(parameters::Case& c) {
    c.run.engine = parameters::Engine::exact;
    c.run.step = 2e-6;  // where the suite samples its traces
}

// every term of the balance is an integral or a difference of states known to rounding
const EngineUnderTest exact{"exact", choose_exact, 1e-12, 0.0};

INSTANTIATE_TEST_SUITE_P(Exact, EngineContract, testing::Values(exact), testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
