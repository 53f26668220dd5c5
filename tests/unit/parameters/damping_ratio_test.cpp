#include "stridor/parameters/tables/damping_ratio.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace stridor::parameters {
namespace {

void set(Case& c, std::string_view key, std::string_view text) {
    set_from_text(c, *find_field(key), text);
}

TEST(DampingRatio, IsAShareOfCriticalOfItsOwnSpringAndMass) {
    Case c;  // m1 = 0.1, k1i = 1e7, k1j = 1e6, m2 = 0.4, k2y = 1e6
    set(c, "joint.axial_damping", "15 %");
    set(c, "joint.flexural_damping", "damping ratio 0.02");
    set(c, "plate.damping", "loss factor 0.3");
    EXPECT_EQ(c.joint().axial_damping, 2.0 * 0.15 * std::sqrt(1e7 * 0.1));
    EXPECT_EQ(c.joint().flexural_damping, 2.0 * 0.02 * std::sqrt(1e6 * 0.1));
    // eta = 2 zeta: c = eta sqrt(k m); halving and doubling are exact
    EXPECT_EQ(c.plate.damping, 0.3 * std::sqrt(1e6 * 0.4));
}

TEST(DampingRatio, IsKeptWhenStiffnessOrMassChangeInAnyOrder) {
    Case first;
    set(first, "joint.axial_damping", "15 %");
    set(first, "joint.mass", "200 g");
    set(first, "joint.axial_stiffness", "3 kN/mm");
    Case last;
    set(last, "joint.axial_stiffness", "3 kN/mm");
    set(last, "joint.mass", "200 g");
    set(last, "joint.axial_damping", "15 %");
    EXPECT_EQ(first.joint().axial_damping, 2.0 * 0.15 * std::sqrt(3e6 * 0.2));
    EXPECT_EQ(first.joint().axial_damping, last.joint().axial_damping);
    EXPECT_EQ(first.joint().flexural_damping, Case{}.joint().flexural_damping);
    EXPECT_EQ(canonical_text(first), canonical_text(last));
}

TEST(DampingRatio, EndsWithADampingOfItsOwn) {
    Case c;
    set(c, "plate.damping", "5 %");
    EXPECT_EQ(value_text(c, *find_field("plate.damping")), "damping ratio 0.05");
    set(c, "plate.damping", "3 N*s/m");
    set(c, "plate.mass", "9 kg");
    EXPECT_EQ(c.plate.damping, 3.0);
    EXPECT_EQ(value_text(c, *find_field("plate.damping")), "3 N*s/m");
}

// along an axis over the stiffness a ratio is another design than a number, even where they agree
TEST(DampingRatio, StandsInTheCanonicalText) {
    Case ratio;
    set(ratio, "plate.damping", "5 %");
    Case number;
    number.plate.damping = ratio.plate.damping;
    EXPECT_NE(canonical_text(ratio), canonical_text(number));
    EXPECT_NE(canonical_text(ratio).find("plate.damping = damping ratio 0.05\n"), std::string::npos);
}

RC_GTEST_PROP(DampingRatio, ReadsBackAsTheSameNumber, ()) {
    const double ratio = std::abs(*support::signed_fraction());
    RC_ASSERT(parse_damping_ratio(damping_ratio_text(ratio)) == ratio);
}

TEST(DampingRatio, IsRefusedWhereItMakesNoSense) {
    const auto refused = [](std::string_view key, std::string_view text, const char* words) {
        const support::Thrown thrown = support::thrown_by([&] {
            Case c;
            set(c, key, text);
        });
        EXPECT_EQ(thrown.kind, ErrorKind::input) << text;
        EXPECT_TRUE(thrown.says(words)) << thrown.message;
    };
    refused("plate.damping", "-5 %", "between 0 and 10");
    refused("plate.damping", "1001 %", "between 0 and 10");
    refused("plate.damping", "loss factor 21", "between 0 and 10");
    refused("plate.damping", "loss factor much", "is not a number");
    refused("plate.damping", "damping ratio 3 N", "expected a plain number");
    refused("plate.mass", "15 %", "expected a mass");
    Case c;
    set(c, "title", "quiet by 15 %");
    EXPECT_EQ(c.title, "quiet by 15 %");
}

}  // namespace
}  // namespace stridor::parameters
