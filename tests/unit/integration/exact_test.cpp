#include "stridor/integration/exact/exact.hpp"

#include "stridor/integration/run/imposed_motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/record/schedule.hpp"
#include "support/random_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace stridor::integration {
namespace {

using model::ContactState;
using parameters::Case;
using parameters::DriveKind;
using parameters::Initial;

Case constant_case(double velocity, Initial initial) {
    Case c;
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.initial = initial;
    c.run.duration = c.run.window = 0.01;
    return c;
}

parameters::Drive sampled(std::vector<double> times, std::vector<double> velocities) {
    parameters::Drive drive;
    drive.kind = DriveKind::sampled;
    drive.times = std::move(times);
    drive.velocities = std::move(velocities);
    return drive;
}

// started with the plate, the joint's dashpots pull it up with Cxy |V| m2 / (m1 + m2) = 25 N: more than the preload
TEST(Exact, OpensAtOnceWhereDashpotsOutweighThePreload) {
    Case c = constant_case(-1.0, Initial::stuck);
    c.joint().axial_damping = 100.0;
    const Motion motion = simulate(c, {record::KeepHistory::yes, {0.0, 1e-4, 1e-6}});
    EXPECT_EQ(motion.record.histories.front().front().state, ContactState::separation);
    EXPECT_EQ(motion.record.histories.front().front().from, 0.0);
    const record::Trace& trace = motion.record.trace;
    EXPECT_LT(std::abs(trace.displacement[1].front() - trace.displacement[2].front()), 1e-20);
    EXPECT_LT(std::abs(trace.velocity[1].front() - trace.velocity[2].front()), 1e-20);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);  // integrals and differences known to rounding
}

// a mass that sticks follows its belt: 100 mm in turns of 20 s as well as 0.1 mm in turns of 20 ms
TEST(Exact, StuckFollowsASinusoidalDriveOfAnyFrequency) {
    for (const double frequency : {0.05, 50.0}) {
        parameters::Drive drive;
        drive.kind = DriveKind::sinusoidal;
        drive.frequency = frequency;
        drive.amplitude = 5e-3 / frequency;
        Case c;
        c.drive = constant_case(1.0, Initial::stuck).drive;  // one phase, whatever really drives the belt
        c.run.duration = c.run.window = 1.0 / frequency;
        const model::Belt belt{1.0, 1.0, 0.0, 1e6, {0.8, 0.6}};
        const record::Trace trace =
            integrate_exact(model::mass_on_belt(belt), drive, {Initial::stuck, 0.0}, {},
                            record::Recorder(record::schedule(c),
                                             {record::KeepHistory::no, {0.0, c.run.duration, 0.02 / frequency}}, 2))
                .record.trace;
        ASSERT_GE(trace.time.size(), 50U);
        const ImposedMotion imposed(drive, 1.0);
        for (std::size_t k = 0; k < trace.time.size(); ++k)
            EXPECT_NEAR(trace.velocity[0][k], imposed.at(trace.time[k]).velocity, 1e-12) << frequency << " " << k;
    }
}

// the same system on a clock that is 1024 times as slow
Case slowed(Case c) {
    constexpr double factor = 1024.0;
    for (double* stiffness : {&c.joint().axial_stiffness, &c.joint().flexural_stiffness, &c.plate.stiffness})
        *stiffness /= factor * factor;
    for (double* damping : {&c.joint().axial_damping, &c.joint().flexural_damping, &c.plate.damping})
        *damping /= factor;
    c.contact().preload /= factor * factor;
    c.drive.frequency /= factor;
    for (double* time : {&c.run.duration, &c.run.window})
        *time *= factor;
    return c;
}

// no law here has a time of its own: all states come in the same order, and at 1024 times the instants
TEST(Exact, KnowsNoUnitOfTime) {
    std::size_t separations = 0;
    for (const auto which : {parameters::PaperCase::squeal, parameters::PaperCase::squeak}) {
        Case c = parameters::paper_case(which);
        c.run.duration = c.run.window = 0.3;
        const auto history_of = [](const Case& run) {
            return simulate(run, {record::KeepHistory::yes, {}}).record.histories.front();
        };
        const record::ContactHistory quick = history_of(c), slow = history_of(slowed(c));
        ASSERT_EQ(quick.size(), slow.size());
        ASSERT_GT(quick.size(), 20U);
        for (std::size_t k = 0; k < quick.size(); ++k) {
            EXPECT_EQ(slow[k].state, quick[k].state) << k;
            EXPECT_NEAR(slow[k].from / 1024.0, quick[k].from, 1e-9) << k;
            separations += quick[k].state == ContactState::separation ? 1 : 0;
        }
    }
    EXPECT_GT(separations, 20U);
}

// with mu_s = mu_d a steady slip leaves the mass exactly at the limit of friction when its plate comes to a stop
TEST(Exact, HoldsAtTheLimitOfFrictionWhenThePlateStops) {
    for (int k = 1; k < 100; ++k) {
        const double mu = 0.013 * k;
        const model::Belt belt{1.3, 3e5, 10.0, 97.0, {mu, mu}};
        for (const double direction : {-0.1, 0.1}) {
            Case c = constant_case(direction, Initial::sliding);
            const Motion motion = integrate_exact(
                model::mass_on_belt(belt), sampled({0.0, 1e-3, 1e-2}, {direction, 0.0, 0.0}), {Initial::sliding, 0.0},
                {}, record::Recorder(record::schedule(c), {record::KeepHistory::yes, {}}, 2));
            EXPECT_EQ(motion.outcome.reason, Reason::completed) << mu;
            // a slip velocity of rounding may take some periods of vibration to vanish
            EXPECT_EQ(motion.record.histories.front().back().state, ContactState::stick) << mu;
        }
    }
}

TEST(Exact, HoldsAtTheLimitOfFrictionOnAPlateThatBends) {
    for (int angle = 1; angle < 180; angle += 2) {
        Case c = constant_case(-0.1, Initial::sliding);
        c.joint().incidence_angle = angle;
        c.contact().kinetic_friction = c.contact().static_friction = 0.4;
        c.run.perturbation = 0.0;
        c.drive = sampled({0.0, 1e-3, 1e-2}, {-0.1, 0.0, 0.0});
        const Motion motion = simulate(c, {record::KeepHistory::yes, {}});
        EXPECT_EQ(motion.outcome.reason, Reason::completed) << angle;
        EXPECT_EQ(motion.record.histories.front().back().state, ContactState::stick) << angle;
    }
}

// --- the same bits whatever the instruction set

Motion by(InstructionSet set, const Case& c) {
    const double interval = c.run.duration / 997.0;
    return integrate_exact(
        model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation}, {c.run.early_ending, set},
        record::Recorder(record::schedule(c), {record::KeepHistory::yes, {0.0, c.run.duration, interval}}, 3));
}

bool same(const Motion& a, const Motion& b) {
    const record::Trace& x = a.record.trace;
    const record::Trace& y = b.record.trace;
    const bool same_trace = x.time == y.time && x.displacement == y.displacement && x.velocity == y.velocity &&
                            x.acceleration == y.acceleration && x.contacts == y.contacts;
    const bool same_history = std::equal(
        a.record.histories.front().begin(), a.record.histories.front().end(), b.record.histories.front().begin(),
        b.record.histories.front().end(), [](const record::ContactInterval& p, const record::ContactInterval& q) {
            return p.state == q.state && p.from == q.from && p.to == q.to && p.slip_velocity == q.slip_velocity &&
                   p.gap_velocity == q.gap_velocity;
        });
    const bool same_tallies =
        std::equal(a.record.phases.begin(), a.record.phases.end(), b.record.phases.begin(), b.record.phases.end(),
                   [](const record::Tally& p, const record::Tally& q) {
                       const record::ContactTally& at = p.contacts.front();
                       const record::ContactTally& bt = q.contacts.front();
                       return at.time == bt.time && at.judged_time == bt.judged_time &&
                              std::equal(p.vibration.begin(), p.vibration.end(), q.vibration.begin(), q.vibration.end(),
                                         [](const record::Vibration& u, const record::Vibration& v) {
                                             return u.square_time == v.square_time && u.peak_square == v.peak_square;
                                         });
                   });
    const bool same_energy = a.energy.stored == b.energy.stored && a.energy.drive_work == b.energy.drive_work &&
                             a.energy.dashpot_loss == b.energy.dashpot_loss &&
                             a.energy.friction_loss == b.energy.friction_loss &&
                             a.energy.impact_loss == b.energy.impact_loss;
    return a.outcome.reason == b.outcome.reason && a.outcome.time == b.outcome.time && same_trace && same_history &&
           same_tallies && same_energy;
}

// one test for each set of this machine; the baseline's own is that a run repeats itself
class AnyInstructionSet : public testing::TestWithParam<InstructionSet> {};

TEST_P(AnyInstructionSet, GivesTable1BitForBit) {
    using parameters::PaperCase;
    for (const PaperCase which : {PaperCase::squeal, PaperCase::squeak, PaperCase::creak, PaperCase::quiet}) {
        const Case c = parameters::paper_case(which);
        EXPECT_TRUE(same(by(GetParam(), c), by(InstructionSet::baseline, c)));
    }
}

TEST_P(AnyInstructionSet, GivesAnyMotionBitForBit) {
    rc::detail::checkGTest([&] {
        const int kind = *support::whole_between(0, 2);
        Case c = kind == 0 ? support::any_constant_case() : support::any_sinusoidal_case();
        if (kind == 2) c.drive = sampled({0.0, 0.004, 0.011, 0.02}, {0.1, -0.05, -0.05, 0.2});
        c.contact().impact = static_cast<parameters::ImpactKind>(*support::whole_between(0, 2));
        RC_ASSERT(same(by(GetParam(), c), by(InstructionSet::baseline, c)));
    });
}

std::string name_of(const testing::TestParamInfo<InstructionSet>& which) {
    constexpr std::array names{"Baseline", "Avx2", "Avx512"};
    return names[static_cast<std::size_t>(which.param)];
}

INSTANTIATE_TEST_SUITE_P(OfThisMachine, AnyInstructionSet, testing::ValuesIn(available_instruction_sets()), name_of);

}  // namespace
}  // namespace stridor::integration
