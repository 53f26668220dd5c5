#include "stridor/integration/rules/painleve.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

using Possible = std::vector<std::vector<ContactMode>>;
constexpr ContactMode open = ContactMode::open;
constexpr ContactMode back = ContactMode::slip_backward;
constexpr ContactMode forward = ContactMode::slip_forward;

ModalContact rubbing(double friction) {
    ModalContact contact;
    contact.friction = model::Coulomb{friction, friction};
    return contact;
}

// W_nn + mu W_nt = 1 - 0.8 mu where it slips backward
const Eigen::Matrix2d one_contact{{1.0, -0.8}, {-0.8, 1.0}};

TEST(Painleve, IsWhereFrictionOutgrowsInertia) {
    EXPECT_EQ(pressed_contacts({rubbing(1.2)}, one_contact, {{back, open}}), std::vector<std::size_t>{});
    EXPECT_EQ(pressed_contacts({rubbing(1.25)}, one_contact, {{back, open}}), std::vector<std::size_t>{0});
    EXPECT_EQ(pressed_contacts({rubbing(1.3)}, one_contact, {{back, open}}), std::vector<std::size_t>{0});
}

TEST(Painleve, IsNotWhereTheContactCannotSlipThatWay) {
    EXPECT_TRUE(pressed_contacts({rubbing(1.3)}, one_contact, {{forward, open}}).empty());
    EXPECT_TRUE(pressed_contacts({rubbing(1.3)}, one_contact, {{ContactMode::stick, open}}).empty());
    EXPECT_TRUE(pressed_contacts({rubbing(1.3)}, one_contact, modes_of_touching({false})).empty());
    EXPECT_EQ(pressed_contacts({rubbing(1.3)}, one_contact, modes_of_touching({true})), std::vector<std::size_t>{0});
}

// each alone has W_nn + mu W_nt = 1, and friction of each presses the other: det [1 -1.5; -1.5 1] < 0
TEST(Painleve, MayNeedTwoContactsTogether) {
    Eigen::Matrix4d compliance = 4.0 * Eigen::Matrix4d::Identity();
    compliance(0, 0) = compliance(2, 2) = 1.0;
    compliance(0, 3) = compliance(3, 0) = compliance(1, 2) = compliance(2, 1) = -1.5;
    const std::vector<ModalContact> contacts{rubbing(1.0), rubbing(1.0)};
    EXPECT_EQ(pressed_contacts(contacts, compliance, {{back, open}, {back, open}}), (std::vector<std::size_t>{0, 1}));
    EXPECT_TRUE(pressed_contacts(contacts, compliance, {{back, open}, {open}}).empty());
    EXPECT_TRUE(pressed_contacts(contacts, compliance, {{back, open}, {forward, open}}).empty());
}

// rows that depend on each other have no determinant either way: not friction's doing
TEST(Painleve, IsNotWhereContactsDependOnEachOther) {
    const Eigen::Matrix4d twice{{1.0, 0.0, 1.0, 0.0}, {0.0, 1.0, 0.0, 1.0}, {1.0, 0.0, 1.0, 0.0}, {0.0, 1.0, 0.0, 1.0}};
    EXPECT_TRUE(pressed_contacts({rubbing(0.5), rubbing(0.5)}, twice, {{back, open}, {back, open}}).empty());
}

}  // namespace
}  // namespace stridor::integration
