#include "stridor/model/contact/equilibrium.hpp"

#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

using parameters::Case;

// N/F = 1 / (1 - signed_friction r), r = k2y Kxy / ((Kyy + k2y) kst), kst = Kxx - Kxy^2 / (Kyy + k2y)
double closed_form(const Case& c, double signed_friction) {
    const auto K = rubbing_system(c).stiffness;
    const double across = K(1, 1) + c.plate.stiffness;
    const double along = K(0, 0) - K(0, 1) * K(0, 1) / across;
    return c.contact().preload / (1.0 - signed_friction * c.plate.stiffness * K(0, 1) / (across * along));
}

TEST(Equilibrium, AtRestIsThePreloadWithoutDisplacement) {
    const auto balance = equilibrium(rubbing_system({}), {0.0});
    EXPECT_NEAR(balance.normal_forces(0), 20.0, 1e-13);
    EXPECT_LT(balance.displacement.norm(), 1e-20);
}

// the springs hold it where it is: nothing but rounding is left to find
RC_GTEST_PROP(Equilibrium, AtRestOnSpringsIsThePreloadToo, ()) {
    Case c;
    c.joint().incidence_angle = *support::number_between(20.0, 160.0);
    c.contact().preload = *support::number_between(0.1, 1000.0);
    c.joint().stiffening = parameters::Stiffening::cubic;
    c.joint().axial_cubic = std::exp(*support::number_between(std::log(1e12), std::log(1e19)));
    c.joint().flexural_cubic = 1e-3 * c.joint().axial_cubic;
    const auto structure = rubbing_system(c);
    const auto balance = equilibrium(structure, {0.0});
    RC_ASSERT(std::abs(balance.normal_forces(0) - c.contact().preload) < 1e-10 * c.contact().preload);
    RC_ASSERT(balance.displacement.norm() < 1e-10 * displacement_scale(structure));
}

TEST(Equilibrium, SlidingDigsInWhileGoingAndEasesWhileComing) {
    EXPECT_GT(equilibrium(rubbing_system({}), {0.6}).normal_forces(0), 20.0);
    EXPECT_LT(equilibrium(rubbing_system({}), {-0.6}).normal_forces(0), 20.0);
}

RC_GTEST_PROP(Equilibrium, SlidingFollowsTheClosedForm, ()) {
    Case c;
    c.joint().incidence_angle = *support::number_between(0.0, 180.0);
    c.plate.stiffness = *support::number_between(1e5, 1e7);
    c.contact().preload = *support::number_between(1.0, 1000.0);
    const double signed_friction = *support::number_between(-1.0, 1.0);
    const double exact = closed_form(c, signed_friction);
    RC_PRE(exact > 0.0 && exact < 100.0 * c.contact().preload);
    const auto structure = rubbing_system(c);
    const auto balance = equilibrium(structure, {signed_friction});
    // conditioning: stiffness ratio 100 times the distance 100 from divergence, at rounding 1e-16
    RC_ASSERT(std::abs(balance.normal_forces(0) - exact) < 1e-11 * exact);

    const Eigen::Vector3d rest =
        structure.stiffness * balance.displacement - structure.load -
        (structure.contacts[0].normal + signed_friction * structure.contacts[0].tangent) * balance.normal_forces(0);
    RC_ASSERT(rest.norm() < 1e-11 * exact);
    RC_ASSERT(std::abs(structure.contacts[0].normal.dot(balance.displacement)) < 1e-11 * exact / c.plate.stiffness);
}

// beyond divergence the formal normal force is negative: the contact digs in
TEST(Equilibrium, BeyondDivergenceIsNegative) {
    EXPECT_LT(equilibrium(rubbing_system({}), {4.2}).normal_forces(0), 0.0);
    EXPECT_GT(equilibrium(rubbing_system({}), {4.1}).normal_forces(0), 0.0);
}

}  // namespace
}  // namespace stridor::model
