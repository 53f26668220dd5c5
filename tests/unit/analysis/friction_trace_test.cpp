// The model's own friction forces, whose coefficients and drops are known from the case and from the contact history.

#include "stridor/analysis/friction/stretches.hpp"
#include "stridor/analysis/friction/trace.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/integration/exact/exact.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/belt_run.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace stridor::analysis {
namespace {

using model::ContactState;

record::Record run_belt(const support::BeltRun& run) {
    parameters::Case c;
    c.drive = support::constant_drive(1.0);  // one phase, whatever really drives the belt
    c.run.duration = c.run.window = run.duration;
    return integration::integrate_exact(model::mass_on_belt(run.belt), run.drive, run.start, {},
                                        record::Recorder(record::schedule(c), run.request, 2))
        .record;
}

// slips that begin out of a stick and end in one
long slips(const record::ContactHistory& history) {
    long count = 0;
    for (std::size_t k = 1; k + 1 < history.size(); ++k)
        count += history[k].state == ContactState::slip && history[k - 1].state == ContactState::stick ? 1 : 0;
    return count;
}

// a test of materials: 10 N, some millimetres a second, 20 Hz
support::BeltRun rig_run(double static_friction, double kinetic_friction) {
    constexpr double stiffness = 2000.0, w0 = 2.0 * std::numbers::pi * 20.0;
    support::BeltRun run;
    run.belt = {stiffness / (w0 * w0), stiffness, 0.0, 10.0, {static_friction, kinetic_friction}};
    run.drive = support::constant_drive(4e-3);
    run.start = {parameters::Initial::stuck, 0.0};
    run.duration = 10.0;
    run.request = {record::KeepHistory::yes, {0.0, run.duration, 1e-3}};
    return run;
}

// a scatter of a billionth of the mean: it is that of the deviations, not of a difference of squares
TEST(KineticFriction, HasAnUncertaintyThatRoundingDoesNotMake) {
    for (const double step : {1e-8, 3e-8, 7e-8}) {
        std::vector<double> force(1000, 4.0);  // a fifth settles, then ten means of 80 samples
        for (std::size_t k = 200; k < force.size(); ++k)
            force[k] += (k - 200) / 80 % 2 == 0 ? 0.0 : step;
        const FrictionTrace trace = friction_trace({100.0, force, {}, {}, 10.0}, {});
        EXPECT_EQ(trace.all.kinetic_friction.count, 10);
        EXPECT_NEAR(trace.all.kinetic_friction.value, 0.4 + 0.05 * step, 1e-14);
        EXPECT_NEAR(trace.all.kinetic_friction.uncertainty, 0.05 * step / 3.0, 1e-4 * step) << step;
    }
}

// one wild sample of a velocity must not make all others look like rest
TEST(ForceStretches, AreFoundPastASampleThatStandsOut) {
    std::vector<double> velocity(1000, 0.01), force(1000, 4.0);
    std::fill(velocity.begin() + 500, velocity.end(), -0.01);
    std::fill(force.begin() + 500, force.end(), -4.0);
    velocity[250] = 5.0;
    const FrictionMeasurement measurement{100.0, force, velocity, {}, 10.0};
    const std::vector<ForceStretch> stretches = force_stretches(measurement, force_ratios(measurement, {}), {});
    ASSERT_EQ(stretches.size(), 2U);
    EXPECT_EQ(stretches[0].to, 500U);
    EXPECT_EQ(stretches[1].direction, -1);
}

TEST(FrictionTrace, GivesBackTheCoefficientsOfTheBelt) {
    for (const auto& [mu_s, mu_d] : {std::pair{0.4, 0.3}, {0.8, 0.5}, {0.8, 0.2}, {0.35, 0.32}}) {
        const support::BeltRun run = rig_run(mu_s, mu_d);
        const record::Record record = run_belt(run);
        FrictionMeasurement measurement;
        measurement.rate = 1000.0;
        measurement.force = record.trace.contacts.front().friction_force;
        measurement.preload = 10.0;
        const FrictionTrace trace = friction_trace(measurement);
        EXPECT_EQ(trace.all.drops, slips(record.histories.front())) << mu_s;
        EXPECT_GT(trace.all.drops, 5);
        // between two samples the spring loads by k V dt: the peak is known to half of it, shared evenly by chance
        const double resolution = run.belt.stiffness * 4e-3 * 1e-3 / run.belt.preload;
        EXPECT_NEAR(trace.all.static_friction.value, mu_s, 0.5 * resolution);
        EXPECT_LE(trace.all.static_friction.uncertainty, resolution);
        EXPECT_EQ(trace.all.source, KineticSource::slips);
        EXPECT_NEAR(trace.all.kinetic_friction.value, mu_d, 1e-12);
        // down to the belt's next stick, 2 mu_d - mu_s, and from within a sample of mu_s
        EXPECT_NEAR(trace.all.mean_drop, 2.0 * (mu_s - mu_d) * 10.0, 1.5 * resolution * 10.0);
        ASSERT_EQ(trace.directions.size(), 1U);
        EXPECT_EQ(trace.directions.front().direction, 1);
        EXPECT_LT(trace.all.variation, 0.01);
    }
}

// What a rig measures, no slip lying so close before a reversal that the force has no time to rise again: the force
// through the spring, with noise and a drifting preload, going and coming
struct Rig {
    record::Record record;
    std::vector<double> force, velocity;
};

Rig rig_measurement(double noise) {
    support::BeltRun run = rig_run(0.4, 0.3);
    run.belt.damping = 0.2;
    run.drive = {};
    run.drive.kind = parameters::DriveKind::sampled;
    run.drive.times = {0.0, 0.05};
    run.drive.velocities = {0.0, 4e-3};
    for (int k = 0; k < 4; ++k) {
        const double turn = 5.1 + 5.2 * k, sign = k % 2 == 0 ? 1.0 : -1.0;
        run.drive.times.insert(run.drive.times.end(), {turn - 0.05, turn + 0.05});
        run.drive.velocities.insert(run.drive.velocities.end(), {sign * 4e-3, -sign * 4e-3});
    }
    run.duration = 20.6;
    run.request.trace.to = run.duration;
    Rig rig{run_belt(run), {}, {}};
    support::CounterRandom random(17);
    for (std::size_t k = 0; k < rig.record.trace.time.size(); ++k) {
        // nearly a normal distribution, of variance 1
        double sum = -6.0;
        for (int j = 0; j < 12; ++j)
            sum += random.between(0.0, 1.0);
        const double drift = 1.0 + 0.01 * rig.record.trace.time[k] / 20.0;
        rig.force.push_back(run.belt.stiffness * rig.record.trace.displacement[0][k] * drift + noise * sum);
        rig.velocity.push_back(rig.record.trace.surface_velocity[k]);
    }
    return rig;
}

TEST(FrictionTrace, SurvivesNoiseDriftAndReversals) {
    for (const double noise : {0.0, 0.02, 0.03}) {
        const Rig rig = rig_measurement(noise);
        for (const bool has_velocity : {false, true}) {
            FrictionMeasurement measurement;
            measurement.rate = 1000.0;
            measurement.force = rig.force;
            measurement.preload = 10.0;
            if (has_velocity) measurement.velocity = rig.velocity;
            const FrictionTrace trace = friction_trace(measurement);
            EXPECT_EQ(trace.all.drops, slips(rig.record.histories.front()))
                << noise << (has_velocity ? " with velocity" : "");
            EXPECT_NEAR(trace.noise, noise, 0.1 * noise + 2e-3);
            ASSERT_EQ(trace.directions.size(), 2U);
            for (const FrictionFigures& figures : trace.directions) {
                // the spring overshoots by sqrt(1 + 1/lambda^2), lambda = 16: 0.002 of D/N; the drift's mean is 0.5 %
                EXPECT_NEAR(figures.static_friction.value, 0.4, 0.005 + noise / 10.0);
                EXPECT_NEAR(figures.kinetic_friction.value, 0.3, 0.005 + noise / 10.0);
                EXPECT_GT(figures.drops, 10);
            }
        }
    }
}

TEST(FrictionTrace, MeasuresTheDistanceSlid) {
    const Rig rig = rig_measurement(0.0);
    const FrictionTrace trace = friction_trace({1000.0, rig.force, rig.velocity, {}, 10.0});
    EXPECT_NEAR(trace.all.distance, 20.6 * 4e-3, 2e-3);
    EXPECT_NEAR(trace.all.moving_time, 20.6, 0.5);
}

TEST(FrictionTrace, OfSteadySlidingHasNoDrops) {
    // breakaway at 0.5, then 0.4 with noise and a slow wave of 2 %
    support::CounterRandom random(23);
    std::vector<double> force(5000);
    for (std::size_t k = 0; k < force.size(); ++k) {
        const double t = static_cast<double>(k) / 1000.0;
        const double steady = 4.0 + 0.08 * base::sine_cosine_of_turns(0.3 * t).sine;
        force[k] = (t < 0.5 ? 10.0 * t : steady) + random.between(-0.02, 0.02);
    }
    const FrictionTrace trace = friction_trace({1000.0, force, {}, {}, 10.0});
    EXPECT_EQ(trace.all.drops, 0);
    EXPECT_EQ(trace.all.source, KineticSource::steady_sliding);
    EXPECT_NEAR(trace.all.kinetic_friction.value, 0.4, 0.005);
    EXPECT_LT(trace.all.kinetic_friction.uncertainty, 0.005);
    EXPECT_NEAR(trace.all.static_friction.value, 0.5, 0.005);
    EXPECT_EQ(trace.all.static_friction.count, 1);
}

TEST(FrictionTrace, SaysSoWhereItIsSampledTooSlowly) {
    support::BeltRun run = rig_run(0.4, 0.3);
    run.request.trace.interval = 0.03;  // longer than a slip
    const record::Record record = run_belt(run);
    const FrictionTrace trace =
        friction_trace({1.0 / 0.03, record.trace.contacts.front().friction_force, {}, {}, 10.0});
    EXPECT_FALSE(trace.notes.empty());
    EXPECT_NEAR(trace.all.kinetic_friction.value, 0.3, 0.02);
    EXPECT_NEAR(trace.all.static_friction.value, 0.4, 0.02);
}

// rises from 3 to 4 N within 0.2 s and falls back within so many milliseconds, sampled at 1 kHz
std::vector<double> sawtooth(int fall) {
    constexpr int rise = 200;
    std::vector<double> force;
    for (int tooth = 0; tooth < 20; ++tooth) {
        for (int k = 0; k < rise; ++k)
            force.push_back(3.0 + static_cast<double>(k) / rise);
        for (int k = 0; k < fall; ++k)
            force.push_back(4.0 - static_cast<double>(k) / fall);
    }
    return force;
}

TEST(FrictionTrace, SaysSoWhereMostSlipsAreShorterThanTwoSamples) {
    for (const int fall : {1, 2, 3, 5}) {
        const FrictionTrace trace = friction_trace({1000.0, sawtooth(fall), {}, {}, 10.0});
        EXPECT_EQ(trace.all.drops, 19) << "the last tooth does not fall";
        EXPECT_EQ(trace.notes.size(), fall <= 2 ? 1U : 0U) << fall << " ms";
    }
}

TEST(FrictionTrace, TellsSizesAndTimesOfDrops) {
    const FrictionTrace trace = friction_trace({1000.0, sawtooth(5), {}, {}, 10.0});
    EXPECT_NEAR(trace.all.mean_drop, 1.0, 1e-9);
    EXPECT_NEAR(trace.all.largest_drop, 1.0, 1e-9);
    EXPECT_NEAR(trace.all.variation, 0.0, 1e-9);
    EXPECT_NEAR(trace.all.drop_rate, 1.0 / 0.205, 0.3);  // the stretch has 20 teeth and 19 drops
    ASSERT_EQ(trace.drops.size(), 19U);
    EXPECT_NEAR(trace.drops[0].time, 0.2, 1.5e-3);
    EXPECT_NEAR(trace.drops[0].duration, 5e-3, 1e-9);
    EXPECT_NEAR(trace.drops[7].time - trace.drops[6].time, 0.205, 1e-9);
}

// the level is the 95th percentile by nearest rank: the 15th of 16 samples, so that a wild one moves no threshold
TEST(FrictionTrace, HasTheLevelOfItsNinetyFifthPercentile) {
    std::vector<double> force{3.0, 3.1, 3.2, 3.3, 3.4, 3.5, 3.6, 3.7, 3.8, 3.9, 4.0, 4.1, 4.2, 4.3, 4.4, 90.0};
    FrictionTraceOptions options;
    options.noise_factor = 0.0;
    EXPECT_NEAR(friction_trace({1000.0, force, {}, {}, 10.0}, options).threshold, 0.05 * 0.44, 1e-15);
    force.insert(force.end() - 1, 4.5);  // 0.95 of 16 places is 15.2
    EXPECT_NEAR(friction_trace({1000.0, force, {}, {}, 10.0}, options).threshold, 0.05 * 0.45, 1e-15);
}

TEST(FrictionTrace, RefusesWhatIsNoTrace) {
    const std::vector<double> force(100, 3.0), zero(100, 0.0), few(5, 3.0);
    std::vector<double> broken = force;
    broken[50] = std::nan("");
    EXPECT_THROW(friction_trace({1000.0, force, {}, {}, 0.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, force, {}, {}, -1.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, few, {}, {}, 10.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, broken, {}, {}, 10.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, zero, {}, {}, 10.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, force, zero, {}, 10.0}), Error);
    EXPECT_THROW(friction_trace({1000.0, force, few, {}, 10.0}), Error);
    EXPECT_NO_THROW(friction_trace({1000.0, force, {}, {}, 10.0}));
}

TEST(FrictionTrace, OfAnOpenContactIsNotSaidToHaveNoForce) {
    const std::vector<double> force(200, 3.0), open(200, 0.0);
    try {
        friction_trace({1000.0, force, {}, open, 10.0});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.problem().what, "the contact is separated all the time");
    }
}

// newtons for kilonewtons, a preload of 10 mN for 10 N, a reading of an overload
TEST(FrictionTrace, RefusesCoefficientsThatNothingHas) {
    std::vector<double> force(1000, 3.0);
    FrictionMeasurement measurement{.rate = 1000.0, .force = force, .preload = 10.0};
    EXPECT_NEAR(friction_trace(measurement).all.kinetic_friction.value, 0.3, 1e-12);
    for (const auto& [factor, preload] : {std::pair{1000.0, 10.0}, {1.0, 0.01}, {1e29, 10.0}}) {
        force.assign(1000, 3.0 * factor);
        measurement.preload = preload;
        try {
            friction_trace(measurement);
            ADD_FAILURE() << "nothing was thrown";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::input);
            EXPECT_NE(error.problem().why.find("none is beyond 20"), std::string::npos);
            EXPECT_NE(error.problem().suggestion.find("preload"), std::string::npos);
        }
    }
}

TEST(FrictionTrace, NamesTheConditionsOfVda230_206) {
    EXPECT_EQ(vda_condition(10.0, 4e-3), "VDA 230-206, 10 N, 4 mm/s");
    EXPECT_EQ(vda_condition(40.5, 1.05e-3), "VDA 230-206, 40 N, 1 mm/s");
    EXPECT_EQ(vda_condition(20.0, 4e-3), "");
    EXPECT_EQ(vda_condition(10.0, std::nan("")), "");
}

}  // namespace
}  // namespace stridor::analysis
