// Springs whose force is a power of their deflection on one side, or a table, by Taylor series.

#include "stridor/model/laws/spring.hpp"

#include "stridor/integration/proofs/sliding_growth.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/series/taylor.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/contact/static_contact.hpp"
#include "support/many_contacts.hpp"

#include <boost/math/special_functions/beta.hpp>
#include <boost/numeric/odeint.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace stridor::integration {
namespace {

using model::ContactState;
using parameters::Initial;
using parameters::Interpolation;

constexpr double power_belt_velocity = 0.2;  // [m/s]
constexpr model::Belt power_belt{1.0, 1.0, 0.0, 1.0, {0.8, 0.4}};
const Eigen::Vector2d spring_along(1.0, 0.0), spring_across(0.0, 1.0);

model::Structure belt_with(const model::SpringLaw& law, const Eigen::Vector2d& direction = spring_along) {
    model::Structure structure = model::mass_on_belt(power_belt);
    structure.springs.push_back({direction, law});
    return structure;
}

const record::ContactHistory& states_of(const Motion& motion) {
    return motion.record.histories.front();
}

// a mass of 1 kg with K = (linear, 1) N/m that moves along x, far above the surface
model::Structure free_mass(double linear) {
    model::Structure structure = model::structure_of_size(2);
    structure.mass.setIdentity();
    structure.stiffness.setIdentity();
    structure.stiffness(0, 0) = linear;
    structure.contacts.front().normal = spring_across;
    structure.contacts.front().tangent = spring_along;
    structure.contacts.front().initial_gap = 1.0;
    return structure;
}

// [m] where a mass that begins at x with v is after a time
double place_after(const model::Structure& structure, double x, double v, double time) {
    Handover handover;
    InitialState start{Eigen::Vector2d(x, 0.0), Eigen::Vector2d(v, 0.0)};
    start.contacts = {parameters::ContactStart::separation};
    start.handover = &handover;
    const Motion motion = support::run_taylor(structure, 0.1, start, {time, time});
    EXPECT_EQ(motion.outcome.reason, Reason::completed);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);
    return handover.to.displacement[0];
}

// x'' = -k |x|^p sign(x) from rest at A goes from A to -b in sqrt((p + 1)/(2 k)) A^((1 - p)/2) (I(1) + I(b/A)), I(s)
// the integral of 1/sqrt(1 - s^(p + 1)), an incomplete Beta function. At x = 0 one spring lets go and the other begins.
TEST(PowerSpring, OscillatesAsTheBetaFunctionSays) {
    for (const double p : {1.0, 1.5, 2.0, 2.5, 3.0, 1.2}) {
        for (const double A : {0.7, 3e-3}) {
            const double k = 40.0, b = 0.6 * A;
            model::Structure structure = free_mass(0.0);
            const double F = k * std::pow(A, p);
            for (const double sign : {1.0, -1.0})
                structure.springs.push_back({sign * spring_along, model::power_spring(F, A, p, 0.0, 0.0)});
            const auto integral = [&](double s) {
                return boost::math::beta(1.0 / (p + 1.0), 0.5, std::pow(s, p + 1.0)) / (p + 1.0);
            };
            const double whole = boost::math::beta(1.0 / (p + 1.0), 0.5) / (p + 1.0);
            const double expected =
                std::sqrt((p + 1.0) / (2.0 * k)) * std::pow(A, 0.5 * (1.0 - p)) * (whole + integral(b / A));
            EXPECT_NEAR(place_after(structure, A, 0.0, expected), -b, 1e-12 * A) << p << " " << A;
        }
    }
}

// A mass on a spring k with a stop of stiffness k_s from x = g on, and back to x = -b: arcs of two
// circular motions
TEST(StopSpring, ReturnsAsThePiecesOfItsMotionSay) {
    const double k = 3.0, stop = 200.0, g = 0.2, b = 0.1, v = 1.3;
    const double w = std::sqrt(k), W = std::sqrt(k + stop);
    const double to_stop = std::asin(g * w / v) / w;
    const double at_stop = std::sqrt(v * v - w * w * g * g);
    const double middle = stop * g / (k + stop);
    const double in_stop = 2.0 * std::atan2(at_stop / W, g - middle) / W;
    const double expected = 2.0 * to_stop + in_stop + std::asin(b * w / v) / w;
    const std::vector<double> rows{-1.0, g, g + 1.0}, forces{0.0, 0.0, stop};
    for (const model::SpringLaw& law : {model::SpringLaw(model::power_spring(stop, 1.0, 1.0, g, 0.0)),
                                        model::SpringLaw(model::table_spring(rows, forces, Interpolation::linear))}) {
        model::Structure structure = free_mass(k);
        structure.springs.push_back({spring_along, law});
        EXPECT_NEAR(place_after(structure, 0.0, v, expected), -b, 1e-12);
    }
}

void expect_same_events(const Motion& motion, const Motion& expected, double tolerance) {
    ASSERT_GT(states_of(expected).size(), 6U);
    ASSERT_EQ(states_of(motion).size(), states_of(expected).size());
    for (std::size_t n = 0; n < states_of(motion).size(); ++n) {
        EXPECT_EQ(states_of(motion)[n].state, states_of(expected)[n].state);
        EXPECT_NEAR(states_of(motion)[n].from, states_of(expected)[n].from, tolerance) << n;
    }
}

TEST(TableSpring, ThroughALineIsTheLinearSpring) {
    const double k = 1.7;
    model::Structure linear = model::mass_on_belt(power_belt);
    linear.stiffness(0, 0) += k;
    const support::Watched watched{50.0, 50.0};
    const Motion expected = support::run_taylor(linear, power_belt_velocity, Initial::stuck, watched);
    std::vector<double> rows, forces;
    for (const double e : {-0.5, -0.2, -0.03, 0.0, 0.11, 0.17, 0.23}) {
        rows.push_back(e);
        forces.push_back(k * e);
    }
    for (const Interpolation interpolation : {Interpolation::cubic, Interpolation::linear}) {
        const Motion motion = support::run_taylor(belt_with(model::table_spring(rows, forces, interpolation)),
                                                  power_belt_velocity, Initial::stuck, watched);
        expect_same_events(motion, expected, 1e-12 * watched.duration);
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);
    }
}

// a spring that stands on the corner of its force, and moves with rounding only
TEST(PowerSpring, MayRestOnItsCorner) {
    const support::Watched watched{50.0, 50.0};
    const Motion expected =
        support::run_taylor(model::mass_on_belt(power_belt), power_belt_velocity, Initial::stuck, watched);
    for (const double p : {1.0, 1.5})
        for (const double sign : {1.0, -1.0}) {
            const Motion motion =
                support::run_taylor(belt_with(model::power_spring(50.0, 1e-3, p, 0.0, 1.0), sign * spring_across),
                                    power_belt_velocity, Initial::stuck, watched);
            expect_same_events(motion, expected, 1e-12 * watched.duration);
        }
}

const std::vector<double> rubber_rows{-0.4, -0.1, 0.0, 0.1, 0.2, 0.35, 0.5};
const std::vector<double> rubber_forces{-0.5, -0.06, 0.0, 0.03, 0.1, 0.4, 0.9};

std::vector<model::SpringLaw> stiffening_laws() {
    return {model::power_spring(0.3, 0.2, 1.5, 0.05, 1.0), model::power_spring(0.3, 0.2, 2.0, -0.1, 1.0),
            model::power_spring(2.0, 0.2, 1.0, 0.2, 1.0),
            model::table_spring(rubber_rows, rubber_forces, Interpolation::cubic),
            model::table_spring(rubber_rows, rubber_forces, Interpolation::linear)};
}

TEST(Spring, OfTheMirroredRunMovesAsTheMirrorDoes) {
    for (const model::SpringLaw& law : stiffening_laws()) {
        const Motion going =
            support::run_taylor(belt_with(law), power_belt_velocity, Initial::stuck, support::Watched{40.0, 40.0});
        const Motion coming = support::run_taylor(belt_with(law, -spring_along), -power_belt_velocity, Initial::stuck,
                                                  support::Watched{40.0, 40.0});
        ASSERT_GT(states_of(going).size(), 6U);
        ASSERT_EQ(states_of(going).size(), states_of(coming).size());
        for (std::size_t n = 0; n < states_of(going).size(); ++n)
            EXPECT_EQ(states_of(going)[n].from, states_of(coming)[n].from);
        EXPECT_EQ(going.energy.friction_loss, coming.energy.friction_loss);
    }
}

// A stick ends where spring and K hold mu_s N; the slip from there, by Fehlberg's method of order 8 in long double. A
// step that passes a corner of the force is halved down to rounding.
struct OdeSlip {
    long double duration = 0.0L;  // [s]
    long double from = 0.0L;      // [m]
    long double to = 0.0L;        // [m]
};

OdeSlip slip_by_odeint(const model::SpringLaw& law, const std::vector<double>& corners) {
    using Real = long double;
    using State = std::array<Real, 2>;
    const auto force = [&](Real x) {
        // exact to rounding of double, where the law is smooth
        const auto e = static_cast<double>(x);
        return static_cast<Real>(force_of(law, e)) +
               static_cast<Real>(stiffness_of(law, e)) * (x - static_cast<Real>(e));
    };
    const auto rate = [&](const State& x, State& dx, Real) { dx = {x[1], 0.4L - x[0] - force(x[0])}; };
    const double from = elongation_under(law, power_belt.stiffness, 0.8);
    boost::numeric::odeint::runge_kutta_fehlberg78<State, Real> stepper;
    State x{static_cast<Real>(from), static_cast<Real>(power_belt_velocity)};
    const auto passes = [&](const State& a, const State& b) {
        for (const double corner : corners) {
            const Real to_corner = static_cast<Real>(corner);
            if ((a[0] - to_corner) * (b[0] - to_corner) < 0.0L) return true;
        }
        return false;
    };
    Real time = 0.0L, h = 2e-3L;
    for (bool has_left = false;;) {
        State next = x;
        stepper.do_step(rate, next, time, h);
        const bool has_ended = has_left && next[1] >= static_cast<Real>(power_belt_velocity);
        if ((has_ended || passes(x, next)) && h > 1e-14L) {
            h /= 2;
            continue;
        }
        x = next;
        time += h;
        has_left = true;
        if (has_ended) return {time, static_cast<Real>(from), x[0]};
        h = std::min<Real>(2 * h, 2e-3L);
    }
}

TEST(Spring, HasTheStickAndSlipOfAnIndependentMethod) {
    for (const model::SpringLaw& law : stiffening_laws()) {
        const std::vector<double> corners =
            std::visit([](const auto& each) { return std::vector<double>(each.corners()); }, law);
        const Motion motion =
            support::run_taylor(belt_with(law), power_belt_velocity, Initial::stuck, support::Watched{60.0, 60.0});
        const OdeSlip slip = slip_by_odeint(law, corners);
        const double stick = static_cast<double>(slip.from - slip.to) / power_belt_velocity;
        const record::ContactHistory& states = states_of(motion);
        int sticks = 0, slips = 0;
        for (std::size_t n = 1; n + 1 < states.size(); ++n) {
            const double duration = states[n].to - states[n].from;
            const bool is_stick = states[n].state == ContactState::stick;
            (is_stick ? sticks : slips) += 1;
            EXPECT_NEAR(duration, is_stick ? stick : static_cast<double>(slip.duration), 1e-11) << law.index();
        }
        EXPECT_GT(sticks, 3);
        EXPECT_GT(slips, 3);
        EXPECT_EQ(motion.outcome.reason, Reason::completed);
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);
    }
}

// Friction that falls by s feeds a disturbance of sliding: it grows with s N/(2 m), whatever the spring
TEST(Spring, LetsNoGrowingSlidingBeCalledQuiet) {
    model::Structure structure = belt_with(model::CubicSpring{3.0});
    structure.contacts.front().friction = model::Linear{0.8, 0.8, 0.5};
    const support::Watched watched{3.0, 3.0};
    Motion motion = support::run_taylor(structure, power_belt_velocity, Initial::sliding, watched);
    ASSERT_EQ(states_of(motion).size(), 1U);
    tell_growth(structure, {.surface_velocity = power_belt_velocity, .end = 3.0, .least_slip = 0.98},
                motion.record.phases);
    EXPECT_NEAR(motion.record.phases.front().contacts.front().ending.outlook.growth, 0.25, 1e-9);
}

}  // namespace
}  // namespace stridor::integration
