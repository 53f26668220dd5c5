#include "stridor/model/contact/contact_compliance.hpp"

#include "stridor/model/built/joints_on_plate.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace stridor::model {
namespace {

// n = (0, 1), t = (1, 0): W_nn + mu_d W_nt = (1 - 0.8 mu_d)/0.36 where it slips backward
Structure painleve(double kinetic_friction) {
    Structure structure = structure_of_size(2);
    structure.mass << 1.0, 0.8, 0.8, 1.0;
    structure.stiffness = 100.0 * Eigen::Matrix2d::Identity();
    structure.contacts.front().normal << 0.0, 1.0;
    structure.contacts.front().tangent << 1.0, 0.0;
    structure.contacts.front().friction = Coulomb{1.5, kinetic_friction};
    return structure;
}

TEST(ContactCompliance, IsWhatAnImpulseDoesToVelocities) {
    const Eigen::MatrixXd w = contact_compliance(painleve(0.5));
    EXPECT_NEAR(w(0, 0), 1.0 / 0.36, 1e-14);
    EXPECT_NEAR(w(0, 1), -0.8 / 0.36, 1e-14);
}

TEST(Doubts, NamePainlevesConfigurationFromItsFrictionOn) {
    const Structure sound = painleve(1.2);
    EXPECT_NEAR(least_normal_giving(sound, contact_compliance(sound)).share, 1.0 - 0.96, 1e-14);
    EXPECT_TRUE(doubts(sound, {"the block"}).empty());
    const std::vector<base::Problem> found = doubts(painleve(1.3), {"the block"});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].what, "the block is a configuration of Painleve at mu_d = 1.3");
    EXPECT_EQ(found[0].why, "friction presses it together by 1.04 of what its normal force parts it");
}

// a row of rubbing nodes, each with a normal and a tangential motion
Structure row_of_nodes(double mass_between) {
    constexpr int nodes = 4;
    Structure structure = structure_of_size(2 * nodes, nodes);
    structure.stiffness.setIdentity();
    for (int k = 0; k < nodes; ++k) {
        structure.contacts[static_cast<std::size_t>(k)].normal(2 * k + 1) = 1.0;
        structure.contacts[static_cast<std::size_t>(k)].tangent(2 * k) = 1.0;
        structure.contacts[static_cast<std::size_t>(k)].friction = Coulomb{0.8, 0.5};
    }
    for (int row = 0; row < 2 * nodes; ++row) {
        structure.mass(row, row) = 4.0;
        if (row >= 2) structure.mass(row, row - 2) = structure.mass(row - 2, row) = mass_between;
    }
    return structure;
}

const std::vector<std::string> names{"a", "b", "c", "d"};

// linear elements: mass 4 on the diagonal, 1 beside it
TEST(Doubts, NameInertiaThatConsistentMassShares) {
    EXPECT_TRUE(doubts(row_of_nodes(0.0), names).empty());
    EXPECT_EQ(most_shared_inertia(contact_compliance(row_of_nodes(0.0))).share, 0.0);
    const std::vector<base::Problem> found = doubts(row_of_nodes(1.0), names);
    ASSERT_EQ(found.size(), 1U);
    // of the inverse, times its determinant of 209: 60 on the diagonal in the middle and -16 beside
    EXPECT_EQ(found[0].what, "inertia couples b and c by 0.27 of their own");
    EXPECT_NE(found[0].suggestion.find("--inertia lumped"), std::string::npos);
}

// what they share is a body that is rigid by right
TEST(Doubts, AreNoneOfJointsOnOnePlate) {
    const std::vector<PlateJoint> joints(2);
    const Structure structure = joints_on_plate(joints, {});
    const SharedInertia shared = most_shared_inertia(contact_compliance(structure));
    EXPECT_NEAR(shared.share, 0.2, 1e-12);  // 1/0.4 of 1/0.1 + 1/0.4
    EXPECT_EQ(shared.second, 1U);
    EXPECT_TRUE(doubts(structure, {"a", "b"}).empty());
}

TEST(Doubts, NameModesThatRunAwayAndRowsWithoutMass) {
    Structure structure = row_of_nodes(0.0);
    structure.stiffness(3, 3) = -0.1;
    const std::vector<base::Problem> found = doubts(structure, names);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].what, "1 mode of the structure has negative stiffness");
    structure.contacts[1].tangent.setZero();
    EXPECT_EQ(doubts(structure, names)[0].what, "the tangent of b moves no mass");
}

}  // namespace
}  // namespace stridor::model
