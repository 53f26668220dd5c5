// The exact engine on the paper's system: known numbers, an engine that shares no code with it,
// and its own energy balance.

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/table_1.hpp"
#include "support/oracles/event_driven.hpp"
#include "support/periods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace stridor {
namespace {

using integration::Motion;
using model::ContactState;
using parameters::Case;
using parameters::DriveKind;
using parameters::PaperCase;

constexpr std::array paper_cases{PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet};
const record::Request with_history{record::KeepHistory::yes, {}};
constexpr std::size_t slip_index = model::index_of(ContactState::slip);
constexpr std::size_t stick_index = model::index_of(ContactState::stick);
constexpr std::size_t separation_index = model::index_of(ContactState::separation);

Case evenly_driven(PaperCase which, double velocity, double duration) {
    Case c = parameters::paper_case(which);
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.engine = parameters::Engine::exact;
    c.run.initial = parameters::Initial::stuck;
    c.run.duration = c.run.window = duration;
    return c;
}

Case sampled_case(PaperCase which, double duration) {
    Case c = evenly_driven(which, 0.0, duration);
    c.run.initial = parameters::Initial::rest;
    c.drive.kind = DriveKind::sampled;
    return c;
}

double share(const record::Record& record, std::size_t state) {
    double time = 0.0, all = 0.0;
    for (const record::Tally& tally : record.phases)
        for (std::size_t k = 0; k < tally.contacts.front().time.size(); ++k) {
            all += tally.contacts.front().time[k];
            if (k == state) time += tally.contacts.front().time[k];
        }
    return time / all;
}

// physics.md, converged to all printed digits: stick share between 1 s and 2 s, and period
TEST(ExactEngine, SticksForTheKnownShareAndPeriod) {
    for (const auto& [preload, fraction, period] : verification::stick_slips) {
        Case c = evenly_driven(PaperCase::squeak, -0.1257, 2.0);
        c.contact().preload = preload;
        c.run.window = 1.0;
        const Motion motion = integration::simulate(c, with_history);
        EXPECT_NEAR(share(motion.record, stick_index), fraction, 2e-6) << preload;
        EXPECT_NEAR(support::whole_periods(motion.record.histories.front(), ContactState::stick, 1.0).period, period,
                    1e-7 * period)
            << preload;
    }
}

TEST(ExactEngine, SquealIsPeriodicAt430Hertz) {
    const Motion motion = integration::simulate(evenly_driven(PaperCase::squeal, 0.1257, 0.6), with_history);
    const auto periods = support::whole_periods(motion.record.histories.front(), ContactState::separation, 0.3);
    EXPECT_NEAR(1.0 / periods.period, 430.4, 0.05);
    EXPECT_NEAR(periods.shares[slip_index], 0.263, 1e-3);
    EXPECT_NEAR(periods.shares[separation_index], 0.737, 1e-3);
    EXPECT_NEAR(periods.shares[stick_index], 0.001, 1e-3);
}

// beta_2 at h = 1e-5 and 1e-6 says 33 % and 30 % stick (constant_drive_test)
TEST(ExactEngine, SlipsThroughoutWhereLargeStepsSayStickSlip) {
    Case c = evenly_driven(PaperCase::squeak, -0.1, 2.0);
    c.run.initial = parameters::Initial::rest;
    const Motion motion = integration::simulate(c, with_history);
    ASSERT_EQ(motion.record.histories.front().size(), 1U);
    EXPECT_EQ(motion.record.histories.front().front().state, ContactState::slip);
}

// rounding of 3e4 steps and some thousand events, against the work done
TEST(ExactEngine, BalancesItsEnergyOverTheWholeOfTable1) {
    for (const PaperCase which : paper_cases) {
        EXPECT_LT(std::abs(integration::simulate(parameters::paper_case(which)).energy.relative_residual()), 1e-10);
        for (const double velocity : {-0.1257, 0.1257})
            EXPECT_LT(std::abs(integration::simulate(evenly_driven(which, velocity, 1.0)).energy.relative_residual()),
                      1e-10);
    }
}

// a Runge-Kutta step of 1e-6 s turns the fastest mode by 1e-2 rad and misses it by (1e-2)^5 / 120: 1e-12 rad, 1e-16 s;
// 5e4 of them add up to 5e-12 s, and no motion here parts its neighbours within 50 ms
TEST(ExactEngine, ChangesStateWhenTheIndependentEngineDoes) {
    for (const PaperCase which : paper_cases)
        for (const double velocity : {-0.1257, 0.1257}) {
            const Case c = evenly_driven(which, velocity, 0.05);
            const record::ContactHistory known = support::event_driven(c, 1e-6, 1 << 30).history;
            const record::ContactHistory found = integration::simulate(c, with_history).record.histories.front();
            ASSERT_EQ(found.size(), known.size()) << velocity;
            for (std::size_t k = 0; k < found.size(); ++k) {
                ASSERT_EQ(found[k].state, known[k].state) << k;
                ASSERT_NEAR(found[k].from, known[k].from, 1e-11) << k;
            }
        }
}

// knots on a straight line change nothing beyond rounding
TEST(ExactSampledDrive, DoesNotSeeWhereAStraightLineIsCut) {
    Case c = sampled_case(PaperCase::creak, 0.05);
    c.drive.times = {0.0, 0.02, 0.05};
    c.drive.velocities = {0.05, 0.09, 0.03};
    Case cut = c;
    cut.drive.times = {0.0, 0.005, 0.01, 0.02, 0.0275, 0.035, 0.05};
    cut.drive.velocities = {0.05, 0.06, 0.07, 0.09, 0.075, 0.06, 0.03};
    const auto whole = integration::simulate(c, with_history).record.histories.front();
    const auto parts = integration::simulate(cut, with_history).record.histories.front();
    ASSERT_EQ(whole.size(), parts.size());
    ASSERT_GT(whole.size(), 5U);
    for (std::size_t k = 0; k < whole.size(); ++k) {
        EXPECT_EQ(whole[k].state, parts[k].state);
        EXPECT_NEAR(whole[k].from, parts[k].from, 1e-12);
    }
}

// between samples 50 us apart the velocity misses the sine by (2 pi 5 5e-5)^2 / 8 = 3e-7 of its peak: over the 100 ms
// of a phase the plate is off by 4e-9 m, and events by the 4e-8 s it takes for that distance, near reversals a
// hundred times as much
TEST(ExactSampledDrive, ComesNearTheSineItIsSampledFrom) {
    Case smooth = parameters::paper_case(PaperCase::creak);
    smooth.run.duration = smooth.run.window = 0.3;
    Case c = smooth;
    c.drive.kind = DriveKind::sampled;
    const double rate = 2.0 * std::numbers::pi * smooth.drive.frequency;
    for (int k = 0; k <= 6000; ++k) {
        c.drive.times.push_back(5e-5 * k);
        c.drive.velocities.push_back(smooth.drive.amplitude * rate * std::cos(rate * 5e-5 * k));
    }
    c.run.duration = c.run.window = c.drive.times.back();
    const auto exact = integration::simulate(smooth, with_history).record.histories.front();
    const auto near = integration::simulate(c, with_history).record.histories.front();
    ASSERT_EQ(near.size(), exact.size());
    ASSERT_GT(exact.size(), 50U);
    for (std::size_t k = 0; k < exact.size(); ++k) {
        ASSERT_EQ(near[k].state, exact[k].state) << k;
        ASSERT_NEAR(near[k].from, exact[k].from, 4e-6) << k;
    }
}

// --- impacts

Case bouncing(parameters::ImpactKind law, double restitution) {
    Case c = evenly_driven(PaperCase::squeal, 0.1257, 0.2);
    c.contact().impact = law;
    c.contact().restitution = restitution;
    return c;
}

// a sampled quantity followed beyond its sample by three derivatives
class Extrapolation {
public:
    // value and its first two derivatives at a sample, the second also at a neighbour `step` [s] away
    Extrapolation(double value, double rate, double bend, double neighbour_bend, double step)
        : value_(value),
          rate_(rate),
          bend_(bend),
          twist_((neighbour_bend - bend) / step) {}

    double value(double t) const { return value_ + t * (rate_ + t * (bend_ / 2.0 + t * twist_ / 6.0)); }
    double rate(double t) const { return rate_ + t * (bend_ + t * twist_ / 2.0); }

    // where the value is zero near here
    double root() const {
        double t = 0.0;
        for (int k = 0; k < 20; ++k)
            t -= value(t) / rate(t);
        return t;
    }

private:
    double value_, rate_, bend_, twist_;
};

Extrapolation gap_at(const record::Trace& trace, std::size_t k, std::size_t neighbour) {
    const auto gap = [](const std::vector<std::vector<double>>& of, std::size_t place) {
        return of[1][place] - of[2][place];
    };
    return {gap(trace.displacement, k), gap(trace.velocity, k), gap(trace.acceleration, k),
            gap(trace.acceleration, neighbour), trace.time[neighbour] - trace.time[k]};
}

Extrapolation tangent_at(const record::Trace& trace, std::size_t k, std::size_t neighbour) {
    return {trace.displacement[0][k], trace.velocity[0][k], trace.acceleration[0][k], trace.acceleration[0][neighbour],
            trace.time[neighbour] - trace.time[k]};
}

// Samples 2e-7 s apart are followed to the impact between them; the extrapolation misses (1e4 rad/s 2e-7 s)^3 / 6 =
// 1e-9 of velocities up to 1 m/s
TEST(ExactImpacts, ReboundWithTheirShareOfTheClosingVelocity) {
    for (const double e : {0.2, 0.5, 0.9, 1.0}) {
        Case c = bouncing(parameters::ImpactKind::restitution, e);
        c.run.duration = c.run.window = 0.05;
        const Motion motion = integration::simulate(c, {record::KeepHistory::yes, {0.0, 0.05, 2e-7}});
        const record::Trace& trace = motion.record.trace;
        int rebounds = 0;
        for (std::size_t k = 2; k + 2 < trace.time.size(); ++k) {
            const bool in_flight =
                std::all_of(trace.contacts.front().state.begin() + static_cast<std::ptrdiff_t>(k) - 1,
                            trace.contacts.front().state.begin() + static_cast<std::ptrdiff_t>(k) + 3,
                            [](ContactState s) { return s == ContactState::separation; });
            const double before = trace.velocity[1][k] - trace.velocity[2][k];
            const double after = trace.velocity[1][k + 1] - trace.velocity[2][k + 1];
            if (!in_flight || before > -1e-2 || after < 0.0) continue;
            const Extrapolation falling = gap_at(trace, k, k - 1), rising = gap_at(trace, k + 1, k + 2);
            EXPECT_NEAR(rising.rate(rising.root()), -e * falling.rate(falling.root()), 1e-8) << trace.time[k];
            ++rebounds;
        }
        EXPECT_GE(rebounds, 5) << e;
    }
}

// flights get shorter by e each time, infinitely many in a finite time; then the contact goes on closed
TEST(ExactImpacts, BounceToRest) {
    for (const double e : {0.2, 0.5, 0.7}) {
        const Motion motion = integration::simulate(bouncing(parameters::ImpactKind::restitution, e), with_history);
        EXPECT_TRUE(integration::has_result(motion.outcome)) << e;
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-10) << e;
        const auto flights = std::count_if(
            motion.record.histories.front().begin(), motion.record.histories.front().end(),
            [](const record::ContactInterval& interval) { return interval.state == ContactState::separation; });
        EXPECT_GT(flights, 20) << e;
    }
}

TEST(ExactImpacts, WithoutTangentialImpulseLeaveTheSlipAlone) {
    Case c = bouncing(parameters::ImpactKind::normal_only, 0.5);
    c.run.duration = c.run.window = 0.05;
    constexpr double interval = 2e-7;
    const Motion motion = integration::simulate(c, {record::KeepHistory::yes, {0.0, 0.05, interval}});
    const record::Trace& trace = motion.record.trace;
    int impacts = 0;
    for (const record::ContactInterval& stay : motion.record.histories.front()) {
        const auto k = static_cast<std::size_t>(stay.from / interval);
        if (stay.gap_velocity > -1e-3 || k < 1 || k + 2 >= trace.time.size()) continue;
        if (trace.contacts.front().state[k - 1] != ContactState::separation ||
            trace.contacts.front().state[k] != ContactState::separation ||
            trace.contacts.front().state[k + 1] != stay.state || trace.contacts.front().state[k + 2] != stay.state)
            continue;
        const Extrapolation before = tangent_at(trace, k, k - 1), after = tangent_at(trace, k + 1, k + 2);
        EXPECT_NEAR(after.rate(stay.from - trace.time[k + 1]), before.rate(stay.from - trace.time[k]), 1e-8);
        ++impacts;
    }
    EXPECT_GE(impacts, 5);
}

TEST(ExactImpacts, WithoutReboundArePlasticBitForBit) {
    const Motion plastic = integration::simulate(bouncing(parameters::ImpactKind::plastic, 0.5), with_history);
    const Motion dead = integration::simulate(bouncing(parameters::ImpactKind::restitution, 0.0), with_history);
    ASSERT_EQ(plastic.record.histories.front().size(), dead.record.histories.front().size());
    for (std::size_t k = 0; k < plastic.record.histories.front().size(); ++k) {
        EXPECT_EQ(plastic.record.histories.front()[k].from, dead.record.histories.front()[k].from);
        EXPECT_EQ(plastic.record.histories.front()[k].slip_velocity, dead.record.histories.front()[k].slip_velocity);
    }
    EXPECT_EQ(plastic.energy.residual, dead.energy.residual);
}

// the shares that high-order solvers with events give for the squeal of Table 1 over its 1 s
TEST(ExactImpacts, SeparationShareDependsOnTheirLaw) {
    Case c = parameters::paper_case(PaperCase::squeal);
    EXPECT_NEAR(share(integration::simulate(c).record, separation_index), 0.386, 0.005);
    c.contact().impact = parameters::ImpactKind::normal_only;
    EXPECT_NEAR(share(integration::simulate(c).record, separation_index), 0.488, 0.005);
}

}  // namespace
}  // namespace stridor
