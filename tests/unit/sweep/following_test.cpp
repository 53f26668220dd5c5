#include "stridor/sweep/following.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace stridor::sweep {
namespace {

using parameters::Case;

constexpr double mass = 0.1, stiffness = 1e5, ratio = 0.02, preload = 10.0, mu_s = 0.8, mu_d = 0.4;

// a mass on a belt: the joint lies along the belt, so that its normal force is the preload
Case mass_on_belt(double velocity) {
    Case c;
    c.joint().mass = mass;
    c.joint().incidence_angle = 0.0;
    c.joint().axial_stiffness = stiffness;
    c.joint().axial_damping = 2.0 * ratio * std::sqrt(stiffness * mass);
    c.contact().preload = preload;
    c.contact().static_friction = mu_s;
    c.contact().kinetic_friction = mu_d;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.duration = 0.4;
    c.run.window = 0.2;
    return c;
}

// After a stick the mass swings about its place of steady sliding, from (y, y') = ((mu_s - mu_d) N - c V) / k, V on.
// It sticks again if y' comes back to V: returns the largest y' [m/s] of that swing.
double largest_return(double velocity) {
    const double omega = std::sqrt(stiffness / mass);
    const double damping = 2.0 * ratio * std::sqrt(stiffness * mass);
    const double y = ((mu_s - mu_d) * preload - damping * velocity) / stiffness;
    const double swing = omega * std::sqrt(1.0 - ratio * ratio);
    const double other = (velocity + ratio * omega * y) / swing;
    double largest = 0.0;
    const double period = 2.0 * std::numbers::pi / swing;
    for (int k = 0; k <= 100000; ++k) {
        const double t = period * (0.5 + k / 100000.0);
        const double cosine = std::cos(swing * t), sine = std::sin(swing * t);
        const double rate = -ratio * omega * (y * cosine + other * sine) + swing * (other * cosine - y * sine);
        largest = std::max(largest, rate * std::exp(-ratio * omega * t));
    }
    return largest;
}

// above it stick-slip has no orbit, while steady sliding is stable at every velocity: c > 0, mu_d constant
double critical_velocity() {
    double low = 1e-3, high = 1.0;
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (largest_return(middle) >= middle ? low : high) = middle;
    }
    return low;
}

TEST(Following, KeepsStickSlipUpToItsCriticalVelocityAndSlidingAllTheWayDown) {
    const double V = critical_velocity();
    ASSERT_NEAR(V, 0.075, 0.01);  // (omega y)^2 = V^2 (exp(4 pi zeta) - 1), roughly
    const double step = 0.02 * V;
    const analysis::ScanRange over{"drive.velocity", 0.5 * V, 1.3 * V, 41};
    const Following following = follow(mass_on_belt(0.5 * V), over);
    ASSERT_EQ(following.runs.size(), 81U);
    double last_stick = 0.0;
    for (const FollowedRun& run : following.runs) {
        ASSERT_EQ(run.cells.size(), 1U);
        ASSERT_EQ(run.cells[0].status, Status::done);
        const double stick = figure_of(run.cells[0], "stick");
        if (run.way == FollowedWay::up && stick > 0.0) last_stick = run.value;
        if (run.way == FollowedWay::down) {
            EXPECT_EQ(stick, 0.0) << run.value;
        }
    }
    // a step of V may throw a swing off its orbit before there is none any more
    EXPECT_GT(last_stick, 0.85 * V);
    EXPECT_LE(last_stick, V + 1e-9);
    const std::vector<double> differing = hysteresis(following, 0);
    ASSERT_FALSE(differing.empty());
    EXPECT_EQ(differing.front(), 0.5 * V);
    EXPECT_LE(differing.back(), V);
    EXPECT_GT(differing.size(), static_cast<std::size_t>((0.85 * V - 0.5 * V) / step));
}

TEST(Following, HasNoHysteresisWhereThereIsOneMotion) {
    Case c = mass_on_belt(0.1);
    c.contact().static_friction = mu_d;
    const Following following = follow(c, {"drive.velocity", 0.05, 0.2, 4});
    EXPECT_TRUE(hysteresis(following, 0).empty());
    EXPECT_FALSE(following.runs.front().is_continued);
    EXPECT_TRUE(following.runs.back().is_continued);
}

// mu_d above mu_s is no case: the next value begins where the last good run ended
TEST(Following, GoesOnPastAValueWithoutAResult) {
    Case c = mass_on_belt(0.1);
    c.contact().kinetic_friction = 0.7;
    const Following following = follow(c, {"contact.kinetic_friction", 0.7, 0.9, 3});
    const auto status = [&](std::size_t run) { return following.runs[run].cells[0].status; };
    EXPECT_EQ(status(0), Status::done);
    EXPECT_EQ(status(2), Status::invalid);
    EXPECT_EQ(status(4), Status::done);
    EXPECT_TRUE(following.runs[4].is_continued);
}

TEST(Following, GivesTheSameBitsEachTime) {
    const Case c = mass_on_belt(0.05);
    const analysis::ScanRange over{"contact.preload", 5.0, 20.0, 5};
    const Following one = follow(c, over), other = follow(c, over);
    for (std::size_t k = 0; k < one.runs.size(); ++k)
        for (const CellFigure& figure : cell_figures()) {
            const double a = figure_of(one.runs[k].cells[0], figure), b = figure_of(other.runs[k].cells[0], figure);
            EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << figure.name;
        }
}

TEST(Following, FollowsAReversingDriveInBothDirections) {
    Case c = mass_on_belt(0.1);
    c.drive.kind = parameters::DriveKind::sinusoidal;
    c.drive.frequency = 20.0;
    c.drive.amplitude = 4e-4;
    const Following following = follow(c, {"drive.frequency", 20.0, 22.0, 3});
    ASSERT_EQ(following.directions.size(), 2U);
    for (const FollowedRun& run : following.runs)
        EXPECT_EQ(run.cells.size(), 2U);
}

TEST(Following, RefusesWhatItCannotFollow) {
    const auto refused = [](const std::string& key, double from, double to, int points) {
        return support::thrown_by([&] { follow(mass_on_belt(0.1), {key, from, to, points}); });
    };
    EXPECT_TRUE(refused("drive.velocity", 0.2, 0.1, 5).says("do not rise"));
    EXPECT_TRUE(refused("drive.velocity", 0.1, 0.2, 1).says("do not rise"));
    EXPECT_TRUE(refused("contact.friction", 0.1, 0.2, 5).says("no quantity"));
    EXPECT_TRUE(refused("drive.amplitude", 0.1, 0.2, 5).says("means nothing"));
    EXPECT_TRUE(refused("run.duration", 0.1, 0.2, 5).says("none of the system"));
    EXPECT_TRUE(refused("contact.preload", -1.0, 2.0, 5).says("out of range"));
}

}  // namespace
}  // namespace stridor::sweep
