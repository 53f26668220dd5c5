#include "stridor/integration/cost.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

using parameters::Case;

// two runs, the coarser of which must be stable
TEST(Cost, IsKnownBeforeTheRun) {
    Case c;
    c.run.duration = 2.0;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 1e-6;
    EXPECT_EQ(cost(c).steps, 3e6);
    EXPECT_NEAR(cost(c).step_limit, 1e-4, 1e-12);  // half of that of the joint's axial mode, 1e4 rad/s
    c.run.beta_2 = 1.0;
    EXPECT_NEAR(cost(c).step_limit, 0.7071067811865476e-4, 1e-12);
}

// two runs; half a period of the joint's axial mode, 1e4 rad/s, is twice the longest step
TEST(Cost, OfMoreauIsThatOfTwoRuns) {
    Case c;
    c.run.engine = parameters::Engine::moreau;
    c.run.step = 1e-6;
    EXPECT_EQ(cost(c).steps, 1.5e6);
    EXPECT_NEAR(cost(c).step_limit, 1.5707963267948966e-4, 1e-12);
}

// measured of a wiper on wet glass: 2 us a step, where friction that knows two values takes a twentieth
TEST(Cost, OfFrictionThatChangesIsMore) {
    Case c;
    EXPECT_EQ(cost(c).seconds, cost(c).steps * 1e-7);
    c.contact().friction = parameters::FrictionKind::linear;
    EXPECT_NEAR(cost(c).seconds, cost(c).steps * 2e-6, cost(c).steps * 0.5e-6);
}

// measured of Table 1's squeal whose joint stiffens: 0.23 s for 5e4 steps, some fifty times as long as without
TEST(Cost, OfAJointThatStiffensCountsItsSpring) {
    Case c;
    const double linear = cost(c).seconds;
    c.joint().stiffening = parameters::Stiffening::cubic;
    c.joint().axial_cubic = 1e12;
    EXPECT_GT(cost(c).seconds, 10.0 * linear);
    c.run.duration *= 2.0;
    EXPECT_NEAR(cost(c).seconds, cost(c).steps * 3.7e-6, cost(c).steps * 2e-6);
}

}  // namespace
}  // namespace stridor::integration
