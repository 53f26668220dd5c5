// The closed forms by themselves; tests/verification holds the engines against them.

#include "stridor/verification/check.hpp"
#include "stridor/verification/single_mass.hpp"
#include "stridor/verification/table_1.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

namespace stridor::verification {
namespace {

TEST(Check, PassesWithinItsToleranceOnly) {
    EXPECT_TRUE((Check{"", 1.0, 1.25, 0.25}.passes()));
    EXPECT_TRUE((Check{"", 1.0, 0.75, 0.25}.passes()));
    EXPECT_FALSE((Check{"", 1.0, 1.26, 0.25}.passes()));
    EXPECT_FALSE((Check{"", 1.0, std::numeric_limits<double>::quiet_NaN(), 0.25}.passes()));
}

TEST(CheckGroups, HaveTitlesOfTheirOwnAndASource) {
    std::set<std::string_view> titles;
    for (const CheckGroup& group : check_groups()) {
        EXPECT_TRUE(titles.insert(group.title).second) << group.title;
        EXPECT_FALSE(group.source.empty()) << group.title;
    }
    EXPECT_EQ(titles.size(), 7U);
}

TEST(BeltClosedForm, GivesThePublishedStickFractions) {
    for (const auto& [lambda, fraction] : {std::pair{0.5, 0.157334}, {1.0, 0.297957}, {2.0, 0.495731}, {5.0, 0.738750}})
        EXPECT_NEAR(belt_stick_fraction(lambda), fraction, 5e-7);
}

TEST(BeltClosedForm, ShareIsThatOfItsTimes) {
    for (const double lambda : {0.01, 1.0, 100.0}) {
        const double stick = belt_stick_time(lambda, 300.0), slip = belt_slip_time(lambda, 300.0);
        EXPECT_NEAR(belt_period(lambda, 300.0), stick + slip, 1e-15 * (stick + slip));
        EXPECT_NEAR(belt_stick_fraction(lambda), stick / (stick + slip), 1e-15);
    }
}

TEST(DenHartogClosedForm, GivesThePublishedAmplitudes) {
    for (const DenHartog& each : den_hartog_motions)
        EXPECT_NEAR(den_hartog_amplitude(each.g, each.r), each.amplitude, 5e-7) << each.g << ' ' << each.r;
}

// Central differences with h: h^2 / 12 of the fourth derivative, rate^4 x, here 2e-6 m/s^2 (x is 2e-3 m); rounding of x
// to 1e-18 m over h^2, 1e-8 m/s^2.
TEST(DampedSlip, SolvesItsEquation) {
    const DampedSlip slip{2e-3, 0.3, 5.0, 99.0};
    constexpr double t = 0.04, h = 1e-5;
    const double before = displacement(slip, t - h), now = displacement(slip, t), after = displacement(slip, t + h);
    const double acceleration = (after - 2.0 * now + before) / (h * h), velocity = (after - before) / (2.0 * h);
    const double stiffness = slip.rate * slip.rate + slip.decay * slip.decay;  // [1/s^2] w0^2
    EXPECT_NEAR(acceleration + 2.0 * slip.decay * velocity + stiffness * (now - slip.equilibrium), 0.0, 2e-5);
    EXPECT_EQ(displacement(slip, 0.0), slip.equilibrium);
}

TEST(Table1, SharesAddUpToOne) {
    for (const Table1Column& column : table_1)
        for (const analysis::Rates& rates : column.rates)
            EXPECT_NEAR(rates.slip + rates.stick + rates.separation, 1.0, 1.01e-7);  // seven places each
}

}  // namespace
}  // namespace stridor::verification
