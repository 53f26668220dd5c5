#include "stridor/integration/exact/contact_coordinates.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

using model::Structure;

// any positive definite mass, any normal and a tangent that is not along it
Structure any_structure() {
    const auto any = [] {
        Eigen::Matrix3d m;
        for (int i = 0; i < 9; ++i)
            m(i / 3, i % 3) = *support::signed_fraction();
        return m;
    };
    Structure s = model::structure_of_size(3);
    const Eigen::Matrix3d a = any(), b = any(), c = any();
    s.mass = a * a.transpose() + 0.2 * Eigen::Matrix3d::Identity();
    s.stiffness = b * b.transpose();
    s.damping = c * c.transpose();
    s.contacts[0].normal << 0.3, 1.0, *support::signed_fraction();
    s.contacts[0].tangent << 1.0, 0.2 * *support::signed_fraction(), *support::signed_fraction();
    s.load << 0.0, -7.0, 3.0;
    return s;
}

RC_GTEST_PROP(ContactCoordinates, DecoupleTheMasses, ()) {
    const Structure s = any_structure();
    const auto c = contact_coordinates(model::SizedStructure<3>(s, s.contacts[0]));
    const Eigen::Matrix3d mass = c.basis.transpose() * s.mass * c.basis;
    const double rounding = 1e-13 * mass.norm() * (1.0 + c.basis.squaredNorm());
    RC_ASSERT((mass - Eigen::Matrix3d(c.mass.asDiagonal())).norm() < rounding);
    RC_ASSERT(c.mass.minCoeff() > 0.0);
}

RC_GTEST_PROP(ContactCoordinates, AreTangentialPositionWhatIsUnseenAndGap, ()) {
    const Structure s = any_structure();
    const auto c = contact_coordinates(model::SizedStructure<3>(s, s.contacts[0]));
    const double rounding =
        1e-14 * (1.0 + c.basis.norm()) * (s.contacts[0].normal.norm() + s.contacts[0].tangent.norm());
    RC_ASSERT((s.contacts[0].normal.transpose() * c.basis - Eigen::RowVector3d(0.0, 0.0, 1.0)).norm() < rounding);
    RC_ASSERT((s.contacts[0].tangent.transpose() * c.basis - Eigen::RowVector3d(1.0, 0.0, c.tangent_on_gap)).norm() <
              rounding);
}

// in contact, y is the centre of mass of joint and plate; the gap opens about it
TEST(ContactCoordinates, OfThePapersSystemAreCentreOfMassAndGap) {
    parameters::Case given;
    given.joint().mass = 0.1;
    given.plate.mass = 0.4;
    const auto structure = model::rubbing_system(given);
    const auto c = contact_coordinates(model::SizedStructure<3>(structure, structure.contacts[0]));
    Eigen::Matrix3d expected;
    expected << 1, 0, 0, 0, 1, 0.8, 0, 1, -0.2;
    EXPECT_LT((c.basis - expected).norm(), 1e-15);
    EXPECT_LT((c.mass - Eigen::Vector3d(0.1, 0.5, 0.08)).norm(), 1e-15);  // 0.1 0.4 / 0.5: the reduced mass
    EXPECT_EQ(c.tangent_on_gap, 0.0);
    EXPECT_EQ(c.load_scale, given.contact().preload);
    EXPECT_LT((c.load - Eigen::Vector3d(0.0, 0.0, -1.0)).norm(), 1e-15);
}

TEST(ContactCoordinates, OfTheBeltAreItsOwn) {
    const auto belt = model::mass_on_belt({2.0, 50.0, 3.0, 10.0, {0.5, 0.4}});
    const auto c = contact_coordinates(model::SizedStructure<2>(belt, belt.contacts[0]));
    EXPECT_EQ(c.basis, Eigen::Matrix2d::Identity());
    EXPECT_EQ(c.mass, Eigen::Vector2d(2.0, 2.0));
    EXPECT_EQ(c.stiffness(0, 0), 50.0);
    EXPECT_EQ(c.damping(0, 0), 3.0);
    EXPECT_EQ(c.load_scale, 10.0);
}

}  // namespace
}  // namespace stridor::integration
