#include "stridor/model/built/case_structure.hpp"

#include "stridor/base/error.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/model/contact/static_contact.hpp"
#include "stridor/model/linear/modal_damping.hpp"
#include "stridor/parameters/own_structure.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace stridor::model {
namespace {

using parameters::OwnStructure;

constexpr double rounding = 1e-14;  // of numbers of one, solved with a stiffness of condition 5

// two unit masses on unit springs across a surface, tied by a spring of 2; each with a contact
OwnStructure two_masses() {
    OwnStructure own;
    own.row = {"y1", "y2"};
    own.mass = {1.0, 0.0, 0.0, 1.0};
    own.stiffness = {3.0, -2.0, -2.0, 3.0};
    own.contacts = {{.name = "one", .normal = {1.0, 0.0}, .tangent = {0.0, 0.5}},
                    {.name = "two", .normal = {0.0, 1.0}, .tangent = {0.5, 0.0}}};
    return own;
}

parameters::Case case_of(const OwnStructure& own) {
    parameters::Case c;
    c.own_structure = std::make_shared<const OwnStructure>(own);
    return c;
}

TEST(CaseStructure, OfJointsIsTheRubbingSystem) {
    const parameters::Case c;
    EXPECT_EQ(structure_of(c).stiffness, rubbing_system(c).stiffness);
    EXPECT_EQ(channels_of(structure_of(c)), 3);
}

TEST(CaseStructure, IsPressedByItsSharesOfThePreload) {
    OwnStructure own = two_masses();
    own.contacts[0].preload_share = 3.0;
    own.contacts[1].preload_share = 1.0;
    own.contacts[1].kinetic_friction = 0.1;
    parameters::Case c = case_of(own);
    c.contact().preload = 8.0;
    const Structure structure = structure_of(c);
    EXPECT_EQ(structure.load, Eigen::Vector2d(-6.0, -2.0));
    EXPECT_EQ(slip_ratio(structure.contacts[0].friction, Slip::forward), -0.6);
    EXPECT_EQ(slip_ratio(structure.contacts[1].friction, Slip::forward), -0.1);
    EXPECT_EQ(channels_of(structure), 4);
    c.structure_scales.stiffness = 2.0;
    EXPECT_EQ(structure_of(c).stiffness(0, 1), -4.0);
}

TEST(CaseStructure, HasSpringsThatBearTheirShareOfThePreloadAtRest) {
    OwnStructure own = two_masses();
    own.springs = {{.name = "rubber", .direction = {1.0, 0.0}, .stiffness = 2.0, .cubic = 3.0, .preload_share = 0.5},
                   {.name = "free", .direction = {0.0, 1.0}, .cubic = 3.0}};
    own.contacts[0].preload_share = own.contacts[1].preload_share = 1.0;
    parameters::Case c = case_of(own);
    c.contact().preload = 20.0;
    const Structure structure = structure_of(c);
    ASSERT_EQ(structure.springs.size(), 2U);
    // 2 e + 3 e³ = 10
    const double e = structure.springs[0].rest;
    EXPECT_NEAR(2.0 * e + force_of(structure.springs[0].law, e), 10.0, 1e-12);
    EXPECT_NEAR(2.0 * e + 3.0 * e * e * e, 10.0, 1e-12);
    EXPECT_EQ(structure.springs[1].rest, 0.0);
    EXPECT_EQ(structure.stiffness(0, 0), 5.0);
}

TEST(CaseStructure, RestsWhereALoadPressesIt) {
    OwnStructure own = two_masses();
    own.load = {-5.0, 0.0};
    own.contacts[1].initial_gap = 0.25;
    // the first is held: the second is pulled to -2/3 of nothing, so it stays where it is
    Structure structure = structure_of(case_of(own));
    EXPECT_NEAR(structure.contacts[1].initial_gap, 0.25, rounding);
    EXPECT_NEAR(structure.load(0), -5.0, rounding);
    // a gap of its own that is closed by a load on itself: 3 (-1/4) = -1 + N - 2 u1
    own.load = {-5.0, -1.0};
    structure = structure_of(case_of(own));
    EXPECT_EQ(structure.contacts[0].initial_gap, 0.0);
    EXPECT_EQ(structure.contacts[1].initial_gap, 0.0);
    EXPECT_NEAR(structure.load(0), -5.5, rounding);  // N1 = 5 + 2/4
    EXPECT_NEAR(structure.load(1), -0.25, rounding);
    own.load = {5.0, 5.0};
    EXPECT_THROW(structure_of(case_of(own)), Error);
}

TEST(CaseStructure, RestsWhereGapsPressIt) {
    OwnStructure own = two_masses();
    own.contacts[0].initial_gap = -1.0;
    own.contacts[1].initial_gap = -0.5;
    // u = (1, 0.5) would pull at the second: 3/2 - 2 < 0; it opens by 2/3 - 1/2
    const Structure structure = structure_of(case_of(own));
    EXPECT_EQ(structure.contacts[0].initial_gap, 0.0);
    EXPECT_NEAR(structure.contacts[1].initial_gap, 1.0 / 6.0, rounding);
    EXPECT_NEAR(structure.load(0), -(3.0 - 4.0 / 3.0), rounding);
    EXPECT_EQ(structure.load(1), 0.0);
}

TEST(StaticContact, RefusesWhatNothingHolds) {
    Structure structure = structure_of_size(1);
    structure.contacts.front().normal << 1.0;
    structure.load << -1.0;
    EXPECT_THROW(static_contact(structure), Error);
}

TEST(ModalDamping, GivesEachModeItsShare) {
    const Eigen::Matrix2d mass{{2.0, 0.5}, {0.5, 1.0}};
    const Eigen::Matrix2d stiffness{{5.0, -1.0}, {-1.0, 3.0}};
    const Eigen::MatrixXd damping = modal_damping(mass, stiffness, 0.1);
    // C M^-1 C = (2 zeta)^2 K where all modes have one share: M^-1/2 C M^-1/2 is 2 zeta times the root of K
    const Eigen::Matrix2d squared = damping * mass.inverse() * damping;
    EXPECT_LT((squared - 0.04 * stiffness).cwiseAbs().maxCoeff(), rounding);
}

TEST(OwnStructure, HasTheHashOfItsNumbers) {
    OwnStructure own = two_masses();
    const std::string hash = content_hash(own);
    own.origin = "elsewhere";
    own.contacts[0].name = "other";
    EXPECT_EQ(content_hash(own), hash);
    own.contacts[0].static_friction = 0.0;
    EXPECT_NE(content_hash(own), hash);
    own = two_masses();
    own.mass[3] = 1.0 + 1e-15;
    EXPECT_NE(content_hash(own), hash);
}

}  // namespace
}  // namespace stridor::model
