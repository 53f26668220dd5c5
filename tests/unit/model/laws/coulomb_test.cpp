#include "stridor/model/laws/friction.hpp"

#include <gtest/gtest.h>

namespace stridor::model {
namespace {

constexpr Coulomb coulomb{0.8, 0.2};
const FrictionLaw law = coulomb;

TEST(Coulomb, IsTheSameBothWays) {
    for (const Slip way : slips)
        EXPECT_EQ(stick_limit(coulomb, way), 0.8);
    EXPECT_EQ(slip_ratio(coulomb, Slip::forward), -0.2);
    EXPECT_EQ(slip_ratio(coulomb, Slip::backward), 0.2);
}

TEST(Coulomb, HoldsUpToTheStaticLimit) {
    for (const double sign : {-1.0, 1.0}) {
        EXPECT_TRUE(holds(law, 20.0, 16.0 * sign));
        EXPECT_FALSE(holds(law, 20.0, 16.0000001 * sign));
    }
    EXPECT_TRUE(holds(law, 0.0, 0.0));
}

TEST(Coulomb, HoldsNothingThatIsPulledApart) {
    EXPECT_FALSE(holds(law, -20.0, 0.0));
    EXPECT_FALSE(holds(law, -20.0, 1.0));
}

TEST(Coulomb, IsThatOfACase) {
    parameters::Contact contact;
    contact.static_friction = 0.7;
    contact.kinetic_friction = 0.3;
    EXPECT_EQ(friction_law(contact), FrictionLaw(Coulomb{0.7, 0.3}));
}

}  // namespace
}  // namespace stridor::model
