// A beam of 1, 8 and 40 bending modes that rubs with its tip, by beta_2: balance, order,
// and the exact engine where it can.

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/built/cantilever.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/linear/frequencies.hpp"
#include "stridor/record/recorder.hpp"
#include "support/belt_run.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor {
namespace {

constexpr double velocity = 0.05;  // [m/s]
const model::Cantilever beam;

record::Recorder recorder(double duration, int modes) {
    parameters::Case c;
    c.drive = support::constant_drive(velocity);
    c.run.duration = c.run.window = duration;
    return {record::schedule(c), {record::KeepHistory::yes, {}}, modes + 1};
}

integration::Motion stepped(int modes, double duration, double h, const integration::Start& start) {
    return integration::integrate_beta_2(model::cantilever(beam, modes), support::constant_drive(velocity), start,
                                         {h, 0.5}, recorder(duration, modes));
}

// Euler-Bernoulli: beta L = 1.875104069, 4.694091133, 7.854757438, then (k - 1/2) pi
TEST(Beam, HasTheFrequenciesOfTheTextbook) {
    const double scale = std::sqrt(beam.bending_stiffness / beam.mass_per_length) / (beam.length * beam.length);
    for (const auto& [k, root] :
         {std::pair(1, 1.8751040687), {2, 4.6940911330}, {3, 7.8547574382}, {40, 124.0929098168}})
        EXPECT_NEAR(model::bending_frequency(beam, k), root * root * scale, 1e-9 * root * root * scale) << k;
}

TEST(Beam, StandsPreloadedAtRest) {
    for (const int modes : {1, 8, 40}) {
        const auto balance = model::equilibrium(model::cantilever(beam, modes), {0.0});
        EXPECT_NEAR(balance.normal_forces(0), beam.preload, 1e-12);
        EXPECT_LT(balance.displacement.norm(), 1e-15);
    }
}

// clamped at the tip as well, the first frequency lies between the free beam's first and second (Rayleigh)
TEST(Beam, IsStifferWhereItsTipIsHeld) {
    const auto structure = model::cantilever(beam, 8);
    const double held = model::natural_frequencies(structure, model::ContactState::stick).front();
    EXPECT_GT(held, model::bending_frequency(beam, 1));
    EXPECT_LT(held, model::bending_frequency(beam, 2));
}

TEST(Beam, BalancesItsEnergyWithAnyNumberOfModes) {
    for (const int modes : {1, 8, 40}) {
        const auto motion = stepped(modes, 0.05, 1e-6, {parameters::Initial::stuck, 0.0});
        EXPECT_EQ(motion.outcome.reason, integration::Reason::completed) << modes;
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-9) << modes;
        EXPECT_GT(motion.record.histories.front().size(), 3U) << modes;  // it does rub
    }
}

// the first bending coordinate; steps fit the instant
double mode_at_4_ms(int modes, double h) {
    parameters::Case c;
    c.drive = support::constant_drive(velocity);
    c.run.duration = c.run.window = 5e-3;
    const record::Recorder kept(record::schedule(c), {record::KeepHistory::yes, {4e-3, 4e-3, 1e-4}}, modes + 1);
    const auto motion = integration::integrate_beta_2(model::cantilever(beam, modes), c.drive,
                                                      {parameters::Initial::sliding, 1e-3}, {h, 0.5}, kept);
    EXPECT_EQ(motion.record.histories.front().size(), 1U);  // it slips all the time: nothing but the scheme acts
    return motion.record.trace.displacement[0].at(0);
}

TEST(Beam, IsFollowedToSecondOrder) {
    for (const auto& [modes, h] : {std::pair(1, 1e-5), {8, 4e-6}, {40, 1e-6}}) {
        const double coarse = mode_at_4_ms(modes, h);
        const double middle = mode_at_4_ms(modes, 0.5 * h);
        const double fine = mode_at_4_ms(modes, 0.25 * h);
        EXPECT_NEAR(std::log2(std::abs(coarse - middle) / std::abs(middle - fine)), 2.0, 0.15) << modes;
    }
}

// beta_2 sticks for one step where the slip only turns round: such stays are dropped, and equal neighbours joined
record::ContactHistory lasting(const record::ContactHistory& history, double least) {
    record::ContactHistory kept;
    for (const record::ContactInterval& each : history) {
        if (each.to - each.from < least) continue;
        if (kept.empty() || kept.back().state != each.state) kept.push_back(each);
    }
    return kept;
}

// where both can: one and two bending modes; the instants of the first changes of state, to some steps
TEST(Beam, RubsAsTheExactEngineSays) {
    for (const int modes : {1, 2}) {
        const integration::Start start{parameters::Initial::stuck, 0.0};
        const auto exact = integration::integrate_exact(
            model::cantilever(beam, modes), support::constant_drive(velocity), start, {}, recorder(0.02, modes));
        const auto& told = exact.record.histories.front();
        ASSERT_GE(told.size(), 6U) << modes;
        for (const double h : {1e-6, 1e-7}) {
            const auto close = lasting(stepped(modes, 0.02, h, start).record.histories.front(), 1.5 * h);
            for (std::size_t k = 0; k < 6; ++k) {
                EXPECT_EQ(close.at(k).state, told[k].state) << modes << " " << k;
                EXPECT_NEAR(close.at(k).from, told[k].from, 4.0 * h) << modes << " " << k;
            }
        }
    }
}

TEST(Beam, IsRefusedByNameWhereAnEngineCannotSolveIt) {
    const auto refused = support::thrown_by([] {
        integration::integrate_exact(model::cantilever(beam, 3), support::constant_drive(velocity), {}, {},
                                     recorder(0.01, 3));
    });
    EXPECT_EQ(refused.kind, ErrorKind::input);
    EXPECT_TRUE(refused.says("the exact engine")) << refused.message;
    EXPECT_TRUE(refused.says("4 degrees of freedom")) << refused.message;

    auto two = model::cantilever(beam, 3);
    two.contacts.push_back(two.contacts.front());
    const auto two_refused = support::thrown_by([&] {
        integration::integrate_beta_2(two, support::constant_drive(velocity), {}, {1e-6, 0.5}, recorder(0.01, 3));
    });
    EXPECT_TRUE(two_refused.says("the beta_2 engine")) << two_refused.message;
    EXPECT_TRUE(two_refused.says("2 contacts")) << two_refused.message;
}

}  // namespace
}  // namespace stridor
