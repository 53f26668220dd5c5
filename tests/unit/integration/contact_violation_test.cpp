#include "stridor/integration/rules/set_search.hpp"

#include <gtest/gtest.h>

namespace stridor::integration {
namespace {

// mu_s = 0.8 and mu_d = 0.5
const ModalContact law{{}, {}, 0.0, 1.0, model::Coulomb{0.8, 0.5}};
const TrialScale scale{.push = 10.0, .speed = 1.0, .rounding = 1e-10};

ContactViolation of(const TriedContact& contact) {
    return violation(law, contact, scale);
}

TEST(ContactViolation, IsNoneWhereAllLawsHold) {
    EXPECT_EQ(of({.mode = ContactMode::open, .gap_velocity = 0.1}).size, 0.0);
    EXPECT_EQ(of({.mode = ContactMode::stick, .normal = 10.0, .tangential = 7.9}).size, 0.0);
    EXPECT_EQ(of({.mode = ContactMode::slip_forward, .normal = 10.0, .slip_velocity = 0.2}).size, 0.0);
    EXPECT_EQ(of({.mode = ContactMode::slip_backward, .normal = 10.0, .slip_velocity = -0.2}).size, 0.0);
}

TEST(ContactViolation, SaysWhatTheContactShouldDo) {
    const ContactViolation closes = of({.mode = ContactMode::open, .gap_velocity = -0.1});
    EXPECT_EQ(closes.mode, ContactMode::stick);
    EXPECT_DOUBLE_EQ(closes.size, 0.1);
    EXPECT_EQ(of({.mode = ContactMode::slip_forward, .normal = -1.0, .slip_velocity = 0.1}).mode, ContactMode::open);
    EXPECT_EQ(of({.mode = ContactMode::slip_forward, .normal = 10.0, .slip_velocity = -0.1}).mode, ContactMode::stick);
    const ContactViolation slips = of({.mode = ContactMode::stick, .normal = 10.0, .tangential = 9.0});
    EXPECT_EQ(slips.mode, ContactMode::slip_backward);
    EXPECT_DOUBLE_EQ(slips.size, 0.1);
    EXPECT_EQ(of({.mode = ContactMode::stick, .normal = 10.0, .tangential = -9.0}).mode, ContactMode::slip_forward);
}

TEST(ContactViolation, HoldsALimitThatFellAgainstTheSlipsRatio) {
    const TriedContact whole{.mode = ContactMode::stick, .normal = 10.0, .tangential = 6.0};
    EXPECT_EQ(of(whole).size, 0.0);
    TriedContact fallen = whole;
    fallen.limit = StickLimit::fallen;
    EXPECT_EQ(of(fallen).mode, ContactMode::slip_backward);
    EXPECT_DOUBLE_EQ(of(fallen).size, 0.1);
}

TEST(ContactViolation, AddsWhatRestHasAddedToALimitThatHolds) {
    TriedContact rested{.mode = ContactMode::stick, .normal = 10.0, .tangential = 9.0};
    EXPECT_EQ(of(rested).mode, ContactMode::slip_backward);
    rested.grown = 0.15;
    EXPECT_EQ(of(rested).size, 0.0);
    rested.limit = StickLimit::fallen;
    EXPECT_EQ(of(rested).mode, ContactMode::slip_backward);
}

TEST(ContactViolation, PassesOverRounding) {
    EXPECT_EQ(of({.mode = ContactMode::open, .gap_velocity = -1e-11}).size, 0.0);
    EXPECT_EQ(of({.mode = ContactMode::stick, .normal = -1e-10}).size, 0.0);
}

}  // namespace
}  // namespace stridor::integration
