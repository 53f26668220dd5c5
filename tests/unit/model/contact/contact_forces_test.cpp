#include "stridor/model/contact/contact_forces.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

using support::thrown_by;

// k D = (mu_s - mu_d) F: the static limit is 80 N, reached at x = 0.08 m
const Belt belt{2.0, 1000.0, 0.0, 100.0, {0.8, 0.3}};

// M couples the normal and the tangential direction: Wnn = 1/det, Wnt = -coupling/det, det = 1 - coupling^2
Structure coupled(double coupling, double kinetic_friction) {
    Structure structure = mass_on_belt({1.0, 1.0, 0.0, 1.0, {2.0 * kinetic_friction, kinetic_friction}});
    structure.mass(0, 1) = structure.mass(1, 0) = coupling;
    return structure;
}

TEST(Rest, CarriesThePreloadWithoutFriction) {
    const auto now = instant(rubbing_system({}), Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, 0.0, 0.0), {});
    EXPECT_EQ(now.state, ContactState::stick);
    EXPECT_NEAR(now.normal_force, 20.0, 1e-13);
    EXPECT_NEAR(now.friction_force, 0.0, 1e-13);
    EXPECT_LT(now.acceleration.norm(), 1e-12);
}

TEST(Stick, HoldsUntilForceReachesStaticLimit) {
    const auto structure = mass_on_belt(belt);
    for (const double share : {-0.999, -0.5, 0.0, 0.5, 0.999}) {
        const auto now = instant(structure, Eigen::Vector2d(0.08 * share, 0.0), Eigen::Vector2d(0.3, 0.0), {0.3, 0.0});
        EXPECT_EQ(now.state, ContactState::stick) << share;
        EXPECT_NEAR(now.friction_force, 80.0 * share, 1e-12);
        EXPECT_EQ(now.acceleration(0), 0.0);
    }
}

TEST(Stick, BreaksAgainstItsFrictionForce) {
    const auto structure = mass_on_belt(belt);
    for (const double sign : {-1.0, 1.0}) {
        const auto now = instant(structure, Eigen::Vector2d(0.0801 * sign, 0.0), Eigen::Vector2d(0.3, 0.0), {0.3, 0.0});
        EXPECT_EQ(now.state, ContactState::slip);
        EXPECT_NEAR(now.friction_force, 30.0 * sign, 1e-13);  // T = mu_d N the way it was stuck
        // slip begins with sign(w') = -sign(T)
        EXPECT_LT(now.acceleration(0) * sign, 0.0);
    }
}

TEST(Stick, FollowsTheAccelerationOfTheSurface) {
    const auto now = instant(mass_on_belt(belt), Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.3, 0.0), {0.3, 5.0});
    EXPECT_EQ(now.state, ContactState::stick);
    EXPECT_NEAR(now.friction_force, 10.0, 1e-13);  // m V'
    EXPECT_NEAR(now.acceleration(0), 5.0, 1e-14);
    // m V' = 82 N is more than 80 N can hold
    EXPECT_EQ(instant(mass_on_belt(belt), Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.3, 0.0), {0.3, 41.0}).state,
              ContactState::slip);
}

TEST(Slip, OpposesTheSlipVelocity) {
    const auto structure = mass_on_belt(belt);
    for (const double w : {-0.2, 1e-12, 0.2}) {
        const auto now = instant(structure, Eigen::Vector2d(0.01, 0.0), Eigen::Vector2d(w, 0.0), {});
        EXPECT_EQ(now.state, ContactState::slip);
        EXPECT_NEAR(now.friction_force, std::copysign(30.0, -w), 1e-13);
        EXPECT_NEAR(now.acceleration(0), (now.friction_force - 10.0) / 2.0, 1e-13);  // (T - k x) / m
    }
}

// the contact's normal force in slip is that of the closed form N = F - m2 y'' - c2y y' - k2y y
RC_GTEST_PROP(Slip, SatisfiesTheEquationsOfMotion, ()) {
    parameters::Case c;
    c.joint().incidence_angle = *support::number_between(0.0, 180.0);
    const auto structure = rubbing_system(c);
    const double y = *support::number_between(-1e-6, 1e-6);
    const double y_rate = *support::number_between(-1e-2, 1e-2);
    const Eigen::Vector3d u(*support::number_between(-1e-6, 1e-6), y, y);
    const Eigen::Vector3d v(*support::number_between(-1.0, 1.0), y_rate, y_rate);
    const SurfaceMotion surface{0.3001, -2.0};  // never equal to the mass's velocity
    const auto now = instant(structure, u, v, surface);
    RC_PRE(now.state == ContactState::slip);
    const double w = v(0) - surface.velocity;
    // N is the difference of terms below 100 N
    RC_ASSERT(std::abs(now.friction_force + std::copysign(0.6, w) * now.normal_force) < 1e-12);
    RC_ASSERT(std::abs(now.acceleration(1) - now.acceleration(2)) < 1e-11);
    const double plate_force =
        c.contact().preload - c.plate.mass * now.acceleration(2) - c.plate.damping * y_rate - c.plate.stiffness * y;
    RC_ASSERT(std::abs(now.normal_force - plate_force) < 1e-11);
    const Eigen::Vector3d rest = structure.mass * now.acceleration + structure.damping * v + structure.stiffness * u -
                                 structure.load - structure.contacts[0].normal * now.normal_force -
                                 structure.contacts[0].tangent * now.friction_force;
    RC_ASSERT(rest.norm() < 1e-11);
}

TEST(Separation, HasNoForces) {
    const auto structure = rubbing_system({});
    const auto open = instant(structure, Eigen::Vector3d(0.0, 1e-9, 0.0), Eigen::Vector3d(0.0, 0.0, 0.0), {});
    EXPECT_EQ(open.state, ContactState::separation);
    EXPECT_EQ(open.normal_force, 0.0);
    EXPECT_EQ(open.friction_force, 0.0);
    // the preload presses mass 1 down and mass 2 up: -F/m1, F/m2
    EXPECT_NEAR(open.acceleration(1), -200.0, 1.0);
    EXPECT_NEAR(open.acceleration(2), 50.0, 1.0);
}

TEST(Separation, BeginsWhereTheGapOpensOrTheForceWouldPull) {
    const auto structure = rubbing_system({});
    EXPECT_EQ(instant(structure, Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(0.0, 1e-9, 0.0), {}).state,
              ContactState::separation);
    // mass 1 drawn up so far that only a pulling contact would keep the plate on it: N = F - m2 y'' - k2y y < 0
    const auto pulled = instant(structure, Eigen::Vector3d(0.0, -1e-4, -1e-4), Eigen::Vector3d(0.0, 0.0, 0.0), {});
    EXPECT_EQ(pulled.state, ContactState::separation);
    EXPECT_GE(pulled.normal_force, 0.0);
}

// N = -n.a_free / (Wnn - sign(w) mu_d Wnt): with coupling the friction changes the normal force
TEST(CoupledSlip, LoadsOneDirectionAndUnloadsTheOther) {
    const auto structure = coupled(0.5, 0.4);
    // n.a_free = -1 / det, Wnn = 1 / det, Wnt = -0.5 / det: N = 1 / (1 + sign(w) 0.4 0.5)
    EXPECT_NEAR(instant(structure, Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), {}).normal_force, 1.0 / 1.2,
                1e-15);
    EXPECT_NEAR(instant(structure, Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(-1.0, 0.0), {}).normal_force, 1.0 / 0.8,
                1e-15);
    for (const double w : {-1.0, 1.0})
        EXPECT_NEAR(instant(structure, Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(w, 0.0), {}).acceleration(1), 0.0,
                    1e-15);
}

TEST(CoupledStick, KeepsTheGapClosedAndFollowsTheSurface) {
    const auto now = instant(coupled(0.5, 0.4), Eigen::Vector2d(0.1, 0.0), Eigen::Vector2d(0.2, 0.0), {0.2, 0.3});
    ASSERT_EQ(now.state, ContactState::stick);
    EXPECT_NEAR(now.acceleration(0), 0.3, 1e-15);
    EXPECT_NEAR(now.acceleration(1), 0.0, 1e-15);
    EXPECT_NEAR(now.friction_force, 0.4, 1e-15);  // k x + m V'
    EXPECT_NEAR(now.normal_force, 1.15, 1e-15);   // F + coupling V'
}

// Wnn <= mu_d |Wnt| where mu_d >= 1 / coupling
TEST(Painleve, IsANumericalErrorThatNamesTheFriction) {
    EXPECT_NO_THROW(instant(coupled(0.5, 1.99), Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 0.0), {}));
    for (const double w : {-1.0, 1.0}) {
        const auto thrown =
            thrown_by([&] { instant(coupled(0.5, 2.01), Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(w, 0.0), {}); });
        EXPECT_EQ(thrown.kind, ErrorKind::numerical);
        EXPECT_TRUE(thrown.says("Painleve")) << thrown.message;
        EXPECT_TRUE(thrown.says("mu_d = 2.01")) << thrown.message;
    }
}

// the masses are points: no friction is too much
TEST(Painleve, NeverMeetsThePapersSystem) {
    parameters::Case c;
    c.contact().kinetic_friction = 1e6;
    c.contact().static_friction = 1e6;
    EXPECT_NO_THROW(instant(rubbing_system(c), Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, 0.0, 0.0), {}));
}

}  // namespace
}  // namespace stridor::model
