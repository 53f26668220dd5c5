#include "contract/friction_contract.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "support/belt_run.hpp"

#include <cmath>
#include <limits>

namespace stridor::contract {
namespace {

using model::Slip;
using model::slips;

TEST_P(FrictionContract, OpposesTheSlip) {
    EXPECT_LE(slip_ratio(law(), Slip::forward), 0.0);
    EXPECT_GE(slip_ratio(law(), Slip::backward), 0.0);
}

TEST_P(FrictionContract, SlipsWithNoMoreThanItSticksWith) {
    for (const Slip way : slips)
        EXPECT_LE(std::abs(slip_ratio(law(), way)), stick_limit(law(), way)) << index_of(way);
}

TEST_P(FrictionContract, HasFiniteCoefficients) {
    for (const Slip way : slips) {
        EXPECT_TRUE(std::isfinite(slip_ratio(law(), way)));
        EXPECT_TRUE(std::isfinite(stick_limit(law(), way)));
    }
}

TEST_P(FrictionContract, HoldsUpToTheLimitOfTheSideThatGivesIn) {
    for (const double N : {1e-9, 1.0, 3e4})
        for (const double sign : {-1.0, 1.0}) {
            const double limit = stick_limit(law(), model::slip_against(sign)) * N;
            EXPECT_TRUE(holds(law(), N, sign * limit * (1.0 - 1e-12)));
            EXPECT_FALSE(
                holds(law(), N, sign * std::nextafter(limit, std::numeric_limits<double>::infinity()) + sign * 1e-12));
        }
}

TEST_P(FrictionContract, HoldsNothingThatIsPulled) {
    for (const double T : {-1.0, 0.0, 1.0})
        EXPECT_FALSE(holds(law(), -1.0, T));
}

TEST_P(FrictionContract, IsItsOwnEqualAndNoOther) {
    EXPECT_EQ(law(), model::FrictionLaw(law()));
    EXPECT_NE(law(), model::FrictionLaw(model::Coulomb{123.0, 45.0}));
}

// The engines know no law: in the motion that they compute the law's own numbers stand.
void expect_law_in_motion(const model::FrictionLaw& law, const record::Trace& trace) {
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        const double N = trace.contacts.front().normal_force[k], T = trace.contacts.front().friction_force[k];
        const double w = trace.velocity[0][k] - trace.surface_velocity[k];
        const double slipping = slip_ratio(law, model::slip_of(w)) * N;
        const double limit = stick_limit(law, model::slip_against(T)) * N;
        if (trace.contacts.front().state[k] == model::ContactState::slip && std::abs(w) > 1e-6) {
            EXPECT_NEAR(T, slipping, 1e-9) << trace.time[k];
        } else if (trace.contacts.front().state[k] == model::ContactState::stick) {
            EXPECT_LE(std::abs(T), limit + 1e-9) << trace.time[k];
        }
    }
}

TEST_P(FrictionContract, StandsInTheMotionOfBothEngines) {
    for (const double velocity : {-0.1, 0.1}) {
        parameters::Case c;
        c.drive = support::constant_drive(velocity);
        c.run.duration = c.run.window = 0.2;
        model::Structure belt = model::mass_on_belt({1.0, 1e4, 5.0, 50.0, {}});
        belt.contacts[0].friction = law();
        const record::Request request{record::KeepHistory::no, {0.0, 0.2, 1e-4}};
        const auto recorder = [&] { return record::Recorder(record::schedule(c), request, 2); };
        const integration::Start start{parameters::Initial::stuck, 0.0};
        const auto exact = integration::integrate_exact(belt, c.drive, start, {}, recorder());
        const auto stepped = integration::integrate_beta_2(belt, c.drive, start, {1e-5, 0.5}, recorder());
        for (const integration::Motion& motion : {exact, stepped}) {
            EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
            expect_law_in_motion(law(), motion.record.trace);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Coulomb, FrictionContract,
                         testing::Values(FrictionUnderTest{"two_coefficients", model::Coulomb{0.8, 0.6}},
                                         FrictionUnderTest{"one_coefficient", model::Coulomb{0.4, 0.4}},
                                         FrictionUnderTest{"none", model::Coulomb{0.0, 0.0}}),
                         testing::PrintToStringParamName());

INSTANTIATE_TEST_SUITE_P(
    Directional, FrictionContract,
    testing::Values(FrictionUnderTest{"rough_backward", model::Directional{{0.3, 0.8}, {0.2, 0.6}}},
                    FrictionUnderTest{"rough_forward", model::Directional{{0.9, 0.4}, {0.7, 0.4}}}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace stridor::contract
