#include "stridor/analysis/alternation.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stridor::analysis {
namespace {

using enum model::ContactState;

constexpr double parting = std::numeric_limits<double>::quiet_NaN();

// appends instants after those that are there: `last` + the running sum of the intervals
void append(record::Instants& instants, double first, const std::vector<double>& intervals) {
    double time = first;
    instants.times.push_back(time);
    for (const double interval : intervals)
        instants.times.push_back(time += interval);
    instants.count = static_cast<long>(instants.times.size());
}

record::ContactTally tally_with(const std::vector<double>& intervals, model::ContactState from = slip,
                                model::ContactState to = stick, double first = 0.5) {
    record::ContactTally tally;
    append(tally.changes[record::change_kind(from, to)], first, intervals);
    return tally;
}

std::vector<double> repeated(const std::vector<double>& pattern, int times) {
    std::vector<double> all;
    for (int k = 0; k < times; ++k)
        all.insert(all.end(), pattern.begin(), pattern.end());
    return all;
}

// intervals of a Poisson process: nothing repeats
std::vector<double> random_intervals(int count) {
    std::vector<double> intervals;
    for (int k = 0; k < count; ++k)
        intervals.push_back(-std::log(0.5 * (1.0 + *support::signed_fraction()) + 1e-9));
    return intervals;
}

TEST(Alternation, OfEqualBeatsIsPerfectlyRegular) {
    const Alternation result = alternation(tally_with(repeated({0.002}, 50)).changes);
    EXPECT_EQ(result.from, slip);
    EXPECT_EQ(result.to, stick);
    EXPECT_EQ(result.intervals, 50);
    EXPECT_EQ(result.lag, 1);
    // instants up to 0.6 s are rounded to 1e-16 s, 1e-13 of an interval
    EXPECT_NEAR(result.regularity, 1.0, 1e-12);
    EXPECT_NEAR(result.repetition, 1.0, 1e-12);
    EXPECT_NEAR(result.variation, 0.0, 1e-12);
    EXPECT_NEAR(result.period, 0.002, 1e-15);
    EXPECT_NEAR(result.frequency, 500.0, 1e-9);
}

// k unlike beats, again and again: the pattern repeats at lag k and at no smaller one
TEST(Alternation, OfUnequalBeatsRepeatsAtTheLengthOfThePattern) {
    for (int beats = 2; beats <= static_cast<int>(largest_lag); ++beats) {
        std::vector<double> pattern;
        double period = 0.0;
        for (int k = 0; k < beats; ++k) {
            pattern.push_back(1.0 + 0.05 * k + (k % 2 == 0 ? 0.0 : 1.0));
            period += pattern.back();
        }
        const Alternation result = alternation(tally_with(repeated(pattern, 20)).changes);
        EXPECT_EQ(result.lag, beats);
        EXPECT_NEAR(result.repetition, 1.0, 1e-12);
        EXPECT_NEAR(result.mismatch[static_cast<std::size_t>(beats) - 1].mean, 0.0, 1e-12);
        EXPECT_NEAR(result.period, period, 1e-12 * period);
        EXPECT_NEAR(result.frequency, beats / period, 1e-12);
        EXPECT_LT(result.regularity, 0.8);
    }
}

RC_GTEST_PROP(Alternation, OfAnyPatternRepeatsAtItsLength, ()) {
    const int beats = *support::whole_between(1, static_cast<int>(largest_lag));
    std::vector<double> pattern;
    for (int k = 0; k < beats; ++k)
        pattern.push_back(*support::number_between(0.1, 2.0));
    const Alternation result = alternation(tally_with(repeated(pattern, 12)).changes);
    RC_ASSERT(result.repetition > 1.0 - 1e-12);
    RC_ASSERT(result.lag <= beats);
}

RC_GTEST_PROP(Alternation, OfARandomSequenceIsIrregular, ()) {
    const Alternation result = alternation(tally_with(random_intervals(400)).changes);
    // |d - d'| of a Poisson process is one mean interval on average, 1/20 its scatter over 400:
    // m = 1 +- 0.05 at each lag
    RC_ASSERT(result.regularity < 0.3);
    RC_ASSERT(result.repetition < 0.4);
    RC_ASSERT(result.lag == 1);
    // a mean interval where nothing repeats
    RC_ASSERT(std::abs(result.period * result.frequency - 1.0) < 1e-12);
}

// the figures do not depend on when it happens or how fast, as long as all can be heard
RC_GTEST_PROP(Alternation, IsFreeOfScale, ()) {
    std::vector<double> slow = random_intervals(30);
    for (double& interval : slow)
        interval += 0x1p10 * shortest_interval;
    std::vector<double> fast = slow;
    for (double& interval : fast)
        interval *= 0x1p-10;
    const Alternation one = alternation(tally_with(slow, slip, stick, 0.0).changes);
    const Alternation other = alternation(tally_with(fast, slip, stick, 0.0).changes);
    RC_ASSERT(one.regularity == other.regularity);
    RC_ASSERT(one.repetition == other.repetition);
    RC_ASSERT(one.variation == other.variation);
    RC_ASSERT(one.lag == other.lag);
    RC_ASSERT(one.period * 0x1p-10 == other.period);
}

// some bounces at the end of each beat, never as many, and faster than anyone hears
TEST(Alternation, TakesABurstForOneBeat) {
    std::vector<double> intervals;
    for (int beat = 0; beat < 40; ++beat) {
        const int bounces = beat % 3;
        intervals.push_back(0.002 - 2e-5 * bounces);
        for (int bounce = 0; bounce < bounces; ++bounce)
            intervals.push_back(2e-5);
    }
    const Alternation result = alternation(tally_with(intervals).changes);
    EXPECT_NEAR(result.frequency, 500.0, 1.0);
    EXPECT_GT(result.regularity, 0.97);
}

// two judged stretches with a long pause between them: the pause is no interval
TEST(Alternation, IsCutAtReversals) {
    record::ContactTally tally = tally_with(repeated({0.002}, 10));
    record::Instants& instants = tally.changes[record::change_kind(slip, stick)];
    instants.times.push_back(parting);
    append(instants, 7.0, repeated({0.002}, 10));
    instants.times.push_back(parting);
    instants.times.push_back(parting);
    append(instants, 13.0, repeated({0.002}, 10));
    const Alternation result = alternation(tally.changes);
    EXPECT_EQ(result.intervals, 30);
    EXPECT_NEAR(result.regularity, 1.0, 1e-10);
    EXPECT_NEAR(result.variation, 0.0, 1e-10);
    EXPECT_NEAR(result.period, 0.002, 1e-14);
}

// a pair of intervals never joins two stretches either: each holds one beat of its own length
TEST(Alternation, ComparesIntervalsWithinOneStretch) {
    record::ContactTally tally;
    record::Instants& instants = tally.changes[record::change_kind(slip, stick)];
    for (int k = 0; k < 10; ++k) {
        append(instants, 10.0 * k, repeated({k % 2 == 0 ? 0.002 : 0.004}, 5));
        instants.times.push_back(parting);
    }
    const Alternation result = alternation(tally.changes);
    EXPECT_EQ(result.intervals, 50);
    EXPECT_NEAR(result.regularity, 1.0, 1e-10);
    EXPECT_NEAR(result.variation, 1.0 / 3.0, 1e-10);
}

// intervals of 1 and 2 in turn: mean 1.5, deviation 0.5
TEST(Variation, IsTheCoefficientOfTheIntervals) {
    const Alternation result = alternation(tally_with(repeated({1.0, 2.0}, 10)).changes);
    EXPECT_NEAR(result.variation, 1.0 / 3.0, 1e-14);
    EXPECT_NEAR(result.regularity, 1.0 - 1.0 / 1.5, 1e-14);
    EXPECT_EQ(result.lag, 2);
}

// slowly drifting beats are regular to the ear, though their variation is large
TEST(Regularity, ForgivesASlowDrift) {
    std::vector<double> drifting;
    for (int k = 0; k < 100; ++k)
        drifting.push_back(std::exp(0.01 * k));
    const Alternation result = alternation(tally_with(drifting).changes);
    EXPECT_GT(result.regularity, 0.98);
    EXPECT_GT(result.variation, 0.25);
}

// a cycle holds three unlike impacts (separation -> slip) and one lift-off from stick: the latter tells the beat
TEST(Regularity, IsThatOfTheMostRegularKindOfBeat) {
    record::ContactTally tally = tally_with(repeated({0.2, 0.3, 0.5}, 30), separation, slip);
    append(tally.changes[record::change_kind(stick, separation)], 0.9, repeated({1.0}, 29));
    const Alternation result = alternation(tally.changes);
    EXPECT_EQ(result.from, stick);
    EXPECT_EQ(result.to, separation);
    EXPECT_NEAR(result.regularity, 1.0, 1e-12);
    EXPECT_NEAR(result.period, 1.0, 1e-12);
}

// a few regular changes in one corner of the judged time do not speak for an irregular rest
TEST(Regularity, NeedsABeatThatCoversTheMotion) {
    std::vector<double> irregular;
    for (int k = 0; k < 100; ++k)
        irregular.push_back(k * k % 7 + 0.5);
    record::ContactTally tally = tally_with(irregular);
    append(tally.changes[record::change_kind(stick, separation)], 0.5, repeated({1.0}, 20));
    EXPECT_EQ(alternation(tally.changes).from, slip);
    EXPECT_LT(alternation(tally.changes).regularity, 0.5);
}

// 400 intervals of a Poisson process: |d - d'| has mean and deviation 1, so that the mean of 400 is known to 1/20, and
// 40 % more because neighbouring pairs share an interval; eight groups tell that to 27 %
RC_GTEST_PROP(MismatchError, IsAsLargeAsTheMismatchScatters, ()) {
    const Mismatch mismatch = alternation(tally_with(random_intervals(400)).changes).mismatch[0];
    RC_ASSERT(mismatch.error > 0.015);
    RC_ASSERT(mismatch.error < 0.16);
    RC_ASSERT(std::abs(mismatch.mean - 1.0) < 5.0 * 0.07);
}

TEST(MismatchError, OfAPatternThatRepeatsIsZero) {
    const Alternation result = alternation(tally_with(repeated({1.0, 2.0, 4.0}, 40)).changes);
    EXPECT_NEAR(result.mismatch[2].mean, 0.0, 1e-12);
    EXPECT_NEAR(result.mismatch[2].error, 0.0, 1e-12);
}

// a pattern must be seen three times before it is one
TEST(MismatchError, OfUnlikeStrokesIsHowFarTheyLieApart) {
    // one stroke of equal beats, and one whose neighbours differ by a third: m = (0 + 40/120) / 2 of equal means
    record::Changes changes;
    record::Instants& instants = changes[record::change_kind(slip, stick)];
    append(instants, 0.0, repeated({0.003}, 41));
    instants.times.push_back(parting);
    append(instants, 1.0, repeated({0.0025, 0.0035}, 21));
    const Mismatch neighbours = alternation(changes).mismatch[0];
    EXPECT_NEAR(neighbours.mean, 0.5 / 3.0, 0.01);  // of 40 and 41 pairs
    EXPECT_NEAR(neighbours.error, 0.5 / 3.0, 0.01);
}

TEST(Alternation, ComparesNoLagThatIsSeenOnlyTwice) {
    const std::vector<double> thrice = repeated({1.0, 2.0, 4.0, 8.0, 3.0}, 3);
    const std::vector<double> nearly(thrice.begin(), thrice.end() - 1);
    EXPECT_NEAR(alternation(tally_with(thrice).changes).mismatch[4].mean, 0.0, 1e-12);
    EXPECT_TRUE(std::isinf(alternation(tally_with(nearly).changes).mismatch[4].mean));
}

TEST(LeastMismatch, IsThatOfTheFirstLags) {
    const Alternation result = alternation(tally_with(repeated({1.0, 2.0, 4.0}, 40)).changes);
    EXPECT_EQ(least_mismatch(result, 2).mean, std::min(result.mismatch[0].mean, result.mismatch[1].mean));
    EXPECT_EQ(least_mismatch(result, largest_lag).mean, least_mismatch(result, 3).mean);
}

TEST(Alternation, OfNothingIsUnknown) {
    for (const record::ContactTally& tally : {record::ContactTally{}, tally_with({})}) {
        const Alternation result = alternation(tally.changes);
        EXPECT_EQ(result.intervals, 0);
        EXPECT_TRUE(std::isnan(result.regularity));
        EXPECT_TRUE(std::isnan(result.repetition));
        EXPECT_TRUE(std::isnan(result.period));
        EXPECT_TRUE(std::isnan(result.frequency));
    }
}

// a lag is judged from three pairs at least
TEST(Alternation, OfTooFewIntervalsHasNoRegularity) {
    EXPECT_TRUE(std::isnan(alternation(tally_with(repeated({1.0}, 3)).changes).regularity));
    EXPECT_EQ(alternation(tally_with(repeated({1.0}, 3)).changes).period, 1.0);
    EXPECT_EQ(alternation(tally_with(repeated({1.0}, 4)).changes).regularity, 1.0);
}

}  // namespace
}  // namespace stridor::analysis
