// Springs whose force grows with the cube of their elongation, by Taylor series.

#include "stridor/integration/series/taylor.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/model/contact/equilibrium.hpp"
#include "stridor/model/linear/linearised.hpp"
#include "stridor/parameters/rules/engines.hpp"
#include "support/expected_error.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace stridor::integration {
namespace {

using model::ContactState;
using parameters::Initial;

constexpr double spring_belt_velocity = 0.2;  // [m/s]
constexpr model::Belt spring_belt{1.0, 1.0, 0.0, 1.0, {0.8, 0.4}};

model::Structure spring_belt_with(double cubic) {
    model::Structure structure = model::mass_on_belt(spring_belt);
    structure.springs.push_back({Eigen::Vector2d(1.0, 0.0), model::CubicSpring{cubic}});
    return structure;
}

// the states of the only contact
const record::ContactHistory& spring_states(const Motion& motion) {
    return motion.record.histories.front();
}

// u where the spring and K hold this force [N]
double spring_elongation(double force, double cubic) {
    double u = force / spring_belt.stiffness;
    for (int step = 0; step < 100; ++step)
        u -= (spring_belt.stiffness * u + cubic * u * u * u - force) / (spring_belt.stiffness + 3.0 * cubic * u * u);
    return u;
}

// A slip by Runge and Kutta's method in long double, from where the stick ends to where the mass has the belt's
// velocity again
struct SlipBySteps {
    long double duration = 0.0L;  // [s]
    long double from = 0.0L;      // [m]
    long double to = 0.0L;        // [m]
};

SlipBySteps slip_by_steps(double cubic) {
    using Real = long double;
    const Real from = spring_elongation(0.8, cubic);
    const auto pull = [&](Real u) { return 0.4L - u - static_cast<Real>(cubic) * u * u * u; };
    const auto step = [&](std::array<Real, 2>& x, Real h) {
        const auto rate = [&](const std::array<Real, 2>& at) { return std::array<Real, 2>{at[1], pull(at[0])}; };
        const auto moved = [&](const std::array<Real, 2>& by, Real share) {
            return std::array<Real, 2>{x[0] + share * by[0], x[1] + share * by[1]};
        };
        const std::array<Real, 2> a = rate(x), b = rate(moved(a, h / 2)), c = rate(moved(b, h / 2)),
                                  d = rate(moved(c, h));
        for (std::size_t i = 0; i < 2; ++i)
            x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    };
    std::array<Real, 2> x{from, static_cast<Real>(spring_belt_velocity)};
    Real time = 0.0L, h = 1e-4L;
    // the first step leaves w = 0
    step(x, h);
    time += h;
    while (h > 1e-17L) {
        std::array<Real, 2> next = x;
        step(next, h);
        if (next[0] < from && next[1] >= static_cast<Real>(spring_belt_velocity)) {
            h /= 2;
            continue;
        }
        x = next;
        time += h;
    }
    return {time, from, x[0]};
}

TEST(CubicSpring, OfNoStiffnessLeavesTheEventsOfTheLinearStructure) {
    const Motion without =
        support::run_taylor(model::mass_on_belt(spring_belt), spring_belt_velocity, Initial::stuck, {50.0, 50.0});
    const Motion with = support::run_taylor(spring_belt_with(0.0), spring_belt_velocity, Initial::stuck, {50.0, 50.0});
    ASSERT_GT(spring_states(without).size(), 8U);
    ASSERT_EQ(spring_states(with).size(), spring_states(without).size());
    for (std::size_t n = 0; n < spring_states(with).size(); ++n) {
        EXPECT_EQ(spring_states(with)[n].state, spring_states(without)[n].state);
        EXPECT_NEAR(spring_states(with)[n].from, spring_states(without)[n].from, 1e-12 * 50.0);
    }
}

// Duffing's oscillator from rest at A: x = A cn(Omega t | k), Omega² = a + b A², k² = b A²/(2 Omega²).
// Source: Abramowitz and Stegun (1964), chapter 16.
// It meets a surface at x = A/2 and stays there, since the springs push it on.
TEST(CubicSpring, MeetsASurfaceWhenTheEllipticIntegralSays) {
    for (const double linear : {1.0, 0.1}) {
        for (const double cubic : {0.3, 2.0, 40.0}) {
            const double A = 1.5;
            model::Structure structure = model::structure_of_size(2);
            structure.mass.setIdentity();
            structure.stiffness.setIdentity();
            structure.stiffness(0, 0) = linear;
            structure.contacts.front().normal = Eigen::Vector2d(1.0, 0.0);
            structure.contacts.front().tangent = Eigen::Vector2d(0.0, 1.0);
            structure.contacts.front().initial_gap = -0.5 * A;
            structure.springs.push_back({Eigen::Vector2d(1.0, 0.0), model::CubicSpring{cubic}});
            const double omega = std::sqrt(linear + cubic * A * A);
            const double k = std::sqrt(cubic * A * A / 2.0) / omega;
            const double pi = 3.14159265358979323846;
            const double expected = std::ellint_1(k, pi / 3.0) / omega;
            InitialState start{Eigen::Vector2d(A, 0.0), Eigen::Vector2d::Zero()};
            start.contacts = {parameters::ContactStart::separation};
            const Motion motion = support::run_taylor(structure, 0.1, start, {1.2 * expected, 1.2 * expected});
            ASSERT_GE(spring_states(motion).size(), 2U);
            EXPECT_NEAR(spring_states(motion)[1].from, expected, 1e-12 * expected) << linear << " " << cubic;
            support::expect_sound(motion);
        }
    }
}

TEST(CubicSpring, HasTheStickAndSlipOfAnIndependentMethod) {
    for (const double cubic : {0.5, 3.0, -0.1}) {
        const Motion motion =
            support::run_taylor(spring_belt_with(cubic), spring_belt_velocity, Initial::stuck, {60.0, 60.0});
        const SlipBySteps slip = slip_by_steps(cubic);
        const double stick = static_cast<double>(slip.from - slip.to) / spring_belt_velocity;
        const record::ContactHistory& states = spring_states(motion);
        ASSERT_GT(states.size(), 8U);
        int sticks = 0, slips = 0;
        for (std::size_t n = 1; n + 1 < states.size(); ++n) {
            const double duration = states[n].to - states[n].from;
            if (states[n].state == ContactState::stick) {
                ++sticks;
                EXPECT_NEAR(duration, stick, 1e-10) << cubic;
            } else {
                ++slips;
                EXPECT_NEAR(duration, static_cast<double>(slip.duration), 1e-10) << cubic;
            }
        }
        EXPECT_GT(sticks, 3);
        EXPECT_GT(slips, 3);
        EXPECT_EQ(motion.outcome.reason, Reason::completed);
        EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);
    }
}

TEST(CubicSpring, OfTheMirroredRunMovesAsTheMirrorDoes) {
    const Motion going = support::run_taylor(spring_belt_with(3.0), spring_belt_velocity, Initial::stuck, {40.0, 40.0});
    const Motion coming =
        support::run_taylor(spring_belt_with(3.0), -spring_belt_velocity, Initial::stuck, {40.0, 40.0});
    ASSERT_EQ(spring_states(going).size(), spring_states(coming).size());
    for (std::size_t n = 0; n < spring_states(going).size(); ++n)
        EXPECT_EQ(spring_states(going)[n].from, spring_states(coming)[n].from);
    EXPECT_EQ(going.energy.friction_loss, coming.energy.friction_loss);
}

TEST(CubicSpring, IsOfItsTangentNextToAnEquilibrium) {
    const double cubic = 3.0;
    const model::Structure structure = spring_belt_with(cubic);
    const double u = spring_elongation(0.4, cubic);
    const model::Equilibrium found = model::equilibrium(structure, {0.4});
    EXPECT_NEAR(found.displacement(0), u, 1e-14);
    EXPECT_NEAR(found.normal_forces(0), spring_belt.preload, 1e-14);
    const model::Structure near = model::linearised_at(structure, found.displacement);
    EXPECT_TRUE(near.springs.empty());
    EXPECT_NEAR(near.stiffness(0, 0), spring_belt.stiffness + 3.0 * cubic * u * u, 1e-13);
}

TEST(CubicSpring, IsRefusedByEnginesThatAreLinear) {
    for (const parameters::Method method : {parameters::Method::exact, parameters::Method::moreau,
                                            parameters::Method::massless, parameters::Method::beta_2})
        EXPECT_TRUE(refusal(method, {parameters::Demand::other_springs, {}}).has_value());
    EXPECT_FALSE(refusal(parameters::Method::taylor, {parameters::Demand::other_springs, {}}).has_value());
    const model::Structure structure = spring_belt_with(1.0);
    const InitialState start = initial_state(structure, {Initial::rest, 0.0}, spring_belt_velocity);
    support::expect_error(support::error_of([&] { support::run_moreau(structure, spring_belt_velocity, start, 1e-3); }),
                          "knows linear springs only", "");
}

}  // namespace
}  // namespace stridor::integration
