#include "contract/engine_contract.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/laws/friction.hpp"
#include "stridor/model/laws/rest.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/momentum.hpp"
#include "support/random_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stop_token>
#include <thread>
#include <vector>

namespace stridor::contract {
namespace {

using integration::Motion;
using integration::Reason;
using model::ContactState;
using parameters::Case;
using record::KeepHistory;

// all that can be kept of a run: history, and a trace of every eighth step or so
record::Request everything(const Case& c) {
    return {KeepHistory::yes, {0.0, c.run.duration, 8.0 * c.run.step}};
}

Case with(const EngineUnderTest& engine, Case c) {
    engine.choose(c);
    return c;
}

// the columns of Table 1 at their full velocity, for 50 ms: all contact states and all changes between them
std::vector<Case> noisy_cases(const EngineUnderTest& engine) {
    std::vector<Case> cases;
    for (const auto which : {parameters::PaperCase::squeal, parameters::PaperCase::squeak, parameters::PaperCase::creak,
                             parameters::PaperCase::quiet})
        for (const double velocity : {-0.125, 0.125}) {
            Case c = with(engine, parameters::paper_case(which));
            c.drive.kind = parameters::DriveKind::constant;
            c.drive.velocity = velocity;
            c.run.duration = c.run.window = 0.05;
            cases.push_back(c);
        }
    return cases;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
    for (double& value : values)
        value *= factor;
    return values;
}

bool same_history(const record::ContactHistory& a, const record::ContactHistory& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const record::ContactInterval& x, const record::ContactInterval& y) {
                          return x.state == y.state && x.from == y.from && x.to == y.to &&
                                 x.slip_velocity == y.slip_velocity && x.gap_velocity == y.gap_velocity;
                      });
}

// states and the instants they begin at; velocities left aside
bool same_sequence(const record::ContactHistory& a, const record::ContactHistory& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const record::ContactInterval& x, const record::ContactInterval& y) {
                          return x.state == y.state && x.from == y.from && x.to == y.to;
                      });
}

// the same states, at instants that differ by this much [s] at most
bool near_history(const record::ContactHistory& a, const record::ContactHistory& b, double most) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [&](const record::ContactInterval& x, const record::ContactInterval& y) {
                          return x.state == y.state && std::abs(x.from - y.from) <= most;
                      });
}

bool same_times(const record::Record& a, const record::Record& b) {
    return std::equal(a.phases.begin(), a.phases.end(), b.phases.begin(), b.phases.end(),
                      [](const record::Tally& x, const record::Tally& y) {
                          return x.contacts.front().time == y.contacts.front().time &&
                                 x.contacts.front().judged_time == y.contacts.front().judged_time;
                      });
}

bool same_trace(const record::Trace& a, const record::Trace& b) {
    return a.time == b.time && a.displacement == b.displacement && a.velocity == b.velocity &&
           a.acceleration == b.acceleration && a.contacts == b.contacts;
}

std::vector<classification::Category> categories(const Case& c, const record::Record& record) {
    std::vector<classification::Category> all;
    for (const record::Tally& tally : record.phases)
        all.push_back(classification::classify(analysis::evidence(tally, 0), c.verdict).category);
    return all;
}

// of a slip at a sample
double kinetic_friction(const Case& c, const record::Trace& trace, std::size_t k) {
    const double w = trace.velocity[0][k] - trace.surface_velocity[k];
    return std::abs(slip_ratio(model::friction_law(c.contact()), model::slip_of(w), w));
}

// [1] what it changes within a step: forces of a step belong to one instant of it
double velocity_share(const Case& c, const record::Trace& trace, std::size_t k) {
    if (is_state_wise(c.contact().friction)) return 0.0;
    double most = 0.0;
    for (std::size_t near = k > 0 ? k - 1 : k; near < std::min(k + 2, trace.time.size()); ++near)
        most = std::max(most, std::abs(trace.acceleration[0][near]));
    const model::SlopeRange slopes = slope_range(model::friction_law(c.contact()));
    return (slopes.most - slopes.least) * 2.0 * c.run.step * most;
}

// --- what holds for one run

TEST_P(EngineContract, StaysAtRestWhenNothingMoves) {
    Case c = with(GetParam(), {});
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.0;
    c.run.duration = c.run.window = 0.02;
    const Motion motion = moved(c, everything(c));
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    ASSERT_EQ(motion.record.histories.front().size(), 1U);
    EXPECT_EQ(motion.record.histories.front().front().state, ContactState::stick);
    // forces of 20 N at rounding, against 1e6 N/m: 20 1e-16 / 1e6
    const double force = 20.0 * GetParam().force_share;
    for (const std::vector<double>& displacement : motion.record.trace.displacement)
        for (const double u : displacement)
            ASSERT_LT(std::abs(u), 1e-20 + force / 1e6);
    // (F - F) / h^2 in a scheme with steps: displacements of 1e-21 m times m / h^2
    for (const double N : motion.record.trace.contacts.front().normal_force)
        ASSERT_NEAR(N, 20.0, 1e-8 + force);
}

TEST_P(EngineContract, ObeysCoulombAndUnilateralContactAtEveryInstant) {
    for (const Case& c : noisy_cases(GetParam())) {
        const Motion motion = moved(c, everything(c));
        const record::Trace& trace = motion.record.trace;
        ASSERT_GT(trace.time.size(), 1000U);
        const model::RestGrowth rest = model::rest_growth(c.contact());
        double moved_at = 0.0;  // [s] the last time that it was seen not to stick
        for (std::size_t k = 0; k < trace.time.size(); ++k) {
            const double N = trace.contacts.front().normal_force[k];
            const double T = std::abs(trace.contacts.front().friction_force[k]);
            const double rounding = 1e-14 * N;
            if (trace.contacts.front().state[k] != ContactState::stick) moved_at = trace.time[k];
            switch (trace.contacts.front().state[k]) {
                case ContactState::stick:
                    ASSERT_LE(T, (c.contact().static_friction + grown(rest, trace.time[k] - moved_at)) * N + rounding);
                    break;
                case ContactState::slip:
                    ASSERT_NEAR(T, kinetic_friction(c, trace, k) * N, rounding + velocity_share(c, trace, k) * N);
                    break;
                case ContactState::separation:
                    ASSERT_EQ(T, 0.0);
                    ASSERT_EQ(N, 0.0);
                    break;
            }
            ASSERT_GE(N, 0.0);
        }
    }
}

TEST_P(EngineContract, BalancesItsEnergy) {
    for (const Case& c : noisy_cases(GetParam())) {
        const Motion motion = moved(c);
        EXPECT_LT(std::abs(motion.energy.relative_residual()), GetParam().energy_tolerance) << c.title;
        EXPECT_GT(motion.energy.dashpot_loss, 0.0);
        EXPECT_GT(motion.energy.friction_loss, 0.0);
        // an impact only loses; at lift-off a scheme with steps may do work over a part of one step,
        // a share h of the whole
        EXPECT_GT(motion.energy.impact_loss, -100.0 * c.run.step * motion.energy.friction_loss);
    }
}

// of both bodies, over a run with all states and impacts: what springs, dashpots and loads do not explain is friction
TEST_P(EngineContract, BalancesItsMomentum) {
    for (Case c : noisy_cases(GetParam())) {
        const double interval = c.run.step;
        const Motion motion = moved(c, {KeepHistory::no, {0.0, c.run.duration, interval}});
        const double preload_impulse = c.contact().preload * c.run.duration;
        EXPECT_LT(support::friction_residual(solved(c), motion, interval), support::trapezoids * preload_impulse)
            << c.title << " at " << c.drive.velocity;
    }
}

TEST_P(EngineContract, RecordsAHistoryThatTilesTheRun) {
    for (const Case& c : noisy_cases(GetParam())) {
        const Motion motion = moved(c, everything(c));
        const record::ContactHistory& history = motion.record.histories.front();
        ASSERT_FALSE(history.empty());
        EXPECT_EQ(history.front().from, 0.0);
        EXPECT_NEAR(history.back().to, c.run.duration, c.run.step);
        std::array<double, model::contact_states> time{};
        for (std::size_t k = 0; k < history.size(); ++k) {
            time[model::index_of(history[k].state)] += history[k].to - history[k].from;
            ASSERT_GT(history[k].to, history[k].from);
            if (k == 0) continue;
            ASSERT_EQ(history[k].from, history[k - 1].to);
            ASSERT_NE(history[k].state, history[k - 1].state);
        }
        for (std::size_t k = 0; k < time.size(); ++k)
            EXPECT_NEAR(time[k], motion.record.phases.front().contacts.front().time[k],
                        1e-12);  // sums in another order
    }
}

TEST_P(EngineContract, HasNoResultOnceCancelled) {
    Case c = with(GetParam(), {});
    c.run.duration = 1e4;  // hours, were it not for the request
    c.run.window = 1.0;
    std::stop_source source;
    source.request_stop();
    const Motion motion = moved(c, {}, source.get_token());
    EXPECT_EQ(motion.outcome.reason, Reason::cancelled);
    EXPECT_FALSE(integration::has_result(motion.outcome));
    EXPECT_LT(motion.outcome.time, 10.0);
}

TEST_P(EngineContract, IsNotRunBeyondItsStepLimit) {
    Case c = with(GetParam(), {});
    if (GetParam().unstable_step == 0.0) {
        EXPECT_EQ(integration::cost(solved(c)).step_limit, std::numeric_limits<double>::infinity());
        return;
    }
    c.run.step = GetParam().unstable_step;
    const Motion motion = moved(c, everything(c));
    EXPECT_EQ(motion.outcome.reason, Reason::step_limit);
    EXPECT_EQ(motion.outcome.time, 0.0);
    EXPECT_TRUE(motion.record.histories.front().empty());
    EXPECT_FALSE(integration::has_result(motion.outcome));
}

// forces of K V / omega beyond 1e308 N: no number is left, and that is said
TEST_P(EngineContract, SaysWhenANumberLeavesDoublePrecision) {
    Case c = with(GetParam(), {});
    if (!GetParam().starts_stuck) c.contact().preload = 1e305;  // what slides at once is not dragged along
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 1e305;
    c.run.initial = parameters::Initial::stuck;
    const Motion motion = moved(c);
    EXPECT_EQ(motion.outcome.reason, Reason::diverged);
    EXPECT_FALSE(integration::has_result(motion.outcome));
    EXPECT_LE(motion.outcome.time, c.run.duration);
}

// --- what holds between runs, bit for bit

TEST_P(EngineContract, RepeatsItselfBitForBit) {
    rc::detail::checkGTest([&] {
        const Case c = with(GetParam(), support::any_sinusoidal_case());
        const Motion first = moved(c, everything(c));
        const Motion second = moved(c, everything(c));
        RC_ASSERT(same_history(first.record.histories.front(), second.record.histories.front()));
        RC_ASSERT(same_trace(first.record.trace, second.record.trace));
        RC_ASSERT(first.energy.residual == second.energy.residual);
    });
}

TEST_P(EngineContract, GivesTheSameBitsInEveryThread) {
    const std::vector<Case> cases = noisy_cases(GetParam());
    std::vector<Motion> apart(cases.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t k = 0; k < cases.size(); ++k)
            threads.emplace_back([&, k] { apart[k] = moved(cases[k], everything(cases[k])); });
    }
    for (std::size_t k = 0; k < cases.size(); ++k)
        EXPECT_TRUE(same_trace(moved(cases[k], everything(cases[k])).record.trace, apart[k].record.trace));
}

// what is kept of a run, and which part of it is looked at, changes nothing in the motion
TEST_P(EngineContract, MovesAlikeHoweverItIsWatched) {
    rc::detail::checkGTest([&] {
        Case c = with(GetParam(), support::any_sinusoidal_case());
        c.run.duration = c.run.window = 0.03;
        const Motion whole = moved(c, {KeepHistory::yes, {}});
        const Motion traced = moved(c, {KeepHistory::yes, {0.0007, 0.021, 1.3e-5}});
        RC_ASSERT(same_history(whole.record.histories.front(), traced.record.histories.front()));
        RC_ASSERT(same_times(whole.record, traced.record));
        RC_ASSERT(whole.energy.residual == traced.energy.residual);
        c.run.window = *support::number_between(0.021, 0.03);
        c.verdict.settling = *support::number_between(0.0, 0.5);
        const Motion cut = moved(c, {KeepHistory::yes, {}});
        if (GetParam().change_moves > 0.0) {
            RC_ASSERT(
                near_history(whole.record.histories.front(), cut.record.histories.front(), GetParam().change_moves));
            return;
        }
        RC_ASSERT(same_history(whole.record.histories.front(), cut.record.histories.front()));
        RC_ASSERT(whole.energy.stored == cut.energy.stored);
    });
}

// a trace has the same samples however long it goes on
TEST_P(EngineContract, SamplesAlikeHoweverLongTheTrace) {
    const Case c = noisy_cases(GetParam()).front();
    const double interval = 16.0 * c.run.step;
    const record::Trace all = moved(c, {KeepHistory::no, {0.0, c.run.duration, interval}}).record.trace;
    const record::Trace part = moved(c, {KeepHistory::no, {250.0 * interval, 500.0 * interval, interval}}).record.trace;
    ASSERT_GT(part.time.size(), 100U);
    for (std::size_t k = 0; k < part.time.size(); ++k) {
        const auto same = std::find(all.time.begin(), all.time.end(), part.time[k]);
        ASSERT_NE(same, all.time.end());
        const auto place = static_cast<std::size_t>(same - all.time.begin());
        ASSERT_EQ(part.displacement[0][k], all.displacement[0][place]);
        ASSERT_EQ(part.contacts.front().normal_force[k], all.contacts.front().normal_force[place]);
    }
}

// (a, V) -> (180 - a, -V) is the same motion seen in a mirror
TEST_P(EngineContract, MirrorsBitForBit) {
    rc::detail::checkGTest([&] {
        const Case c = with(GetParam(), support::any_constant_case());
        Case mirrored = c;
        mirrored.joint().incidence_angle = 180.0 - c.joint().incidence_angle;
        mirrored.drive.velocity = -c.drive.velocity;
        const Motion here = moved(c, everything(c));
        const Motion there = moved(mirrored, everything(mirrored));
        RC_ASSERT(same_times(here.record, there.record));
        RC_ASSERT(same_sequence(here.record.histories.front(), there.record.histories.front()));
        RC_ASSERT(there.record.trace.displacement[0] == scaled(here.record.trace.displacement[0], -1.0));
        RC_ASSERT(there.record.trace.displacement[1] == here.record.trace.displacement[1]);
        RC_ASSERT(there.record.trace.contacts.front().normal_force == here.record.trace.contacts.front().normal_force);
        RC_ASSERT(there.record.trace.contacts.front().friction_force ==
                  scaled(here.record.trace.contacts.front().friction_force, -1.0));
    });
}

// one length and one force scale: (F, V) or (F, A) times a power of two is the same motion, larger
TEST_P(EngineContract, ScalesWithPreloadAndDriveBitForBit) {
    rc::detail::checkGTest([&] {
        const bool is_constant = *support::whole_between(0, 1) == 0;
        const Case c = with(GetParam(), is_constant ? support::any_constant_case() : support::any_sinusoidal_case());
        const double factor = std::ldexp(1.0, *support::whole_between(-20, 20));
        Case larger = c;
        larger.contact().preload *= factor;
        larger.drive.velocity *= factor;
        larger.drive.amplitude *= factor;
        larger.contact().friction_slope /= factor;  // velocities are larger
        larger.contact().stribeck_velocity *= factor;
        larger.contact().viscous_friction /= factor;
        const Motion here = moved(c, everything(c));
        const Motion there = moved(larger, everything(larger));
        RC_ASSERT(same_times(here.record, there.record));
        RC_ASSERT(same_sequence(here.record.histories.front(), there.record.histories.front()));
        for (std::size_t dof = 0; dof < 3; ++dof)
            RC_ASSERT(there.record.trace.displacement[dof] == scaled(here.record.trace.displacement[dof], factor));
        RC_ASSERT(there.record.trace.contacts.front().normal_force ==
                  scaled(here.record.trace.contacts.front().normal_force, factor));
        RC_ASSERT(categories(c, here.record) == categories(larger, there.record));
    });
}

// upright, the joint is the mass on a belt: N = F whatever it does
TEST_P(EngineContract, UprightJointIsPressedByThePreloadAlone) {
    Case c = with(GetParam(), parameters::paper_case(parameters::PaperCase::squeak));
    c.joint().incidence_angle = 90.0;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = c.run.window = 0.05;
    const Motion motion = moved(c, everything(c));
    EXPECT_EQ(motion.record.phases.front().contacts.front().time[model::index_of(ContactState::separation)], 0.0);
    for (const double N : motion.record.trace.contacts.front().normal_force)
        ASSERT_NEAR(N, 200.0, 1e-6 + 200.0 * GetParam().force_share);  // displacements of 1e-19 m times m / h^2
}

}  // namespace
}  // namespace stridor::contract
