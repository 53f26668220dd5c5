#include "stridor/integration/exact.hpp"

#include "stridor/integration/simulate.hpp"
#include "stridor/model/mass_on_belt.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/record/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace stridor::integration
