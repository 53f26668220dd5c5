#include "stridor/advice/tolerance.hpp"

#include "stridor/advice/sobol.hpp"
#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/crew/thread_crew.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/counter_random.hpp"
#include "support/effort.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace stridor::advice {
namespace {

using parameters::Case;
using support::CounterRandom;
using support::thrown_by;

const Case quiet = parameters::paper_case(parameters::PaperCase::quiet);

TEST(Sobol, HasOnePointInEachIntervalOfEachCoordinate) {
    for (const unsigned m : {1U, 4U, 8U}) {
        std::vector<std::set<std::uint32_t>> intervals(most_sobol_dimensions);
        for (std::uint32_t index = 0; index < (1U << m); ++index) {
            const std::vector<std::uint32_t> point = sobol_digits(most_sobol_dimensions, index);
            for (std::size_t k = 0; k < point.size(); ++k)
                intervals[k].insert(point[k] >> (32U - m));
        }
        for (const std::set<std::uint32_t>& each : intervals)
            EXPECT_EQ(each.size(), std::size_t{1} << m);
    }
}

TEST(Sobol, HasOnePointInEachRectangleOfItsFirstTwoCoordinates) {
    constexpr unsigned m = 8;
    for (unsigned a = 0; a <= m; ++a) {
        std::set<std::pair<std::uint64_t, std::uint64_t>> rectangles;
        for (std::uint32_t index = 0; index < (1U << m); ++index) {
            const std::vector<std::uint32_t> point = sobol_digits(2, index);
            rectangles.insert({std::uint64_t{point[0]} >> (32U - a), std::uint64_t{point[1]} >> (32U - (m - a))});
        }
        EXPECT_EQ(rectangles.size(), std::size_t{1} << m) << a;
    }
}

// the published first points: 0, 1/2, then a quarter and three quarters in the order of each coordinate
TEST(Sobol, BeginsAsPublished) {
    const auto coordinates = [](std::uint32_t index) {
        std::vector<double> point;
        for (const std::uint32_t each : sobol_digits(4, index))
            point.push_back(each * 0x1p-32);
        return point;
    };
    EXPECT_EQ(coordinates(0), (std::vector{0.0, 0.0, 0.0, 0.0}));
    EXPECT_EQ(coordinates(1), (std::vector{0.5, 0.5, 0.5, 0.5}));
    EXPECT_EQ(coordinates(3), (std::vector{0.75, 0.25, 0.25, 0.25}));
    EXPECT_EQ(coordinates(2), (std::vector{0.25, 0.75, 0.75, 0.75}));
    EXPECT_EQ(coordinates(4 ^ 2), (std::vector{0.375, 0.375, 0.625, 0.875}));
}

TEST(Sobol, ShiftsDifferBySeedAndReplicateAndNothingElse) {
    const auto first = sobol_points(3, 64, {7, 0});
    EXPECT_EQ(sobol_points(3, 64, {7, 0}), first);
    EXPECT_NE(sobol_points(3, 64, {7, 1}), first);
    EXPECT_NE(sobol_points(3, 64, {8, 0}), first);
    for (const std::vector<double>& point : first)
        for (const double each : point) {
            EXPECT_GT(each, 0.0);
            EXPECT_LT(each, 1.0);
        }
}

TEST(Tolerance, IsSpreadAsItSays) {
    const Tolerance uniform{"contact.preload", 20.0, 2.0, Spread::uniform};
    EXPECT_DOUBLE_EQ(value_at(uniform, 0.25), 19.0);
    EXPECT_DOUBLE_EQ(value_at(uniform, 0.5), 20.0);
    const Tolerance normal{"contact.preload", 20.0, 3.0, Spread::normal};  // standard deviation 1, cut at 3
    const auto below = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
    for (const double x : {-2.9, -1.96, -1.2, -0.5, 0.0, 0.3, 1.0, 1.5, 2.5, 2.99}) {
        const double probability = (below(x) - below(-3.0)) / (below(3.0) - below(-3.0));
        EXPECT_NEAR(value_at(normal, probability), 20.0 + x, 1e-12) << x;
    }
    EXPECT_GE(value_at(normal, 1e-12), 17.0);
    EXPECT_LE(value_at(normal, 1.0 - 1e-12), 23.0);
}

TEST(Tolerance, IsTakenFromTheCase) {
    const std::vector<AskedTolerance> asked{{"preload", 0.1, {}, Spread::normal}, {"mu_d", {}, 0.05}};
    const std::vector<Tolerance> all = tolerances(quiet, asked);
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].key, "contact.preload");
    EXPECT_DOUBLE_EQ(all[0].tolerance, 2.0);
    EXPECT_EQ(all[0].spread, Spread::normal);
    EXPECT_EQ(all[1].tolerance, 0.05);
}

TEST(Tolerance, RefusesWhatIsNone) {
    const auto refused = [](const Case& c, const std::vector<AskedTolerance>& asked) {
        return thrown_by([&] { tolerances(c, asked); });
    };
    EXPECT_TRUE(refused(quiet, {{"preload", 1.5, {}}}).says("reaches -10"));
    EXPECT_TRUE(refused(quiet, {{"preload", 0.0, {}}}).says("above zero"));
    EXPECT_TRUE(refused(quiet, {{"preload", -0.1, {}}}).says("above zero"));
    EXPECT_TRUE(refused(quiet, {{"preload", 0.1, {}}, {"F", {}, 1.0}}).says("two tolerances"));
    EXPECT_TRUE(refused(quiet, {{"masss", 0.1, {}}}).says("is no key of a case"));
    Case c = quiet;
    c.plate.damping = 0.0;
    EXPECT_TRUE(refused(c, {{"plate.damping", 0.1, {}}}).says("a share of zero is zero"));
}

std::vector<std::size_t> hits_of(std::size_t each) {
    return std::vector<std::size_t>(replicates, each);
}

// none of n: 1 - 0.025^(1/n), the closed form of Clopper and Pearson
TEST(Estimate, OfNothingSeenIsStillNotZero) {
    const Estimate none = estimate(hits_of(0), 128);
    EXPECT_EQ(none.share, 0.0);
    EXPECT_EQ(none.low, 0.0);
    EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 1.0 / 2048.0), 1e-12);
    const Estimate all = estimate(hits_of(128), 128);
    EXPECT_EQ(all.share, 1.0);
    EXPECT_EQ(all.high, 1.0);
    EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 2048.0), 1e-12);
}

// 5 of 2048: P(X >= 5 | low) and P(X <= 5 | high) are 0.025 each, summed here term by term
TEST(Estimate, OfFewHitsIsThatOfClopperAndPearson) {
    std::vector<std::size_t> hits = hits_of(0);
    hits[3] = 4;
    hits[9] = 1;
    const Estimate few = estimate(hits, 128);
    const auto at_most = [](int k, double p) {
        double sum = 0.0;
        for (int j = 0; j <= k; ++j)
            sum += std::exp(std::lgamma(2049.0) - std::lgamma(j + 1.0) - std::lgamma(2049.0 - j) + j * std::log(p) +
                            (2048.0 - j) * std::log1p(-p));
        return sum;
    };
    EXPECT_NEAR(1.0 - at_most(4, few.low), 0.025, 1e-9);
    EXPECT_NEAR(at_most(5, few.high), 0.025, 1e-9);
}

TEST(Estimate, OfEqualReplicatesStillHasAWidth) {
    const Estimate half = estimate(hits_of(64), 128);
    EXPECT_EQ(half.share, 0.5);
    EXPECT_LT(half.low, 0.49);
    EXPECT_GT(half.low, 0.47);
    EXPECT_NEAR(half.low + half.high, 1.0, 1e-12);
}

// shares of a box cut off by a plane or a ball, from rare to frequent, known in closed form
struct Region {
    std::size_t dimensions;
    double share;
    bool (*holds)(const std::vector<double>&);
};

const std::array regions{
    Region{2, 0.5, [](const auto& x) { return x[0] + x[1] < 1.0; }},
    Region{2, 0.7853981633974483, [](const auto& x) { return x[0] * x[0] + x[1] * x[1] < 1.0; }},
    Region{3, 1.0 / 6.0, [](const auto& x) { return x[0] + x[1] + x[2] < 1.0; }},
    Region{5, 1.0 / 120.0, [](const auto& x) { return std::accumulate(x.begin(), x.end(), 0.0) < 1.0; }},
    Region{6, 0.001, [](const auto& x) { return x[0] < 0.1 && x[3] > 0.9 && x[5] > 0.45 && x[5] < 0.55; }},
};

TEST(Estimate, CoversTheTruthAsOftenAsItSays) {
    constexpr std::size_t samples = 128;
    constexpr std::uint64_t runs = support::effort<std::uint64_t>(300, 60);
    for (const Region& region : regions) {
        std::size_t covered = 0;
        double mean = 0.0;
        for (std::uint64_t seed = 0; seed < runs; ++seed) {
            std::vector<std::size_t> hits(replicates, 0);
            for (std::size_t replicate = 0; replicate < replicates; ++replicate)
                for (const std::vector<double>& point : sobol_points(region.dimensions, samples, {seed, replicate}))
                    hits[replicate] += region.holds(point) ? 1 : 0;
            const Estimate known = estimate(hits, samples);
            covered += known.low <= region.share && region.share <= known.high ? 1 : 0;
            mean += known.share / static_cast<double>(runs);
        }
        // 95 % of 300: 285 +- 3.8; four standard deviations less are 270
        EXPECT_GE(static_cast<double>(covered), 0.90 * static_cast<double>(runs)) << region.share;
        // unbiased: no worse than independent samples, four standard deviations
        const double deviation =
            std::sqrt(region.share * (1.0 - region.share) / (static_cast<double>(runs) * replicates * samples));
        EXPECT_NEAR(mean, region.share, 4.0 * deviation) << region.share;
    }
}

bool is_noisy_run(const Case& c) {
    for (const record::Tally& tally : integration::simulate(c).record.phases) {
        const auto category = classification::classify(analysis::evidence(tally, 0), c.verdict).category;
        if (category != classification::Category::none && category != classification::Category::undecided) return true;
    }
    return false;
}

// brute force: other random numbers, one run after the other, judged as a single case is
double brute_force(const Case& base, std::span<const Tolerance> spreads, std::size_t samples) {
    CounterRandom random(20120401);
    std::size_t noisy = 0;
    for (std::size_t k = 0; k < samples; ++k) {
        Case c = base;
        for (const Tolerance& each : spreads)
            parameters::set_quantity(c, *parameters::find_field(each.key),
                                     random.between(each.value - each.tolerance, each.value + each.tolerance));
        noisy += is_noisy_run(c) ? 1 : 0;
    }
    return static_cast<double>(noisy) / static_cast<double>(samples);
}

TEST(Chance, AgreesWithBruteForce) {
    Case c = quiet;
    c.contact().kinetic_friction = 0.4;  // the boundary of squeal is at 0.414
    const std::vector<AskedTolerance> asked{{"preload", 0.5, {}}, {"mu_d", {}, 0.1}};
    const std::vector<Tolerance> spreads = tolerances(c, asked);
    const DesignSpace space = design_space(c, {}, {{}, {parameters::Initial::rest}});  // as the brute runs
    DesignRunner runner(space, crew::thread_crews(), {});
    const std::size_t samples = support::effort<std::size_t>(2048, 256);
    const Chance known = chance(spreads, {samples, 1}, runner);
    EXPECT_EQ(known.samples, samples);
    const double brute = brute_force(c, spreads, support::effort<std::size_t>(2000, 256));
    // the brute estimate has an uncertainty of its own: four standard deviations
    const double uncertainty = 4.0 * std::sqrt(brute * (1.0 - brute) / support::effort(2000.0, 256.0));
    EXPECT_GE(brute, known.noise.low - uncertainty);
    EXPECT_LE(brute, known.noise.high + uncertainty);
    EXPECT_GT(known.noise.share, 0.2);
    EXPECT_LT(known.noise.share, 0.8);
    EXPECT_LT(known.noise.high - known.noise.low, support::effort(0.04, 0.2));
}

TEST(Chance, IsTheSameForAnyNumberOfThreads) {
    const std::vector<AskedTolerance> asked{{"mu_d", {}, 0.1}};
    const std::vector<Tolerance> spreads = tolerances(quiet, asked);
    std::vector<double> shares;
    const DesignSpace space = design_space(quiet);
    for (const int threads : {1, 3}) {
        DesignRunner runner(space, crew::thread_crews(threads), {});
        shares.push_back(chance(spreads, {64, 5}, runner).noise.share);
    }
    EXPECT_EQ(shares[0], shares[1]);
}

// mu_d within +-0.05 of mu_s: half of the designs contradict themselves, and are counted as such
TEST(Chance, NeverCallsWhatCannotBeQuiet) {
    Case c = quiet;
    c.contact().static_friction = 0.2;
    const std::vector<AskedTolerance> asked{{"mu_d", {}, 0.05}};
    const std::vector<Tolerance> spreads = tolerances(c, asked);
    const DesignSpace space = design_space(c);
    DesignRunner runner(space, crew::thread_crews(), {});
    const Chance known = chance(spreads, {256, 1}, runner);
    const std::size_t invalid = sweep::number_of({sweep::Status::invalid, classification::Category::undecided});
    EXPECT_NEAR(known.by_verdict[invalid].share, 0.5, 0.01);
    EXPECT_GE(known.not_quiet.share, known.by_verdict[invalid].share);
    double sum = 0.0;
    for (const Estimate& each : known.by_verdict)
        sum += each.share;
    EXPECT_NEAR(sum, 1.0, 1e-12);
}

}  // namespace
}  // namespace stridor::advice
