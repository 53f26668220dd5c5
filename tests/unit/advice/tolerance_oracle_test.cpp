// Quantiles and confidence intervals held against Boost.Math.

#include "stridor/advice/tolerance.hpp"
#include "support/counter_random.hpp"

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <boost/math/tools/roots.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace stridor::advice {
namespace {

using Binomial = boost::math::binomial_distribution<double>;
using Hits = std::array<std::size_t, replicates>;
using support::CounterRandom;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double tail = 0.5 * (1.0 - confidence);

// hits over the replicates as evenly as they go
Hits even(std::size_t total) {
    Hits hits{};
    for (std::size_t k = 0; k < replicates; ++k)
        hits[k] = total / replicates + (k < total % replicates ? 1 : 0);
    return hits;
}

// Both follow rational functions within 1e-16; some twenty rounded operations of each add at most half a unit of the
// last place each, and a third and three times of it one more.
TEST(ToleranceOracle, NormalSpreadHasBoostsQuantiles) {
    const Tolerance three_sigmas{"contact.preload", 0.0, 3.0, Spread::normal};
    const double cut = boost::math::cdf(boost::math::normal(), -3.0);
    CounterRandom random(1);
    for (int k = 0; k < 20000; ++k) {
        // half of them out in the tails
        const double uniform = random.between(0.0, 1.0);
        const double probability = k % 2 == 0 ? uniform : k % 4 == 1 ? 0.02 * uniform : 1.0 - 0.02 * uniform;
        if (probability <= 0.0 || probability >= 1.0) continue;
        const double expected = boost::math::quantile(boost::math::normal(), cut + probability * (1.0 - 2.0 * cut));
        EXPECT_NEAR(value_at(three_sigmas, probability), expected, 24.0 * epsilon * std::abs(expected)) << probability;
    }
}

// Our bound is the p at which a sum, (1 - p)^n times up to 31 terms, has a given value P. Rounding 1 - p shifts p by
// epsilon/4 at most, whatever n is. The sum is good to some 60 epsilon for 30 hits, to 2 epsilon for one. A change of P
// moves log p by its size over dP/d(log p), which for the lower bound is about 0.3 for 30 hits and 0.025 for one, and
// larger for the upper one: 200 epsilon. Of 1 - p, where nearly all had the property, the last place counts.
TEST(ToleranceOracle, FewHitsHaveBoostsClopperPearsonBounds) {
    CounterRandom random(2);
    for (int k = 0; k < 2000; ++k) {
        const std::size_t samples = std::size_t{1} << random.below(21);
        const std::size_t all = replicates * samples;
        const std::size_t total = random.below(std::min<std::size_t>(30, all) + 1);
        const auto trials = static_cast<double>(all);
        const auto successes = static_cast<double>(total);
        const double low = Binomial::find_lower_bound_on_p(trials, successes, tail);
        const double high = Binomial::find_upper_bound_on_p(trials, successes, tail);
        const auto near = [](double p) { return epsilon + 200.0 * epsilon * p; };
        const Estimate few = estimate(even(total), samples);
        EXPECT_NEAR(few.low, low, near(low)) << total << " of " << all;
        EXPECT_NEAR(few.high, high, near(high)) << total << " of " << all;
        if (2 * total > all) continue;
        const Estimate most = estimate(even(all - total), samples);
        EXPECT_NEAR(most.high, 1.0 - low, near(low)) << all - total << " of " << all;
        EXPECT_NEAR(most.low, 1.0 - high, near(high)) << all - total << " of " << all;
    }
}

// Wilson's bounds are the p with (share - p)^2 = z^2 p (1 - p)/n. For many samples the roots of this quadratic equation
// are close together, and the coefficients' rounding moves them by its size over their distance, 1e4 times as much:
// Boost has eleven more binary digits. Ours are a sum and a difference of numbers below 1, each good to some units of
// its last place.
TEST(ToleranceOracle, EqualReplicatesHaveWilsonsBounds) {
    using Long = long double;
    const Long z = boost::math::quantile(boost::math::normal_distribution<Long>(), 0.975L);
    CounterRandom random(3);
    for (int k = 0; k < 20000; ++k) {
        const std::size_t samples = std::size_t{4} << random.below(19);
        const std::size_t each = 2 + random.below(samples - 3);  // more than 30 of all have it, and lack it
        const Long share = static_cast<Long>(each) / static_cast<Long>(samples);
        const Long square = z * z / static_cast<Long>(replicates * samples);
        const auto [low, high] =
            boost::math::tools::quadratic_roots(1.0L + square, -(2.0L * share + square), share * share);
        Hits hits;
        hits.fill(each);
        const Estimate found = estimate(hits, samples);
        EXPECT_NEAR(found.low, static_cast<double>(low), 4.0 * epsilon) << each << " of " << samples;
        EXPECT_NEAR(found.high, static_cast<double>(high), 4.0 * epsilon) << each << " of " << samples;
    }
}

// the mean of 16 shares, and Student's t times the standard deviation of that mean
TEST(ToleranceOracle, UnequalReplicatesHaveStudentsBounds) {
    const double student = boost::math::quantile(boost::math::students_t(replicates - 1.0), 1.0 - tail);
    CounterRandom random(4);
    for (int k = 0; k < 2000; ++k) {
        constexpr std::size_t samples = 128;
        Hits hits;
        double mean = 0.0;
        for (std::size_t& each : hits) {
            each = 40 + random.below(48);
            mean += static_cast<double>(each) / (replicates * samples);
        }
        double square = 0.0;
        for (const std::size_t each : hits)
            square += std::pow(static_cast<double>(each) / samples - mean, 2);
        const double half = student * std::sqrt(square / (replicates * (replicates - 1.0)));
        const Estimate found = estimate(hits, samples);
        // thirty rounded operations on numbers below 1
        EXPECT_NEAR(found.low, mean - half, 16.0 * epsilon);
        EXPECT_NEAR(found.high, mean + half, 16.0 * epsilon);
    }
}

}  // namespace
}  // namespace stridor::advice
