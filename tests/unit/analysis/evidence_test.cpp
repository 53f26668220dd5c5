#include "stridor/analysis/evidence.hpp"

#include <gtest/gtest.h>

namespace stridor::analysis {
namespace {

TEST(Evidence, KeepsWholeAndJudgedTimeApart) {
    record::Tally tally;
    tally.phase = record::Phase::coming;
    tally.time = {6.0, 1.0, 1.0};
    tally.judged_time = {1.0, 3.0, 0.0};
    tally.vibration.resize(3);
    tally.vibration_time = 4.0;
    const Evidence figures = evidence(tally);
    EXPECT_EQ(figures.phase, record::Phase::coming);
    EXPECT_EQ(figures.window_time, 8.0);
    EXPECT_EQ(figures.judged_time, 4.0);
    EXPECT_EQ(figures.rates.slip, 0.75);
    EXPECT_EQ(figures.judged_rates.stick, 0.75);
    EXPECT_EQ(figures.alternation.intervals, 0);
    EXPECT_EQ(figures.levels.joint.rms, 0.0);
}

}  // namespace
}  // namespace stridor::analysis
