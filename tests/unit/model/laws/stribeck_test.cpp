#include "stridor/model/laws/friction.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

constexpr parameters::FrictionKind rational = parameters::FrictionKind::stribeck_rational;
constexpr Stribeck curve{0.8, 0.3, 0.05, 1.0, 0.02};

Stribeck as_rational(Stribeck law) {
    law.kind = rational;
    return law;
}

TEST(Stribeck, BeginsWithTheStaticCoefficientAndEndsAtTheKinetic) {
    for (const double exponent : {1.0, 1.5, 2.0, 7.0}) {
        const Stribeck dry{0.8, 0.3, 0.05, exponent, 0.0};
        for (const FrictionLaw& law : {FrictionLaw(dry), FrictionLaw(as_rational(dry))}) {
            EXPECT_EQ(slip_ratio(law, Slip::backward), 0.8);
            EXPECT_NEAR(slip_ratio(law, Slip::backward, -1e17), 0.3, 1e-15);
            EXPECT_EQ(slip_ratio(law, Slip::forward, 0.1), -slip_ratio(law, Slip::backward, -0.1));
        }
    }
}

TEST(Stribeck, HasItsClosedForms) {
    for (const double w : {1e-3, 0.02, 0.05, 0.3, 2.0})
        for (const double exponent : {1.0, 1.5, 2.0}) {
            Stribeck c = curve;
            c.exponent = exponent;
            const double power = std::pow(w / 0.05, exponent);
            EXPECT_NEAR(slip_ratio(c, Slip::backward, -w), 0.3 + 0.5 * std::exp(-power) + 0.02 * w, 4e-15);
            EXPECT_NEAR(slip_ratio(as_rational(c), Slip::backward, -w), 0.3 + 0.5 / (1.0 + power) + 0.02 * w, 4e-15);
        }
}

// the block of Leine and others: 1/(1 + 3 |w|)
TEST(Stribeck, IsLeinesLaw) {
    const Stribeck leine{1.0, 0.0, 1.0 / 3.0, 1.0, 0.0, rational};
    for (const double w : {0.0, 0.1, 0.5, 4.0})
        EXPECT_NEAR(slip_ratio(leine, Slip::forward, w), -1.0 / (1.0 + 3.0 * w), 2e-16);
}

TEST(Stribeck, WithoutAFallIsCoulombs) {
    for (const double w : {0.0, 0.01, 3.0}) {
        EXPECT_EQ(slip_ratio(Stribeck{0.4, 0.4, 0.05, 1.0, 0.0}, Slip::forward, w), -0.4);
        EXPECT_EQ(slip_ratio(Stribeck{0.4, 0.4, 0.05, 2.0, 0.0, rational}, Slip::forward, w), -0.4);
    }
}

TEST(Stribeck, IsThatOfACase) {
    parameters::Contact contact;
    contact.static_friction = 0.8;
    contact.kinetic_friction = 0.3;
    contact.stribeck_velocity = 0.05;
    contact.viscous_friction = 0.02;
    contact.friction = parameters::FrictionKind::stribeck;
    EXPECT_EQ(friction_law(contact), FrictionLaw(curve));
    contact.friction = parameters::FrictionKind::stribeck_rational;
    EXPECT_EQ(friction_law(contact), FrictionLaw(as_rational(curve)));
}

}  // namespace
}  // namespace stridor::model
