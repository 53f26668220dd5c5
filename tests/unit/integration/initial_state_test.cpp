#include "stridor/integration/run/initial_state.hpp"

#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/contact/contact_forces.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

using parameters::Initial;
using support::thrown_by;

model::Structure structure_with(double kinetic_friction) {
    parameters::Case c;
    c.contact().kinetic_friction = kinetic_friction;
    c.contact().static_friction = 2.0 * kinetic_friction;
    return model::rubbing_system(c);
}

TEST(InitialState, AtRestStandsWhileThePlateMoves) {
    const auto state = initial_state(structure_with(0.6), {Initial::rest, 0.0}, 0.1);
    EXPECT_LT(state.displacement.norm(), 1e-20);
    EXPECT_EQ(state.velocity.norm(), 0.0);
}

TEST(InitialState, StuckMovesWithThePlate) {
    const auto state = initial_state(structure_with(0.6), {Initial::stuck, 0.0}, -0.1);
    EXPECT_LT(state.displacement.norm(), 1e-20);
    EXPECT_EQ(state.velocity, (Eigen::Vector3d(-0.1, 0.0, 0.0)));
}

// nothing accelerates in steady sliding, whichever way
TEST(InitialState, SlidingIsInBalanceBesidesItsPerturbation) {
    const auto structure = structure_with(0.6);
    for (const double velocity : {-0.1, 0.1}) {
        const auto state = initial_state(structure, {Initial::sliding, 1e-3}, velocity);
        EXPECT_EQ(state.velocity, (Eigen::Vector3d(1e-3, 0.0, 0.0)));
        const auto now = model::instant(structure, state.displacement, Eigen::Vector3d(0.0, 0.0, 0.0), {velocity, 0.0});
        EXPECT_EQ(now.state, model::ContactState::slip);
        EXPECT_GT(now.friction_force * velocity, 0.0);
        EXPECT_LT(now.acceleration.norm(), 1e-10);  // forces of 20 N at rounding, on 0.1 kg
    }
}

TEST(InitialState, SlidingNeedsADirection) {
    const auto thrown = thrown_by([] { initial_state(structure_with(0.6), {Initial::sliding, 0.0}, 0.0); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("no direction")) << thrown.message;
}

// divergence at mu_d = 4.167 while going, never while coming
TEST(InitialState, SlidingNeedsAnEquilibrium) {
    EXPECT_NO_THROW(initial_state(structure_with(4.1), {Initial::sliding, 0.0}, 0.1));
    const auto thrown = thrown_by([] { initial_state(structure_with(4.2), {Initial::sliding, 0.0}, 0.1); });
    EXPECT_EQ(thrown.kind, ErrorKind::numerical);
    EXPECT_TRUE(thrown.says("sprag-slip")) << thrown.message;
    EXPECT_NO_THROW(initial_state(structure_with(4.2), {Initial::sliding, 0.0}, -0.1));
    EXPECT_NO_THROW(initial_state(structure_with(4.2), {Initial::rest, 0.0}, 0.1));
}

}  // namespace
}  // namespace stridor::integration
