// The velocity below which steady sliding is lost: Vc = Vs ln(N dmu/(c Vs)) of a mass with a dashpot (Le Rouzic, Le Bot
// and others 2013), by eigenvalues and by steps of time.

#include "stridor/analysis/critical_velocity.hpp"

#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/record/trace.hpp"
#include "support/belt_run.hpp"
#include "support/many_contacts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor {
namespace {

using parameters::Direction;

constexpr double preload = 5.0, fall = 0.7, stribeck = 0.1, dashpot = 2.0;  // [N], [1], [m/s], [N*s/m]
constexpr double published = 0.286220088;                                   // [m/s] to its last digit

model::Structure wiper(double mass, double frequency, double viscous = 0.0) {
    const double omega = base::two_pi * frequency;
    model::Structure structure = model::mass_on_belt({mass, mass * omega * omega, dashpot, preload, {}});
    structure.contacts[0].friction = model::Stribeck{1.0, 1.0 - fall, stribeck, 1.0, viscous};
    return structure;
}

TEST(CriticalVelocity, IsThatOfItsClosedForm) {
    const double closed = stribeck * std::log(preload * fall / (dashpot * stribeck));
    EXPECT_NEAR(closed, published, 5e-10);
    for (const Direction direction : {Direction::going, Direction::coming})
        EXPECT_NEAR(analysis::critical_velocity(wiper(1.0, 1000.0), direction).value_or(0.0), closed, 1e-9);
    // by twice the preload or half the damping it is larger by Vs ln 2
    model::Structure pressed = wiper(1.0, 1000.0);
    pressed.load *= 2.0;
    EXPECT_NEAR(analysis::critical_velocity(pressed, Direction::going).value_or(0.0), closed + stribeck * std::log(2.0),
                1e-9);
}

TEST(CriticalVelocity, IsZeroWhereSlidingLasts) {
    // friction that rises more than it falls: N k_v + c > N dmu/Vs
    EXPECT_EQ(analysis::critical_velocity(wiper(1.0, 1000.0, 7.0), Direction::going), 0.0);
    model::Structure coulomb = wiper(1.0, 1000.0);
    coulomb.contacts[0].friction = model::Coulomb{1.0, 0.3};
    EXPECT_FALSE(analysis::critical_velocity(coulomb, Direction::going));
}

TEST(CriticalVelocity, IsInfiniteWhereModesCoupleAtAnyVelocity) {
    parameters::Case c;  // the squeal of Table 1
    c.contact().friction = parameters::FrictionKind::stribeck;
    c.run.engine = parameters::Engine::beta_2;
    const model::Structure structure = model::structure_of(c);
    EXPECT_EQ(analysis::critical_velocity(structure, Direction::going), std::numeric_limits<double>::infinity());
}

// [1/s] growth of the disturbance over the run, from its largest velocities early and late
double simulated_growth(double velocity) {
    constexpr double duration = 8.0, push = 1e-5;  // [s], [m/s]
    constexpr double mass = 0.01, step = 2e-5;     // [kg], [s]: 100 Hz in 500 steps
    const record::Schedule schedule = record::schedule(support::watched_case(velocity, {duration, duration}));
    const integration::Motion motion = integration::integrate_beta_2(
        wiper(mass, 100.0), support::constant_drive(velocity), {parameters::Initial::sliding, push}, {step, 0.5},
        {schedule, {record::KeepHistory::no, {0.0, duration, 1e-4}}, 2});
    EXPECT_EQ(motion.outcome.reason, integration::Reason::completed);
    const std::vector<double>& v = motion.record.trace.velocity[0];
    const auto largest = [&](double from, double to) {
        double most = 0.0;
        for (std::size_t k = 0; k < v.size(); ++k)
            if (motion.record.trace.time[k] >= from && motion.record.trace.time[k] < to)
                most = std::max(most, std::abs(v[k]));
        return most;
    };
    return std::log(largest(6.0, 8.0) / largest(0.0, 2.0)) / 6.0;
}

TEST(CriticalVelocity, IsMetByTheSimulationWithinATenthOfAPercent) {
    const double slower = simulated_growth(published * 0.999), faster = simulated_growth(published * 1.001);
    EXPECT_GT(slower, 0.0);
    EXPECT_LT(faster, 0.0);
    // (N dmu exp(-V/Vs)/Vs - c)/(2 m), by a thousandth of Vc: c Vc 1e-3/(2 m Vs)
    const double expected = dashpot * published * 1e-3 / (2.0 * 0.01 * stribeck);
    EXPECT_NEAR(slower, expected, 0.1 * expected);
    EXPECT_NEAR(faster, -expected, 0.1 * expected);
}

}  // namespace
}  // namespace stridor
