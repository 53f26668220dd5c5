#include "stridor/integration/run/imposed_motion.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace stridor::integration {
namespace {

using parameters::Drive;
using parameters::DriveKind;

constexpr double two_pi = 2.0 * std::numbers::pi;

double position(const ImposedMotion& motion, long steps) {
    double sum = 0.0;
    for (long k = 0; k < steps; ++k)
        sum += motion.increment(k);
    return sum;
}

Drive sampled_drive(std::vector<double> times, std::vector<double> velocities) {
    Drive drive;
    drive.kind = DriveKind::sampled;
    drive.times = std::move(times);
    drive.velocities = std::move(velocities);
    return drive;
}

TEST(ConstantMotion, MovesByVelocityTimesStep) {
    Drive drive;
    drive.kind = DriveKind::constant;
    drive.velocity = -0.125;
    const ImposedMotion motion(drive, 0x1p-20);
    EXPECT_EQ(motion.increment(0), -0x1p-23);
    EXPECT_EQ(motion.increment(1L << 40), -0x1p-23);
    EXPECT_EQ(motion.at(3.0).velocity, -0.125);
    EXPECT_EQ(motion.at(3.0).acceleration, 0.0);
}

TEST(SinusoidalMotion, StartsGoingAtItsPeakVelocity) {
    const Drive drive;  // 4 mm at 5 Hz
    const ImposedMotion motion(drive, 1e-6);
    EXPECT_NEAR(motion.at(0.0).velocity, 0.12566370614359173, 1e-16);
    EXPECT_EQ(motion.at(0.0).acceleration, 0.0);
    EXPECT_EQ(motion.at(0.05).velocity, 0.0);
    EXPECT_NEAR(motion.at(0.05).acceleration, -4e-3 * two_pi * two_pi * 25.0, 1e-14);
    EXPECT_NEAR(motion.at(0.1).velocity, -0.12566370614359173, 1e-16);
}

// the sum of the increments is x2 = A sin(2 pi f t) whatever the step: they are exact chords, not V h
TEST(SinusoidalMotion, IncrementsAddUpToThePosition) {
    const Drive drive;
    for (const double step : {1e-2, 1e-3, 1e-5}) {
        const ImposedMotion motion(drive, step);
        const long steps = std::lround(0.83 / step);
        // rounding of each partial sum, at most A 2^-53 a step, and of the argument
        const double tolerance = drive.amplitude * 1.2e-16 * static_cast<double>(steps + 100);
        EXPECT_NEAR(position(motion, steps), drive.amplitude * std::sin(two_pi * 5.0 * 0.83), tolerance) << step;
    }
}

RC_GTEST_PROP(SinusoidalMotion, AccelerationIsTheSlopeOfTheVelocity, ()) {
    Drive drive;
    drive.frequency = *support::number_between(1.0, 50.0);
    const ImposedMotion motion(drive, 1e-6);
    const double time = *support::number_between(0.01, 2.0);
    constexpr double h = 1e-6;
    const double slope = (motion.at(time + h).velocity - motion.at(time - h).velocity) / (2.0 * h);
    const double omega = two_pi * drive.frequency;
    const double peak = drive.amplitude * omega;
    // truncation peak omega^3 h^2 / 6, rounding of the difference peak 4 2^-53 (1 + omega t) / h
    const double tolerance = peak * (omega * omega * omega * h * h / 6.0 + 4.5e-16 * (1.0 + omega * time) / h);
    RC_ASSERT(std::abs(slope - motion.at(time).acceleration) < tolerance);
}

TEST(SampledMotion, IsLinearInVelocityBetweenSamples) {
    const ImposedMotion motion(sampled_drive({0.0, 1.0, 3.0}, {0.0, 2.0, -2.0}), 0.25);
    EXPECT_EQ(motion.at(0.5).velocity, 1.0);
    EXPECT_EQ(motion.at(0.5).acceleration, 2.0);
    EXPECT_EQ(motion.at(1.0).velocity, 2.0);
    EXPECT_EQ(motion.at(2.0).velocity, 0.0);
    EXPECT_EQ(motion.at(2.0).acceleration, -2.0);
    EXPECT_EQ(motion.at(3.0).velocity, -2.0);
}

// trapezia: 1 in the first second, 1 and -1 in the next two
TEST(SampledMotion, PositionIsTheIntegralOfTheVelocity) {
    const ImposedMotion motion(sampled_drive({0.0, 1.0, 3.0}, {0.0, 2.0, -2.0}), 0.25);
    EXPECT_DOUBLE_EQ(position(motion, 4), 1.0);
    EXPECT_DOUBLE_EQ(position(motion, 8), 2.0);
    EXPECT_DOUBLE_EQ(position(motion, 12), 1.0);
}

Drive trapezoidal_drive() {
    Drive drive;
    drive.kind = DriveKind::trapezoidal;
    drive.frequency = 0.25;  // there in 2 s, back in 2 s
    drive.velocity = 0.5;
    drive.ramp = 0.5;
    return drive;
}

TEST(TrapezoidalMotion, RisesHoldsAndFalls) {
    const ImposedMotion motion(trapezoidal_drive(), 0.25, 9.0);
    EXPECT_EQ(motion.at(0.0).velocity, 0.0);
    EXPECT_EQ(motion.at(0.25).velocity, 0.25);
    EXPECT_EQ(motion.at(0.25).acceleration, 1.0);
    EXPECT_EQ(motion.at(1.0).velocity, 0.5);
    EXPECT_EQ(motion.at(1.0).acceleration, 0.0);
    EXPECT_EQ(motion.at(2.0).velocity, 0.0);
    EXPECT_EQ(motion.at(2.0).acceleration, -1.0);
    EXPECT_EQ(motion.at(3.0).velocity, -0.5);
    EXPECT_EQ(motion.at(5.0).velocity, 0.5);
}

// there: a trapezium of 2 s and 1 s, half a metre per second high; and back
TEST(TrapezoidalMotion, ComesBackEveryPeriod) {
    const ImposedMotion motion(trapezoidal_drive(), 0.25, 8.0);
    EXPECT_DOUBLE_EQ(position(motion, 8), 0.75);
    EXPECT_NEAR(position(motion, 16), 0.0, 1e-15);  // of sixteen sums below 1
    EXPECT_NEAR(position(motion, 24), 0.75, 1e-15);
}

TEST(TrapezoidalMotion, IsATriangleWithTheLongestRamp) {
    Drive drive = trapezoidal_drive();
    drive.ramp = 1.0;
    const ImposedMotion motion(drive, 0.25, 4.0);
    EXPECT_EQ(motion.profile().times, (std::vector<double>{0.0, 1.0, 3.0, 5.0, 6.0}));
    EXPECT_EQ(motion.at(0.5).velocity, 0.25);
    EXPECT_EQ(motion.at(2.0).velocity, 0.0);
}

TEST(SampledMotion, FollowsASampledSine) {
    Drive sine;
    sine.frequency = 2.0;
    Drive drive = sampled_drive({}, {});
    for (int k = 0; k <= 2000; ++k) {
        drive.times.push_back(k * 5e-4);
        drive.velocities.push_back(ImposedMotion(sine, 1.0).at(k * 5e-4).velocity);
    }
    const double omega = two_pi * 2.0;
    // linear interpolation: V'' dt^2 / 8
    const double tolerance = sine.amplitude * omega * omega * omega * 5e-4 * 5e-4 / 8.0;
    for (const double time : {0.0, 0.1234, 0.5, 0.77777})
        EXPECT_NEAR(ImposedMotion(drive, 1e-4).at(time).velocity, ImposedMotion(sine, 1e-4).at(time).velocity,
                    tolerance);
}

}  // namespace
}  // namespace stridor::integration
