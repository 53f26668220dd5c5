// What every engine promises of starts of the user's own, and of runs that go on where another one ended.

#include "contract/engine_contract.hpp"
#include "stridor/base/error.hpp"
#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stridor::contract {
namespace {

using integration::EndState;
using integration::Motion;
using integration::Reason;
using model::ContactState;
using parameters::Case;
using parameters::ContactStart;
using parameters::Initial;
using record::KeepHistory;

Case given(const EngineUnderTest& engine, double velocity = 0.1) {
    Case c;
    engine.choose(c);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = c.run.window = 0.02;
    c.run.early_ending = parameters::EarlyEnding::never;
    c.run.initial = Initial::given;
    return c;
}

record::Request whole_record(const Case& c) {
    return {KeepHistory::yes, {0.0, c.run.duration, 8.0 * c.run.step}};
}

Motion moved_by(const EngineUnderTest& engine, Case c, const record::Request& request) {
    if (engine.as_solved != nullptr) c = engine.as_solved(std::move(c));
    return integration::simulate(c, request);
}

// contacts without inertia take the place that forces give them
TEST_P(EngineContract, BeginsWhereTheStartSays) {
    if (!GetParam().starts_stuck) return;
    Case c = given(GetParam());
    c.joints[0].start = {.tangential = 2e-6, .normal = 3e-6, .tangential_velocity = 0.04, .normal_velocity = 0.02};
    c.plate.initial_normal = 1e-6;
    c.plate.initial_normal_velocity = -0.01;
    const Motion motion = moved_by(GetParam(), c, whole_record(c));
    const record::Trace& trace = motion.record.trace;
    ASSERT_EQ(trace.time.front(), 0.0);
    const double u[] = {2e-6, 3e-6, 1e-6}, v[] = {0.04, 0.02, -0.01};
    for (std::size_t dof = 0; dof < 3; ++dof) {
        // modes and back again
        EXPECT_NEAR(trace.displacement[dof].front(), u[dof], 1e-18);
        EXPECT_NEAR(trace.velocity[dof].front(), v[dof], 1e-14);
    }
    EXPECT_EQ(motion.record.histories.front().front().state, ContactState::separation);
    EXPECT_EQ(trace.contacts.front().normal_force.front(), 0.0);
}

// released above the plate without a load it meets it when the vibrations say so; near the start both fly freely
TEST_P(EngineContract, ReleasesAnOpenGapFromAbove) {
    if (!GetParam().starts_stuck) return;
    Case c = given(GetParam());
    c.joints[0].start = {.normal = 1e-5, .tangential_velocity = 0.1};
    const Motion motion = moved_by(GetParam(), c, whole_record(c));
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    const record::ContactHistory& history = motion.record.histories.front();
    ASSERT_GE(history.size(), 2U);
    EXPECT_EQ(history.front().state, ContactState::separation);
    EXPECT_NE(history[1].state, ContactState::separation);
    EXPECT_GT(motion.energy.impact_loss, 0.0);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), GetParam().energy_tolerance);
}

TEST_P(EngineContract, KeepsAGivenStick) {
    if (!GetParam().starts_stuck) return;
    Case c = given(GetParam());
    c.joints[0].start.contact = ContactStart::stick;
    c.joints[0].start.tangential = 1e-7;  // 1 N of friction at most
    const Motion motion = moved_by(GetParam(), c, whole_record(c));
    EXPECT_EQ(motion.record.histories.front().front().state, ContactState::stick);
    EXPECT_NEAR(motion.record.trace.velocity[0].front(), 0.1, 1e-14);
}

// a start that is said is the start of that name
TEST_P(EngineContract, StartsStuckAsTheStartOfThatName) {
    if (!GetParam().starts_stuck) return;
    Case c = given(GetParam());
    c.joints[0].start.contact = ContactStart::stick;
    const Motion said = moved_by(GetParam(), c, whole_record(c));
    c.run.initial = Initial::stuck;
    const Motion named = moved_by(GetParam(), c, whole_record(c));
    // the rest that one is solved for and the other says: 20 N at rounding on 1e6 N/m, before the first impact
    for (std::size_t dof = 0; dof < 3; ++dof)
        for (std::size_t k = 0; k < 32; ++k) {
            EXPECT_NEAR(said.record.trace.displacement[dof][k], named.record.trace.displacement[dof][k], 1e-18);
            EXPECT_NEAR(said.record.trace.velocity[dof][k], named.record.trace.velocity[dof][k], 1e-14);
        }
}

TEST_P(EngineContract, RefusesAStartThatNoContactStateHas) {
    if (!GetParam().starts_stuck) return;
    Case inside = given(GetParam());
    inside.joints[0].start.normal = -1e-6;
    Case closing = given(GetParam());
    closing.joints[0].start.normal_velocity = -0.1;
    for (const auto& [c, words] : {std::pair(inside, "surfaces are never in each other"),
                                   std::pair(closing, "no contact state has surfaces that move into each other")}) {
        const auto thrown = support::thrown_by([&, &each = c] { moved_by(GetParam(), each, {}); });
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        EXPECT_TRUE(thrown.says(words)) << thrown.message;
    }
}

// --- a run goes on where another one ended

Case noisy(const EngineUnderTest& engine, parameters::PaperCase which, double velocity) {
    Case c = parameters::paper_case(which);
    engine.choose(c);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = 0.05;
    c.run.window = 0.02;
    c.run.early_ending = parameters::EarlyEnding::never;
    return c;
}

Case as_solved(const EngineUnderTest& engine, Case c) {
    return engine.as_solved == nullptr ? c : engine.as_solved(std::move(c));
}

EndState ended_at(Case c, double duration, const EndState* from = nullptr) {
    c.run.duration = duration;
    integration::Ended ended = integration::run_to_end(c, from);
    EXPECT_EQ(ended.outcome.reason, Reason::completed);
    return std::move(ended.state);
}

void expect_same(const Motion& one, const Motion& other, double from) {
    EXPECT_EQ(one.outcome.reason, other.outcome.reason);
    const auto later = [&](const record::ContactHistory& history) {
        return std::find_if(history.begin(), history.end(), [&](const auto& each) { return each.to > from; });
    };
    const record::ContactHistory &a = one.record.histories.front(), &b = other.record.histories.front();
    const bool is_same = std::equal(later(a), a.end(), later(b), b.end(),
                                    [](const record::ContactInterval& x, const record::ContactInterval& y) {
                                        return x.state == y.state && x.from == y.from && x.to == y.to &&
                                               x.slip_velocity == y.slip_velocity && x.gap_velocity == y.gap_velocity;
                                    });
    EXPECT_TRUE(is_same);
    EXPECT_EQ(one.record.trace.time, other.record.trace.time);
    EXPECT_EQ(one.record.trace.displacement, other.record.trace.displacement);
    EXPECT_EQ(one.record.trace.velocity, other.record.trace.velocity);
    EXPECT_EQ(one.record.trace.acceleration, other.record.trace.acceleration);
    EXPECT_EQ(one.record.trace.contacts, other.record.trace.contacts);
    for (const auto term : {&integration::EnergyBalance::stored, &integration::EnergyBalance::preload_work,
                            &integration::EnergyBalance::drive_work, &integration::EnergyBalance::dashpot_loss,
                            &integration::EnergyBalance::friction_loss, &integration::EnergyBalance::impact_loss})
        EXPECT_EQ(one.energy.*term, other.energy.*term);
    ASSERT_EQ(one.record.phases.size(), other.record.phases.size());
    for (std::size_t k = 0; k < one.record.phases.size(); ++k) {
        const record::ContactTally& x = one.record.phases[k].contacts.front();
        const record::ContactTally& y = other.record.phases[k].contacts.front();
        EXPECT_EQ(x.time, y.time);
        EXPECT_EQ(x.judged_time, y.judged_time);
        EXPECT_EQ(x.ending.since, y.ending.since);
        for (std::size_t channel = 0; channel < one.record.phases[k].vibration.size(); ++channel)
            EXPECT_EQ(one.record.phases[k].vibration[channel].square_time,
                      other.record.phases[k].vibration[channel].square_time);
    }
}

TEST_P(EngineContract, GoesOnBitForBit) {
    for (const auto which : {parameters::PaperCase::squeal, parameters::PaperCase::creak})
        for (const double velocity : {-0.125, 0.125})
            for (const double break_at : {0.0123, 0.03}) {
                const Case c = as_solved(GetParam(), noisy(GetParam(), which, velocity));
                const record::Request later{KeepHistory::yes, {0.03, 0.05, 8.0 * c.run.step}};
                const Motion whole = integration::simulate(c, later);
                const EndState state = ended_at(c, break_at);
                expect_same(integration::go_on(c, state, later), whole, 0.03);
            }
}

TEST_P(EngineContract, GoesOnBitForBitUnderAReversingDrive) {
    for (const auto kind : {parameters::DriveKind::sinusoidal, parameters::DriveKind::trapezoidal}) {
        Case c = noisy(GetParam(), parameters::PaperCase::squeal, 0.125);
        c.drive.kind = kind;
        c.drive.frequency = 50.0;
        c.drive.amplitude = 4e-4;
        c.drive.ramp = 2e-3;
        c.run.duration = 0.08;
        c.run.window = 0.04;
        c = as_solved(GetParam(), std::move(c));
        const record::Request later{KeepHistory::yes, {0.04, 0.08, 8.0 * c.run.step}};
        const Motion whole = integration::simulate(c, later);
        // in the middle of a phase, and where the drive turns round
        for (const double break_at : {0.0123, 0.015, 0.02, 0.04})
            expect_same(integration::go_on(c, ended_at(c, break_at), later), whole, 0.04);
    }
}

TEST_P(EngineContract, MakesTheSameEndWithABreakAsWithout) {
    const Case c = as_solved(GetParam(), noisy(GetParam(), parameters::PaperCase::squeal, -0.125));
    const EndState whole = ended_at(c, 0.03);
    const EndState half = ended_at(c, 0.0123);
    const EndState gone_on = ended_at(c, 0.03, &half);
    EXPECT_EQ(gone_on.time, whole.time);
    EXPECT_EQ(gone_on.displacement, whole.displacement);
    EXPECT_EQ(gone_on.velocity, whole.velocity);
    EXPECT_EQ(gone_on.contacts, whole.contacts);
    // beta_2 looks at the largest displacements at other instants: a bound in its memory
    if (c.run.engine != parameters::Engine::beta_2) {
        EXPECT_EQ(gone_on.memory, whole.memory);
    }
}

// where the surface is at the start, and which way it goes
TEST_P(EngineContract, BeginsAtAPhaseOfTheDrive) {
    if (!GetParam().starts_stuck) return;  // its feet are rows that this start does not name
    Case c = given(GetParam());
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.frequency = 50.0;
    c.drive.amplitude = 4e-4;
    c.drive.phase = 60.0;
    c.run.duration = c.run.window = 0.04;
    const Motion motion = moved_by(GetParam(), c, whole_record(c));
    const double peak = 4e-4 * 2.0 * std::numbers::pi * 50.0;
    EXPECT_NEAR(motion.record.trace.surface_velocity.front(), 0.5 * peak, 1e-14);
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
}

}  // namespace
}  // namespace stridor::contract
