#include "stridor/analysis/friction/risk.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::analysis {
namespace {

FrictionTrace trace_with_drops(long drops) {
    FrictionTrace trace;
    trace.all.moving_time = 10.0;
    trace.all.drops = drops;
    trace.all.drop_rate = 0.1 * static_cast<double>(drops);
    trace.all.largest_drop = 2.0;
    for (long k = 0; k < drops; ++k)
        trace.drops.push_back({0.1 * static_cast<double>(k), 0.01, 4.0, 2.0, 1});
    return trace;
}

TEST(RiskNumber, OfARunWithoutDropsIsOne) {
    const RiskNumber risk = risk_number(trace_with_drops(0), {});
    EXPECT_EQ(risk.number, 1);
    EXPECT_EQ(risk.figures[0], 0.0);
    EXPECT_EQ(risk_word(risk.number), "quiet");
}

TEST(RiskNumber, IsThatOfTheWorstFigure) {
    // 36 drops from 4 to 2 N in 10 s: 2/(2 m), 3.6 1/s, (16 - 4)/(2 k) 3.6 1/s
    const RiskNumber risk = risk_number(trace_with_drops(36), {0.1, 2000.0});
    EXPECT_DOUBLE_EQ(risk.figures[0], 10.0);
    EXPECT_DOUBLE_EQ(risk.figures[1], 3.6);
    EXPECT_NEAR(risk.figures[2], 0.0108, 1e-12);
    EXPECT_DOUBLE_EQ(risk.ranks[0], 10.0);
    EXPECT_NEAR(risk.ranks[1], 1.0 + 3.0 * std::log10(36.0), 1e-12);  // three decades are nine ranks
    EXPECT_EQ(risk.number, 10);
    EXPECT_EQ(risk_word(risk.number), "noise");
}

TEST(RiskNumber, LeavesOutWhatNeedsARigThatIsNotKnown) {
    const RiskNumber risk = risk_number(trace_with_drops(36), {});
    EXPECT_TRUE(std::isnan(risk.ranks[0]));
    EXPECT_TRUE(std::isnan(risk.ranks[2]));
    EXPECT_EQ(risk.number, 6);  // 5.67, rounded up
}

TEST(RiskRank, RisesByTheLogarithmBetweenItsEnds) {
    const RiskScale scale{"x", "1", "", 1.0, 1000.0};
    EXPECT_EQ(risk_rank(0.0, scale), 1.0);
    EXPECT_EQ(risk_rank(1.0, scale), 1.0);
    EXPECT_DOUBLE_EQ(risk_rank(10.0, scale), 4.0);
    EXPECT_DOUBLE_EQ(risk_rank(1000.0, scale), 10.0);
    EXPECT_EQ(risk_rank(1e9, scale), 10.0);
    EXPECT_EQ(risk_word(4), "may be heard");
}

}  // namespace
}  // namespace stridor::analysis
