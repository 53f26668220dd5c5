#include "stridor/analysis/share_errors.hpp"

#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace stridor::analysis {
namespace {

using record::StretchTimes;

// a stretch whose parts of 1 s slip for these shares and stick for the rest
StretchTimes stretch(const std::array<double, record::stretch_parts>& slip) {
    StretchTimes times{};
    for (std::size_t part = 0; part < slip.size(); ++part)
        times.at(part) = {slip.at(part), 1.0 - slip.at(part), 0.0};
    return times;
}

record::ContactTally tally_of(const std::vector<StretchTimes>& stretches) {
    record::ContactTally tally;
    tally.stretches = stretches;
    tally.judged_stretches = static_cast<long>(stretches.size());
    return tally;
}

TEST(ShareErrors, OfAShareThatNeverChangesAreZero) {
    for (const std::size_t count : {1U, 2U, 4U, 8U}) {
        const Rates errors =
            share_errors(tally_of(std::vector(count, stretch({0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25, 0.25}))));
        EXPECT_NEAR(errors.slip, 0.0, 1e-15);
        EXPECT_NEAR(errors.stick, 0.0, 1e-15);
        EXPECT_EQ(errors.separation, 0.0);
    }
}

// eight groups of 0 or 1 in turn: deviations 1/2, variance 8/4/7 of one, over 8 of them
TEST(ShareErrors, OfOneStretchAreThoseOfTheMeanOfItsParts) {
    const Rates errors = share_errors(tally_of({stretch({0, 1, 0, 1, 0, 1, 0, 1})}));
    EXPECT_NEAR(errors.slip, std::sqrt(2.0 / 7.0 / 8.0), 1e-15);
    EXPECT_NEAR(errors.stick, errors.slip, 1e-15);
}

// a share that follows the velocity of the drive alike in every stretch is no scatter
TEST(ShareErrors, LeaveOutWhatEveryStretchDoes) {
    const StretchTimes rising = stretch({0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8});
    EXPECT_GT(share_errors(tally_of({rising})).slip, 0.05);
    for (const std::size_t count : {2U, 3U, 4U, 5U})
        EXPECT_NEAR(share_errors(tally_of(std::vector(count, rising))).slip, 0.0, 1e-15) << count;
}

// the error of so many independent random parts: that of their mean, as it scatters over many tries
TEST(ShareErrors, AreAsLargeAsTheSharesScatter) {
    for (const std::size_t count : {1U, 2U, 3U, 4U, 6U, 8U}) {
        SCOPED_TRACE(count);
        support::CounterRandom random(count);
        double told = 0.0, found = 0.0;
        constexpr int tries = 2000;
        for (int k = 0; k < tries; ++k) {
            std::vector<StretchTimes> stretches;
            double mean = 0.0;
            for (std::size_t n = 0; n < count; ++n) {
                std::array<double, record::stretch_parts> slip{};
                for (double& share : slip) {
                    share = random.between(0.0, 1.0);
                    mean += share / static_cast<double>(count * slip.size());
                }
                stretches.push_back(stretch(slip));
            }
            const double error = share_errors(tally_of(stretches)).slip;
            told += error * error / tries;
            found += (mean - 0.5) * (mean - 0.5) / tries;
        }
        // a variance of 4 degrees of freedom from 2000 tries: 0.7 / sqrt(2000) = 1.6 %, and that of the shares 3.2 %
        EXPECT_NEAR(told / found, 1.0, 0.15);
    }
}

// the stretches that are not kept count, too
TEST(ShareErrors, FallWithTheNumberOfStretches) {
    record::ContactTally tally = tally_of({stretch({0, 0, 0, 0, 0, 0, 0, 0}), stretch({1, 1, 1, 1, 1, 1, 1, 1})});
    const double few = share_errors(tally).slip;
    tally.judged_stretches = 200;
    EXPECT_NEAR(share_errors(tally).slip, 0.1 * few, 1e-15);
}

TEST(ShareErrors, OfAProvenCycleAreZero) {
    record::ContactTally tally = tally_of({stretch({0, 1, 0, 1, 0, 1, 0, 1})});
    tally.ending.outlook.future = record::Future::repeats;
    EXPECT_EQ(share_errors(tally).slip, 0.0);
}

TEST(ShareErrors, WithoutAStretchAreUnknown) {
    EXPECT_TRUE(std::isnan(share_errors({}).slip));
}

}  // namespace
}  // namespace stridor::analysis
