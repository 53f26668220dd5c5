#include "stridor/model/built/rubbing_system.hpp"

#include "support/property.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>

namespace stridor::model {
namespace {

using parameters::Case;

// elements of K at the incidence angle of Table 1, to the five digits they are known with
TEST(RubbingSystem, StiffnessAtSeventyDegrees) {
    const auto structure = rubbing_system(Case{});
    EXPECT_NEAR(structure.stiffness(0, 0), 2.0528e6, 50.0);
    EXPECT_NEAR(structure.stiffness(1, 1), 8.9472e6, 50.0);
    EXPECT_NEAR(structure.stiffness(0, 1), 2.8925e6, 50.0);
    EXPECT_EQ(structure.stiffness(1, 0), structure.stiffness(0, 1));
    EXPECT_EQ(structure.stiffness(2, 2), 1e6);
    EXPECT_EQ(structure.stiffness(0, 2), 0.0);
    EXPECT_EQ(structure.stiffness(1, 2), 0.0);
}

TEST(RubbingSystem, KeepsMassesLoadAndDirectionsOfTheContact) {
    Case c;
    c.contact().preload = 200.0;
    const auto structure = rubbing_system(c);
    EXPECT_EQ(structure.mass.diagonal(), (Eigen::Vector3d(0.1, 0.1, 0.4)));
    EXPECT_EQ(structure.load, (Eigen::Vector3d(0.0, -200.0, 200.0)));
    EXPECT_EQ(structure.contacts[0].normal, (Eigen::Vector3d(0.0, 1.0, -1.0)));
    EXPECT_EQ(structure.contacts[0].tangent, (Eigen::Vector3d(1.0, 0.0, 0.0)));
    EXPECT_EQ(structure.contacts[0].friction, FrictionLaw(Coulomb{0.8, 0.6}));
    EXPECT_EQ(structure.contacts[0].impact, ImpactLaw(Plastic{}));
    // equal dashpots along and across: the same in every direction
    EXPECT_NEAR(structure.damping(0, 0), 1.0, 1e-15);
    EXPECT_NEAR(structure.damping(1, 1), 1.0, 1e-15);
    EXPECT_EQ(structure.damping(0, 1), 0.0);
    EXPECT_EQ(structure.damping(2, 2), 1.0);
}

TEST(RubbingSystem, IsUncoupledUprightAndLyingDown) {
    Case c;
    c.joint().incidence_angle = 90.0;
    EXPECT_EQ(rubbing_system(c).stiffness.diagonal(), (Eigen::Vector3d(1e6, 1e7, 1e6)));
    EXPECT_EQ(rubbing_system(c).stiffness(0, 1), 0.0);
    c.joint().incidence_angle = 0.0;
    EXPECT_EQ(rubbing_system(c).stiffness.diagonal(), (Eigen::Vector3d(1e7, 1e6, 1e6)));
    EXPECT_EQ(rubbing_system(c).stiffness(0, 1), 0.0);
}

// a rotation changes neither trace nor determinant: k1i + k1j and k1i k1j
RC_GTEST_PROP(RubbingSystem, RotationKeepsTheInvariants, ()) {
    Case c;
    c.joint().incidence_angle = *support::number_between(-360.0, 360.0);
    c.joint().axial_stiffness = *support::number_between(1e6, 1e8);
    c.joint().axial_damping = *support::number_between(0.0, 10.0);
    const auto structure = rubbing_system(c);
    const Eigen::Matrix2d stiffness = structure.stiffness.topLeftCorner<2, 2>();
    const double trace = c.joint().axial_stiffness + c.joint().flexural_stiffness;
    // ten roundings of numbers no larger than the trace, squared in the determinant
    RC_ASSERT(std::abs(stiffness.trace() - trace) < 1e-15 * 10 * trace);
    RC_ASSERT(std::abs(stiffness.determinant() - c.joint().axial_stiffness * c.joint().flexural_stiffness) <
              1e-15 * 10 * trace * trace);
    RC_ASSERT(std::abs(structure.damping.topLeftCorner<2, 2>().trace() - c.joint().axial_damping - 1.0) < 1e-13);
}

// 180 - a mirrors x: the coupling changes its sign and nothing else, bit for bit
RC_GTEST_PROP(RubbingSystem, MirroredAngleChangesTheSignOfTheCouplingOnly, ()) {
    Case c;
    c.joint().axial_damping = 3.0;
    c.joint().incidence_angle = *support::whole_between(-180 * 64, 360 * 64) / 64.0;
    Case mirrored = c;
    mirrored.joint().incidence_angle = 180.0 - c.joint().incidence_angle;
    const auto here = rubbing_system(c);
    const auto there = rubbing_system(mirrored);
    RC_ASSERT(there.stiffness.diagonal() == here.stiffness.diagonal());
    RC_ASSERT(there.damping.diagonal() == here.damping.diagonal());
    RC_ASSERT(there.stiffness(0, 1) == -here.stiffness(0, 1));
    RC_ASSERT(there.damping(0, 1) == -here.damping(0, 1));
}

}  // namespace
}  // namespace stridor::model
