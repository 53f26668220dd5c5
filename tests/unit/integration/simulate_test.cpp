#include "stridor/integration/simulate.hpp"

#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace stridor::integration {
namespace {

using parameters::Case;

Case short_case() {
    Case c;
    c.run.step = 1e-5;
    return c;
}

TEST(Simulate, ComparesTwoSteps) {
    for (const parameters::Engine engine : {parameters::Engine::moreau, parameters::Engine::beta_2}) {
        Case c = short_case();
        c.drive.kind = parameters::DriveKind::constant;
        c.run.duration = c.run.window = 0.2;
        c.run.engine = engine;
        const Motion fine = simulate(c);
        ASSERT_EQ(fine.outcome.reason, Reason::completed);
        c.run.step *= 2.0;
        const Motion coarse = simulate(c);
        const record::ContactTally& tally = fine.record.phases[0].contacts[0];
        ASSERT_TRUE(tally.coarser);
        EXPECT_EQ(tally.coarser->time, coarse.record.phases[0].contacts[0].time);
        EXPECT_EQ(tally.coarser->judged_time, coarse.record.phases[0].contacts[0].judged_time);
        EXPECT_NE(tally.coarser->time, tally.time);
        c.run.engine = parameters::Engine::exact;
        EXPECT_FALSE(simulate(c).record.phases[0].contacts[0].coarser);
    }
}

TEST(Simulate, RecordsGoingAndComingOfAnAlternatingDrive) {
    const Motion motion = simulate(short_case());
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    EXPECT_NEAR(motion.outcome.time, 1.0, 1e-12);
    ASSERT_EQ(motion.record.phases.size(), 2U);
    double sum = 0.0;
    for (const record::Tally& tally : motion.record.phases)
        sum += std::accumulate(tally.contacts.front().time.begin(), tally.contacts.front().time.end(), 0.0);
    EXPECT_NEAR(sum, 1.0, 1e-10);  // 1e5 additions of numbers up to 1
}

TEST(Simulate, RecordsOnePhaseOfAConstantDrive) {
    Case c = short_case();
    c.drive.kind = parameters::DriveKind::constant;
    const Motion motion = simulate(c);
    ASSERT_EQ(motion.record.phases.size(), 1U);
    EXPECT_EQ(motion.record.phases[0].phase, record::Phase::all);
    EXPECT_NEAR(motion.record.phases[0].vibration_time, 0.5, 1e-12);
}

// V between corners is what engines know of both: a trapezoid has the bits of its samples, however it is solved
TEST(Simulate, SolvesATrapezoidAsItsSamples) {
    for (const parameters::Engine engine : {parameters::Engine::exact, parameters::Engine::beta_2}) {
        Case c = short_case();
        c.run.engine = engine;
        c.drive.kind = parameters::DriveKind::trapezoidal;
        const Motion motion = simulate(c);
        EXPECT_EQ(motion.outcome.reason, Reason::completed);
        const parameters::VelocityProfile profile = parameters::velocity_profile(c.drive, c.run.duration);
        c.drive.kind = parameters::DriveKind::sampled;
        c.drive.times = profile.times;
        c.drive.velocities = profile.velocities;
        const Motion sampled = simulate(c);
        ASSERT_EQ(motion.record.phases.size(), 2U);
        for (std::size_t k = 0; k < 2; ++k) {
            EXPECT_EQ(motion.record.phases[k].contacts.front().time, sampled.record.phases[k].contacts.front().time);
            EXPECT_GT(motion.record.phases[k].vibration_time, 0.1);
        }
        EXPECT_EQ(motion.energy.drive_work, sampled.energy.drive_work);
        EXPECT_NEAR(motion.energy.residual, 0.0, 1e-6 * std::abs(motion.energy.drive_work));  // beta_2: O(h²)
    }
}

TEST(Simulate, DoesNotRunBeyondTheStepLimit) {
    Case c;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = 1.1e-4;  // at twice that it is unstable
    const Motion motion = simulate(c);
    EXPECT_EQ(motion.outcome.reason, Reason::step_limit);
    EXPECT_EQ(motion.outcome.time, 0.0);
    for (const record::Tally& phase : motion.record.phases)
        for (const double time : phase.contacts.front().time)
            EXPECT_EQ(time, 0.0);
}

// the flows that a workspace keeps must not outlive anything that they were made from
TEST(Workspace, ChangesNoRun) {
    using Change = void (*)(Case&);
    constexpr std::array<std::pair<const char*, Change>, 9> changes{{
        {"mass", [](Case& c) { c.joint().mass *= 1.5; }},
        {"stiffness", [](Case& c) { c.plate.stiffness *= 1.5; }},
        {"damping", [](Case& c) { c.joint().axial_damping *= 1.5; }},
        {"angle", [](Case& c) { c.joint().incidence_angle -= 5.0; }},
        {"preload", [](Case& c) { c.contact().preload *= 1.5; }},
        {"static friction", [](Case& c) { c.contact().static_friction *= 1.1; }},
        {"kinetic friction", [](Case& c) { c.contact().kinetic_friction *= 0.5; }},
        {"kinetic friction coming", [](Case& c) { c.contact().kinetic_friction_coming *= 0.5; }},
        {"frequency", [](Case& c) { c.drive.frequency *= 2.0; }},
    }};
    Case base;
    base.contact().friction = parameters::FrictionKind::directional;
    base.drive.frequency = 10.0;
    base.run.duration = base.run.window = 0.2;
    for (const auto& [name, change] : changes) {
        Case changed = base;
        change(changed);
        Workspace workspace;
        simulate(base, {}, {}, workspace);
        const Motion after = simulate(changed, {}, {}, workspace);
        const Motion alone = simulate(changed);
        const Motion other = simulate(base);
        ASSERT_EQ(after.record.phases.size(), 2U);
        double difference = 0.0;
        for (std::size_t phase = 0; phase < 2; ++phase) {
            const record::Tally& tally = alone.record.phases[phase];
            EXPECT_EQ(after.record.phases[phase].contacts.front().time, tally.contacts.front().time) << name;
            for (std::size_t dof = 0; dof < tally.vibration.size(); ++dof) {
                EXPECT_EQ(after.record.phases[phase].vibration[dof].square_time, tally.vibration[dof].square_time)
                    << name;
                difference +=
                    std::abs(other.record.phases[phase].vibration[dof].square_time - tally.vibration[dof].square_time);
            }
        }
        EXPECT_GT(difference, 0.0) << name << " makes no difference";
    }
}

TEST(Outcome, HasAResultOnlyWhenCompletedOrSettled) {
    EXPECT_TRUE(has_result({Reason::completed, 1.0}));
    EXPECT_TRUE(has_result({Reason::settled, 0.5}));
    for (const Reason reason : {Reason::diverged, Reason::step_limit, Reason::cancelled})
        EXPECT_FALSE(has_result({reason, 0.5}));
}

// what each contact did, when and how fast
std::vector<double> history_numbers(const Motion& motion) {
    std::vector<double> numbers;
    for (const auto& history : motion.record.histories)
        for (const record::ContactInterval& interval : history)
            numbers.insert(numbers.end(), {static_cast<double>(interval.state), interval.from, interval.slip_velocity,
                                           interval.gap_velocity});
    return numbers;
}

parameters::TemperatureColumn friction_over_temperature(const std::string& joint, std::vector<double> values) {
    return {"joint." + joint + ".contact.kinetic_friction", std::move(values)};
}

// two lips, each with its own friction at 10 degC, 0.2 and 0.3
Case lips_over_temperature(std::vector<double> upper, std::vector<double> lower) {
    Case whole = parameters::two_lips();
    parameters::set_temperature_table(
        whole, {-30.0, 10.0, 50.0},
        {friction_over_temperature("upper", std::move(upper)), friction_over_temperature("lower", std::move(lower))});
    parameters::set_quantity(whole, "temperature.value", 10.0);
    whole.run.duration = whole.run.window = 0.1;
    whole.run.step = 1e-5;
    return whole;
}

TEST(Simulate, JointsOverTemperatureMoveAsThoseWithTheirNumbers) {
    Case typed = parameters::two_lips();
    typed.contact().kinetic_friction = 0.2;
    typed.joints[1].contact.kinetic_friction = 0.3;
    typed.run.duration = typed.run.window = 0.1;
    typed.run.step = 1e-5;
    const Case constant = lips_over_temperature({0.2, 0.2, 0.2}, {0.3, 0.3, 0.3});
    const Case changing = lips_over_temperature({0.7, 0.2, 0.1}, {0.1, 0.3, 0.8});
    Case warmer = changing;
    parameters::set_quantity(warmer, "temperature.value", 30.0);
    record::Request request;
    request.history = record::KeepHistory::yes;
    for (const parameters::Engine engine : {parameters::Engine::exact, parameters::Engine::moreau}) {
        const auto numbers = [&](Case c) {
            c.run.engine = engine;
            return history_numbers(simulate(c, request));
        };
        const std::vector<double> expected = numbers(typed);
        ASSERT_GT(expected.size(), 40U);
        EXPECT_EQ(numbers(constant), expected);
        EXPECT_EQ(numbers(changing), expected);
        EXPECT_NE(numbers(warmer), expected);
    }
}

}  // namespace
}  // namespace stridor::integration
