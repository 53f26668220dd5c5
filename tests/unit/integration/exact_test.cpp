#include "stridor/integration/exact.hpp"

#include "stridor/integration/simulate.hpp"
#include "stridor/model/mass_on_belt.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/record/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
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
    c.joint.axial_damping = 100.0;
    const Motion motion = simulate(c, {record::KeepHistory::yes, {0.0, 1e-4, 1e-6}});
    EXPECT_EQ(motion.record.history.front().state, ContactState::separation);
    EXPECT_EQ(motion.record.history.front().from, 0.0);
    const record::Trace& trace = motion.record.trace;
    EXPECT_LT(std::abs(trace.displacement[1].front() - trace.displacement[2].front()), 1e-20);
    EXPECT_LT(std::abs(trace.velocity[1].front() - trace.velocity[2].front()), 1e-20);
    EXPECT_LT(std::abs(motion.energy.relative_residual()), 1e-12);  // integrals and differences known to rounding
}

// with mu_s = mu_d a steady slip leaves the mass exactly at the limit of friction when its plate comes to a stop
TEST(Exact, HoldsAtTheLimitOfFrictionWhenThePlateStops) {
    for (int k = 1; k < 100; ++k) {
        const double mu = 0.013 * k;
        const model::Belt belt{1.3, 3e5, 10.0, 97.0, {mu, mu}};
        for (const double direction : {-0.1, 0.1}) {
            Case c = constant_case(direction, Initial::sliding);
            const Motion motion = integrate_exact<2>(
                model::mass_on_belt(belt), sampled({0.0, 1e-3, 1e-2}, {direction, 0.0, 0.0}), {Initial::sliding, 0.0},
                {}, record::Recorder(record::schedule(c), {record::KeepHistory::yes, {}}, 2));
            EXPECT_EQ(motion.outcome.reason, Reason::completed) << mu;
            // a slip velocity of rounding may take some periods of vibration to vanish
            EXPECT_EQ(motion.record.history.back().state, ContactState::stick) << mu;
        }
    }
}

TEST(Exact, HoldsAtTheLimitOfFrictionOnAPlateThatBends) {
    for (int angle = 1; angle < 180; angle += 2) {
        Case c = constant_case(-0.1, Initial::sliding);
        c.joint.incidence_angle = angle;
        c.contact.kinetic_friction = c.contact.static_friction = 0.4;
        c.run.perturbation = 0.0;
        c.drive = sampled({0.0, 1e-3, 1e-2}, {-0.1, 0.0, 0.0});
        const Motion motion = simulate(c, {record::KeepHistory::yes, {}});
        EXPECT_EQ(motion.outcome.reason, Reason::completed) << angle;
        EXPECT_EQ(motion.record.history.back().state, ContactState::stick) << angle;
    }
}

}  // namespace
}  // namespace stridor::integration
