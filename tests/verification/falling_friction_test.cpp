// Friction that falls with the slip velocity feeds vibration. A mass on a belt of velocity V has
// T = (mu_d - s (V - x')) N:
//
//     m x'' + (c - s N) x' + k x = (mu_d - s V) N,   growth (s N - c)/(2 m)

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "support/belt_run.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor {
namespace {

constexpr double m = 1.0, k = 1e4, c = 5.0, N = 50.0;  // [kg], [N/m], [N*s/m], [N]
constexpr double V = 0.8;                              // [m/s]
constexpr double s = 0.2;                              // [s/m]
constexpr double growth = (s * N - c) / (2.0 * m);     // [1/s]
constexpr double push = 1e-3;                          // [m/s] at the start
constexpr double duration = 0.5;                       // [s]
constexpr double step = 1e-6;                          // [s]

model::Structure belt() {
    model::Structure structure = model::mass_on_belt({m, k, c, N, {}});
    structure.contacts[0].friction = model::Linear{0.8, 0.6, s};
    return structure;
}

// the disturbance at the run's end, from a push at the place of steady sliding
double expected_velocity(double time) {
    const double omega = std::sqrt(k / m - growth * growth);
    return push * std::exp(growth * time) * (std::cos(omega * time) + growth / omega * std::sin(omega * time));
}

record::Recorder recorder() {
    return {record::schedule(support::watched_case(V, {duration, duration})),
            {record::KeepHistory::no, {0.0, duration, 1e-3}},
            2};
}

// largest difference from the closed form, as a share of the largest disturbance
double largest_error(const integration::Motion& motion) {
    const record::Trace& trace = motion.record.trace;
    double most = 0.0;
    for (std::size_t at = 0; at < trace.time.size(); ++at)
        most = std::max(most, std::abs(trace.velocity[0][at] - expected_velocity(trace.time[at])));
    return most / (push * std::exp(growth * duration));
}

TEST(FallingFriction, FeedsSlidingAtTheRateOfItsSlopeByTheStepsOfThePaper) {
    const auto motion = integration::integrate_beta_2(belt(), support::constant_drive(V),
                                                      {parameters::Initial::sliding, push}, {step, 0.5}, recorder());
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_LT(largest_error(motion), 1e-7);  // O(h²): omega^3 h² t / 24 = 2e-8
}

TEST(FallingFriction, FeedsSlidingAtTheRateOfItsSlopeByStepsForManyContacts) {
    const integration::InitialState start = integration::initial_state(belt(), {parameters::Initial::sliding, push}, V);
    const auto motion = integration::integrate_moreau(belt(), support::constant_drive(V), start, {step}, recorder());
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    // friction of the step's end acts all of it: s N h / 2 of the mass is missing, which moves the phase
    EXPECT_LT(largest_error(motion), 1.2 * s * N * step / (4.0 * m) * std::sqrt(k / m) * duration);
}

TEST(FallingFriction, FeedsSlidingAtTheRateOfItsSlopeByTaylorSeries) {
    const integration::InitialState start = integration::initial_state(belt(), {parameters::Initial::sliding, push}, V);
    const auto motion = integration::integrate_taylor(belt(), support::constant_drive(V), start, {}, recorder());
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    EXPECT_FALSE(motion.silence.has_value());
    EXPECT_LT(largest_error(motion), 1e-12);
}

TEST(FallingFriction, IsInTheEigenvaluesOfSliding) {
    const analysis::SlidingStability going = analysis::sliding_stability(belt(), parameters::Direction::going, V);
    EXPECT_EQ(going.kind, analysis::StabilityKind::flutter);
    EXPECT_NEAR(going.growth, growth, 1e-9);
    EXPECT_NEAR(going.frequency, std::sqrt(k / m - growth * growth) / base::two_pi, 1e-9);
    // beyond mu_d / s nothing rubs
    EXPECT_NEAR(analysis::sliding_stability(belt(), parameters::Direction::coming, 4.0).growth, -c / (2.0 * m), 1e-9);
}

// upright the joint is a mass on a belt; the verdict of a case knows the growth, too
TEST(FallingFriction, EntersACaseByItsName) {
    parameters::Case upright;
    upright.joint().incidence_angle = 90.0;
    upright.drive = support::constant_drive(V);
    upright.contact().friction = parameters::FrictionKind::linear;
    upright.contact().friction_slope = 0.5;  // beyond 1.2 m/s nothing rubs
    upright.run.step = 1e-5;
    upright.run.initial = parameters::Initial::sliding;
    upright.run.duration = upright.run.window = 0.05;
    const std::vector<parameters::Finding> found = parameters::findings(upright);
    EXPECT_TRUE(found.empty());  // the exact engine goes by Taylor series
    const double expected =
        (upright.contact().preload * 0.5 - upright.joint().flexural_damping) / (2.0 * upright.joint().mass);
    for (const auto engine : {parameters::Engine::exact, parameters::Engine::beta_2, parameters::Engine::moreau}) {
        upright.run.engine = engine;
        EXPECT_TRUE(parameters::findings(upright).empty());
        const integration::Motion motion = integration::simulate(upright);
        const record::Outlook& outlook = motion.record.phases.front().contacts.front().ending.outlook;
        EXPECT_NEAR(outlook.growth, expected, 1e-6 * expected);
    }
    upright.run.formulation = parameters::Formulation::massless;
    EXPECT_EQ(parameters::findings(upright).size(), 2U);  // of the formulation, and of the joint's inertia
}

}  // namespace
}  // namespace stridor
