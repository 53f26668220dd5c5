#include "stridor/analysis/rates.hpp"

#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace stridor::analysis {
namespace {

TEST(Rates, AreSharesOfTheTotal) {
    const Rates shares = rates({1.0, 2.0, 5.0});  // slip, stick, separation
    EXPECT_EQ(shares.slip, 0.125);
    EXPECT_EQ(shares.stick, 0.25);
    EXPECT_EQ(shares.separation, 0.625);
}

TEST(Rates, OfNoTimeAreUnknown) {
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).slip));
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).stick));
    EXPECT_TRUE(std::isnan(rates({0.0, 0.0, 0.0}).separation));
}

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

// a judged time of 2 s; three contacts
record::Tally phase(const std::vector<record::Load>& loads, std::vector<double> free_together) {
    record::Tally tally;
    tally.contacts.resize(loads.size());
    record::InterfaceTally interface;
    for (std::size_t k = 0; k < loads.size(); ++k) {
        tally.contacts[k].load = loads[k];
        interface.contacts.push_back(k);
    }
    interface.state_time = {1.0, 0.5, 0.5, 0.0};
    interface.free_together = std::move(free_together);
    tally.interfaces = {interface};
    return tally;
}

TEST(Interface, WeighsItsContactsByWhatTheyCarry) {
    const Interface whole = interface_of(phase({{60.0, 4.0}, {39.4, 2.0}, {0.6, 0.0}}, {}), 0);
    EXPECT_EQ(whole.rates, (std::array{0.5, 0.25, 0.25, 0.0}));
    EXPECT_DOUBLE_EQ(whole.loads[0].normal_force, 30.0);
    EXPECT_DOUBLE_EQ(whole.loads[0].share, 0.6);
    EXPECT_DOUBLE_EQ(whole.loads[0].friction_power, 2.0);
    EXPECT_TRUE(whole.loads[1].is_loaded);
    EXPECT_FALSE(whole.loads[2].is_loaded);
}

TEST(Interface, OfManyEqualContactsHasNoUnloadedOnes) {
    const Interface whole = interface_of(phase(std::vector<record::Load>(300, {2.0, 1.0}), {}), 0);
    for (const CarriedLoad& load : whole.loads)
        EXPECT_TRUE(load.is_loaded);
}

TEST(Interface, OfWhichNoLoadIsKnownHasEqualShares) {
    const Interface whole = interface_of(phase(std::vector<record::Load>(4), {}), 0);
    EXPECT_DOUBLE_EQ(whole.loads[3].share, 0.25);
    EXPECT_TRUE(whole.loads[3].is_loaded);
}

TEST(Interface, SaysHowMuchOfTheLoadIsFreeAtOnce) {
    const std::vector<record::Load> loads{{50.0, 0.0}, {30.0, 0.0}, {20.0, 0.0}};
    const std::vector<std::size_t> all{0, 1, 2};
    const auto free = [&](std::vector<double> together) {
        const record::Tally tally = phase(loads, std::move(together));
        return free_together(tally.interfaces.front(), interface_of(tally, 0), all);
    };
    EXPECT_DOUBLE_EQ(free({1, 1, 1, 1, 1, 1, 1, 1, 1}), 1.0);
    EXPECT_NEAR(free({1, 0, 0, 0, 1, 0, 0, 0, 1}), 0.25 + 0.09 + 0.04, 1e-15);  // one by one
    EXPECT_TRUE(std::isnan(free(std::vector<double>(9, 0.0))));
    const record::Tally tally = phase(loads, {1, 0, 0, 0, 1, 1, 0, 1, 1});
    EXPECT_DOUBLE_EQ(free_together(tally.interfaces.front(), interface_of(tally, 0), std::vector<std::size_t>{1, 2}),
                     1.0);
}

}  // namespace
}  // namespace stridor::analysis
