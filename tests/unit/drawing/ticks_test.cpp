#include "stridor/drawing/ticks.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::drawing {
namespace {

PanelAxis axis(double from, double to, AxisScale scale = AxisScale::linear) {
    PanelAxis result;
    result.scale = scale;
    result.range = {from, to};
    return result;
}

std::vector<std::string> labels(const TickSet& set) {
    std::vector<std::string> texts;
    for (const Tick& tick : set.ticks)
        if (tick.size == TickSize::major) texts.push_back(plain_text(tick.label));
    return texts;
}

TEST(Ticks, StandAtRoundNumbers) {
    EXPECT_EQ(labels(ticks(axis(0.0, 1.0), 60.0, 12.0)),
              (std::vector<std::string>{"0.0", "0.2", "0.4", "0.6", "0.8", "1.0"}));
    EXPECT_EQ(labels(ticks(axis(-0.13, 0.13), 20.0, 6.0)), (std::vector<std::string>{"−0.1", "0.0", "0.1"}));
}

TEST(Ticks, OfALogarithmicAxisStandAtDecades) {
    const TickSet set = ticks(axis(2.0, 4000.0, AxisScale::logarithmic), 60.0, 12.0);
    EXPECT_EQ(labels(set), (std::vector<std::string>{"10", "100", "1000"}));
    // 2 ... 9, then three decades of nine each, up to 4000
    EXPECT_EQ(set.ticks.size(), 8U + 9U + 9U + 4U);
}

TEST(Ticks, OfALogarithmicAxisWithoutADecadeAreStillNumbered) {
    EXPECT_GE(labels(ticks(axis(11.0, 19.0, AxisScale::logarithmic), 60.0, 12.0)).size(), 2U);
}

TEST(Ticks, CountLargeAndSmallNumbersInPowersOfTen) {
    const TickSet large = ticks(axis(-250e3, 0.0), 20.0, 6.0);
    EXPECT_EQ(large.exponent, 3);
    EXPECT_EQ(labels(large), (std::vector<std::string>{"−200", "−100", "0"}));
    EXPECT_EQ(ticks(axis(0.0, 2e-5), 20.0, 6.0).exponent, -6);
    EXPECT_EQ(ticks(axis(0.0, 5000.0), 20.0, 6.0).exponent, 0);
}

TEST(Ticks, ThatAnAxisBringsAlongAreKept) {
    PanelAxis given = axis(0.0, 3.0);
    given.ticks = {{0.5, "slip", TickSize::major}, {1.5, "stick", TickSize::major}};
    EXPECT_EQ(labels(ticks(given, 60.0, 12.0)), (std::vector<std::string>{"slip", "stick"}));
}

RC_GTEST_PROP(Ticks, LieOnTheAxisAndAreAtLeastTwo, ()) {
    const double from = *support::number_between(-1e5, 1e5);
    const double span = std::pow(10.0, *support::number_between(-3.0, 5.0));
    const double length = *support::number_between(8.0, 150.0);
    const TickSet set = ticks(axis(from, from + span), length, 6.0);
    RC_ASSERT(set.ticks.size() >= 2U);
    for (const Tick& tick : set.ticks) {
        // rounding of k * step against the range's end
        RC_ASSERT(tick.value >= from - 1e-6 * span);
        RC_ASSERT(tick.value <= from + span + 1e-6 * span);
    }
}

RC_GTEST_PROP(Position, IsUndoneByValueAtPosition, ()) {
    const AxisScale scale = *rc::gen::element(AxisScale::linear, AxisScale::logarithmic);
    const PanelAxis given = axis(0.5, 80.0, scale);
    const double share = *support::number_between(0.0, 1.0);
    RC_ASSERT(std::abs(position(given, value_at_position(given, share)) - share) < 1e-12);
}

TEST(AxisTitle, HoldsUnitAndPowerOfTen) {
    EXPECT_EQ(plain_text(axis_title("preload", "N", 0)), "preload [N]");
    EXPECT_EQ(plain_text(axis_title("acceleration", "m/s^2", 3)), "acceleration [103 m/s2]");
    EXPECT_EQ(plain_text(axis_title("ratio", "1", 0)), "ratio");
}

}  // namespace
}  // namespace stridor::drawing
