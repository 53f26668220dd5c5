// Static friction that grows with rest, against closed forms: a block on a belt slips by half a turn of a circle about
// its kinetic position, so the force with which each stick ends follows from the time that it lasts, one equation of
// one unknown.
//
//     stick  x = x_0 + V t, ends where k x = (mu_s + g(t)) N        a = ((mu_s + g) - mu_d) N/k
//     slip   from x_d + a to x_d - a, x_d = mu_d N/k, in (pi + 2 atan(V/(a omega)))/omega
//     so     V t' = a(t') + a     of the next stick, as long as mu_s N holds it there: a - x_d < mu_s N/k

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/chain_on_belt.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "support/error_text.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using model::ContactState;
using parameters::Initial;
using parameters::RestKind;

struct RestingBelt {
    std::string name;
    model::Belt belt{1.0, 1.0, 0.0, 1.0, {0.5, 0.3}};
    model::RestGrowth rest{};
    double V = 0.1;           // [m/s]
    double duration = 200.0;  // [s]
};

std::vector<RestingBelt> resting_belts() {
    const model::Belt stiff{2.0, 3e5, 0.0, 80.0, {0.4, 0.4}};
    return {
        {"logarithmic", {1.0, 1.0, 0.0, 1.0, {0.5, 0.3}}, {RestKind::logarithmic, 0.05, 0.5}},
        {"that has rested before", {1.0, 1.0, 0.0, 1.0, {0.5, 0.3}}, {RestKind::logarithmic, 0.05, 0.5, 1.0, 30.0}},
        {"all of the drop by rest", {1.0, 1.0, 0.0, 1.0, {0.3, 0.3}}, {RestKind::logarithmic, 0.05, 0.01}},
        {"at once", {1.0, 1.0, 0.0, 1.0, {0.5, 0.3}}, {RestKind::logarithmic, 0.01, 1e-12}},
        {"of no time", {1.0, 1.0, 0.0, 1.0, {0.5, 0.3}}, {RestKind::logarithmic, 0.05, 1e12}},
        {"Kato", {1.0, 1.0, 0.0, 1.0, {0.4, 0.3}}, {RestKind::kato, 0.3, 4.0, 0.36}},
        {"Kato, square root", {1.0, 1.0, 0.0, 1.0, {0.3, 0.3}}, {RestKind::kato, 0.3, 2.0, 0.5}, 0.05},
        {"Kato, exponential", {1.0, 1.0, 0.0, 1.0, {0.4, 0.3}}, {RestKind::kato, 0.3, 4.0, 1.0}},
        {"stiff, logarithmic", stiff, {RestKind::logarithmic, 0.02, 1e-3}, 2e-3, 0.5},
        {"stiff, Kato", stiff, {RestKind::kato, 0.2, 0.05, 0.5}, 2e-3, 0.5},
        {"limit and force rise alike at first",
         {1.0, 1.0, 0.0, 1.0, {0.4, 0.3}},
         {RestKind::kato, 0.5, 10.0, 1.0},
         0.05},
    };
}

long double grown(const model::RestGrowth& rest, long double t) {
    const long double ratio = t / static_cast<long double>(rest.time);
    return rest.kind == RestKind::kato
               ? -rest.growth * std::expm1(-std::pow(ratio, static_cast<long double>(rest.exponent)))
               : rest.growth * std::log1p(ratio);
}

// when sticks end and begin, up to the duration
std::vector<long double> instants(const RestingBelt& given) {
    const long double N = given.belt.preload, k = given.belt.stiffness, V = std::abs(given.V);
    const long double omega = std::sqrt(k / given.belt.mass), mu_d = given.belt.friction.kinetic_coefficient;
    long double before = mu_d * N / k;  // of the first stick, which begins at x = 0
    long double rested = given.rest.before, now = 0.0;
    std::vector<long double> found;
    for (;;) {
        const auto a = [&](long double t) {
            return (given.belt.friction.static_coefficient + grown(given.rest, rested + t) - mu_d) * N / k;
        };
        // concave, and above zero at first: one zero
        long double low = 0.0, high = 1e6L;
        for (int halving = 0; halving < 200; ++halving) {
            const long double middle = 0.5L * (low + high);
            (a(middle) + before - V * middle > 0.0L ? low : high) = middle;
        }
        // the first stick goes from 0 to x_d + a, later ones from x_d - a
        found.push_back(now += low);
        before = a(low);
        found.push_back(now += (std::numbers::pi_v<long double> + 2.0L * std::atan(V / (before * omega))) / omega);
        rested = 0.0;
        if (now > given.duration) break;
    }
    while (found.back() > given.duration)
        found.pop_back();
    return found;
}

model::Structure belt_of(const RestingBelt& given) {
    model::Structure structure = model::mass_on_belt(given.belt);
    structure.contacts[0].rest = given.rest;
    return structure;
}

Motion moved(const RestingBelt& given, double sign = 1.0) {
    return support::run_taylor(belt_of(given), sign * given.V, Initial::stuck, {given.duration, given.duration});
}

TEST(GrowthByRest, EndsEachStickWhereItsEquationSays) {
    for (const RestingBelt& given : resting_belts()) {
        const Motion motion = moved(given);
        support::expect_sound(motion);
        const record::ContactHistory& history = motion.record.histories.front();
        const std::vector<long double> wanted = instants(given);
        ASSERT_EQ(history.size(), wanted.size() + 1) << given.name;
        EXPECT_GT(wanted.size(), 10U) << given.name;
        for (std::size_t n = 0; n < wanted.size(); ++n) {
            EXPECT_EQ(history[n + 1].state, n % 2 == 0 ? ContactState::slip : ContactState::stick) << given.name;
            EXPECT_NEAR(history[n + 1].from, static_cast<double>(wanted[n]), 1e-12 * given.duration)
                << given.name << " " << n;
        }
    }
}

// chords come near slowly where the limit grows nearly as fast as the force
TEST(GrowthByRest, EndsAStickWhoseLimitNearlyKeepsUp) {
    for (const double V : {0.0601, 0.06001, 0.060001}) {
        const RestingBelt given{"", {1.0, 1.0, 0.0, 1.0, {1e-4, 1e-4}}, {RestKind::kato, 0.6, 10.0, 1.0}, V, 10.0};
        const double end = static_cast<double>(instants(given).front());
        EXPECT_NEAR(moved(given).record.histories.front().at(1).from, end, 1e-12) << V;
    }
}

// the force that ends a stick is that of its own rest
TEST(GrowthByRest, BreaksAwayWithTheForceOfItsRest) {
    const RestingBelt given = resting_belts().front();
    const Motion motion = moved(given);
    const record::ContactHistory& history = motion.record.histories.front();
    for (std::size_t n = 2; n + 1 < history.size(); n += 2) {
        const double t = history[n].to - history[n].from;
        const double amplitude = 0.2 + 0.05 * std::log1p(t / 0.5);
        const double slip = (std::numbers::pi + 2.0 * std::atan(given.V / amplitude));
        EXPECT_NEAR(history[n + 1].to - history[n + 1].from, slip, 1e-9) << n;
    }
}

TEST(GrowthByRest, MirrorsBitForBit) {
    for (const RestingBelt& given : resting_belts()) {
        const Motion here = moved(given), there = moved(given, -1.0);
        const record::ContactHistory& a = here.record.histories.front();
        const record::ContactHistory& b = there.record.histories.front();
        ASSERT_EQ(a.size(), b.size()) << given.name;
        for (std::size_t n = 0; n < a.size(); ++n) {
            EXPECT_EQ(a[n].state, b[n].state);
            EXPECT_EQ(a[n].from, b[n].from);
            EXPECT_EQ(a[n].slip_velocity, -b[n].slip_velocity);
        }
        EXPECT_EQ(here.energy.friction_loss, there.energy.friction_loss);
    }
}

TEST(GrowthByRest, TakesEnergyByFrictionAndAccountsForAll) {
    for (const RestingBelt& given : resting_belts()) {
        const Motion motion = moved(given);
        EXPECT_GT(motion.energy.friction_loss, 0.0) << given.name;
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-13) << given.name;
    }
}

// without growth, and with an end that is reached at once, it is Coulomb's law by the paper's formulas
TEST(GrowthByRest, IsCoulombsAtItsLimits) {
    const auto history_of = [](const model::Coulomb& law) {
        model::Structure belt = model::mass_on_belt({1.0, 1.0, 0.01, 1.0, law});
        const parameters::Case c = support::watched_case(0.1, {200.0, 200.0});
        record::Request request;
        request.history = record::KeepHistory::yes;
        return integration::integrate_exact(belt, c.drive, {Initial::stuck, 0.0}, {parameters::EarlyEnding::never},
                                            record::Recorder(record::schedule(c), request, 2))
            .record.histories.front();
    };
    struct Limit {
        model::RestGrowth rest;
        model::Coulomb law;
    };
    for (const Limit& limit :
         {Limit{{RestKind::logarithmic, 0.0, 1.0}, {0.5, 0.3}}, Limit{{RestKind::kato, 0.0, 1.0, 0.5}, {0.5, 0.3}},
          Limit{{RestKind::logarithmic, 0.1, 1e300}, {0.5, 0.3}},
          Limit{{RestKind::kato, 0.2, 1e-30, 0.5}, {0.7, 0.3}}}) {
        RestingBelt given{"", {1.0, 1.0, 0.01, 1.0, {0.5, 0.3}}, limit.rest};
        const record::ContactHistory found = moved(given).record.histories.front();
        const record::ContactHistory wanted = history_of(limit.law);
        ASSERT_EQ(found.size(), wanted.size());
        EXPECT_GT(found.size(), 20U);
        for (std::size_t n = 0; n < found.size(); ++n)
            EXPECT_NEAR(found[n].from, wanted[n].from, 1e-12 * given.duration) << n;
    }
}

// Where all of the drop is grown, a(t) = A ln(1 + t/t_0) N/k, a stick of t is followed by one of t'. Above
// V_c = 2 A N/(k t_0) each is shorter than the one before, and stick-slip dies out; below they end at V t = 2 a(t).
TEST(GrowthByRest, SticksNoMoreAboveItsCriticalVelocity) {
    RestingBelt given{"", {1.0, 1.0, 0.0, 1.0, {0.3, 0.3}}, {RestKind::logarithmic, 0.05, 2.0}};
    given.duration = 30000.0;
    const double critical = 2.0 * 0.05 / 2.0;
    const auto sticks = [&](double share) {
        given.V = share * critical;
        const Motion motion = moved(given);
        std::vector<double> durations;
        for (const record::ContactInterval& each : motion.record.histories.front())
            if (each.state == ContactState::stick && each.to < given.duration) durations.push_back(each.to - each.from);
        return durations;
    };
    // ln(1 + y)/y = 0.999 at t = y t_0
    double low = 0.0, high = 1.0;
    for (int halving = 0; halving < 100; ++halving)
        (std::log1p(0.5 * (low + high)) > 0.999 * 0.5 * (low + high) ? low : high) = 0.5 * (low + high);
    const std::vector<double> below = sticks(0.999), above = sticks(1.001);
    EXPECT_GT(below.size(), 4000U);
    EXPECT_NEAR(below.back(), 2.0 * low, 2e-2 * low);  // a distance shrinks by 0.2 % a cycle
    EXPECT_LT(above.back(), 0.05 * low);
    // a stick of some microseconds ends where rounding says
    const auto told = std::find_if(above.begin(), above.end(), [](double stick) { return stick < 1e-5; });
    EXPECT_TRUE(std::is_sorted(std::make_reverse_iterator(told), above.rend()));
}

// laws of slip that change with its velocity know rest, too
TEST(GrowthByRest, GoesWithAnyLawOfSlip) {
    RestingBelt given = resting_belts().front();
    model::Structure plain = belt_of(given), falling = plain;
    falling.contacts[0].friction = model::Linear{0.5, 0.3, 0.0};
    const auto run = [&](const model::Structure& structure) {
        return support::run_taylor(structure, given.V, Initial::stuck, {given.duration, given.duration})
            .record.histories.front();
    };
    const record::ContactHistory a = run(plain), b = run(falling);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t n = 0; n < a.size(); ++n)
        EXPECT_NEAR(a[n].from, b[n].from, 1e-12 * given.duration) << n;
}

// two blocks side by side know nothing of each other: each rests for itself
TEST(GrowthByRest, IsEachContactsOwn) {
    RestingBelt first = resting_belts()[0], second = resting_belts()[5];
    second.belt.preload = 0.7;
    model::Structure chain = model::chain_on_belt({{1.0, 1.0, 0.0, first.belt.preload, first.belt.friction},
                                                   {1.0, 1.0, 0.0, second.belt.preload, second.belt.friction}},
                                                  0.0);
    chain.contacts[0].rest = first.rest;
    chain.contacts[1].rest = second.rest;
    const Motion motion = support::run_taylor(chain, first.V, Initial::stuck, {first.duration, first.duration});
    for (std::size_t k = 0; k < 2; ++k) {
        const record::ContactHistory& history = motion.record.histories[k];
        const std::vector<long double> wanted = instants(k == 0 ? first : second);
        ASSERT_EQ(history.size(), wanted.size() + 1);
        for (std::size_t n = 0; n < wanted.size(); ++n)
            EXPECT_NEAR(history[n + 1].from, static_cast<double>(wanted[n]), 1e-12 * first.duration) << k << " " << n;
    }
}

// steps converge to the same events with their first order
TEST(GrowthByRest, IsWhatStepsConvergeTo) {
    RestingBelt given = resting_belts().front();
    given.duration = 60.0;
    const model::Structure belt = belt_of(given);
    const parameters::Case c = support::watched_case(given.V, {given.duration, given.duration});
    const std::vector<long double> wanted = instants(given);
    const auto by_beta_2 = [&](double step) {
        record::Request request;
        request.history = record::KeepHistory::yes;
        return integration::integrate_beta_2(belt, c.drive, {Initial::stuck, 0.0}, {step, 0.5},
                                             record::Recorder(record::schedule(c), request, 2));
    };
    const auto by_moreau = [&](double step) {
        return support::run_moreau(belt, given.V, Initial::stuck, step, {given.duration, given.duration});
    };
    for (const double step : {1e-3, 1e-4})
        for (const Motion& motion : {by_beta_2(step), by_moreau(step)}) {
            const record::ContactHistory& history = motion.record.histories.front();
            ASSERT_EQ(history.size(), wanted.size() + 1);
            for (std::size_t n = 0; n < wanted.size(); ++n)
                EXPECT_NEAR(history[n + 1].from, static_cast<double>(wanted[n]), 20.0 * step) << step << " " << n;
        }
}

// one run, and the same in two parts
TEST(GrowthByRest, GoesOnBitForBit) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.02;
    c.contact().rest = RestKind::kato;
    c.contact().rest_growth = 0.3;
    c.contact().rest_time = 1e-3;
    c.contact().rested = 0.4e-3;
    c.run.initial = Initial::stuck;
    c.run.step = 1e-6;
    record::Request request;
    request.history = record::KeepHistory::yes;
    for (const parameters::Engine engine :
         {parameters::Engine::exact, parameters::Engine::beta_2, parameters::Engine::moreau}) {
        c.run.engine = engine;
        c.run.early_ending = parameters::EarlyEnding::never;
        c.run.duration = c.run.window = 0.02;
        const Motion whole = integration::simulate(c, request);
        c.run.duration = 0.0093;
        const integration::EndState half = integration::run_to_end(c).state;
        ASSERT_EQ(half.rested.size(), 1U);
        EXPECT_EQ(half.rested[0] > 0.0, half.contacts[0] == ContactState::stick);
        c.run.duration = 0.02;
        c.run.window = 0.0107;
        const integration::EndState joined = integration::run_to_end(c, &half).state;
        const integration::EndState at_once = integration::run_to_end(c).state;
        EXPECT_EQ(joined.displacement, at_once.displacement);
        EXPECT_EQ(joined.velocity, at_once.velocity);
        EXPECT_EQ(joined.rested, at_once.rested);
        EXPECT_GT(whole.record.histories.front().size(), 3U);
    }
}

// another run that begins there has rested as long
TEST(GrowthByRest, IsHandedToARunThatBeginsThere) {
    parameters::Case c;
    c.joints.emplace_back();
    c.contact().rest = RestKind::logarithmic;
    integration::EndState state{1.0,
                                std::vector<double>(5, 0.0),
                                std::vector<double>(5, 0.0),
                                {ContactState::stick, ContactState::slip},
                                {0.25, 0.0}};
    const parameters::Case begun = integration::begun_at(c, state);
    EXPECT_EQ(begun.joints[0].contact.rested, 0.25);
    EXPECT_EQ(begun.joints[1].contact.rested, 0.0);
}

TEST(GrowthByRest, IsRefusedByThePapersFormulasByName) {
    const model::Structure belt = belt_of(resting_belts().front());
    const parameters::Case c = support::watched_case(0.1, {1.0, 1.0});
    EXPECT_TRUE(support::thrown_by([&] {
                    integration::integrate_exact(belt, c.drive, {Initial::stuck, 0.0}, {},
                                                 record::Recorder(record::schedule(c), {}, 2));
                }).says("the exact engine knows no static friction that grows with rest"));
}

}  // namespace
}  // namespace stridor
