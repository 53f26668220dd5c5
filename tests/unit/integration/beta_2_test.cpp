#include "stridor/integration/beta_2/beta_2.hpp"

#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/record/schedule.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace stridor::integration {
namespace {

using model::ContactState;
using parameters::Initial;

constexpr double w0 = 500.0;                                  // [rad/s]
const model::Belt belt{1.0, w0* w0, 0.0, 100.0, {0.8, 0.3}};  // D = (mu_s - mu_d) F / k = 0.2 mm
constexpr double velocity = 0.1;                              // [m/s]

parameters::Case moving(double speed, double duration) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = speed;
    c.run.duration = c.run.window = duration;
    return c;
}

Motion run(const model::Structure& structure, double speed, double duration, const Start& start, const Beta2& settings,
           const record::Request& request = {}) {
    const parameters::Case c = moving(speed, duration);
    return integrate_beta_2(structure, c.drive, start, settings, record::Recorder(record::schedule(c), request, 2));
}

TEST(StableStep, IsThatOfTheExplicitNewmarkScheme) {
    EXPECT_DOUBLE_EQ(stable_step(0.5, 1e4), 2e-4);  // central difference: 2 / omega
    EXPECT_DOUBLE_EQ(stable_step(1.0, 1e4), std::sqrt(2.0) * 1e-4);
}

TEST(StableStep, IsTheFirstThatIsNotRun) {
    for (const double beta_2 : {0.5, 0.6, 1.0}) {
        const double limit = stable_step(beta_2, w0);
        const auto structure = model::mass_on_belt(belt);
        EXPECT_EQ(run(structure, velocity, 0.1, {}, {0.999 * limit, beta_2}).outcome.reason, Reason::completed);
        const Motion refused = run(structure, velocity, 0.1, {}, {1.001 * limit, beta_2});
        EXPECT_EQ(refused.outcome.reason, Reason::step_limit);
        EXPECT_EQ(refused.outcome.time, 0.0);
    }
}

// x = D' + V t until k x = mu_s F, that is at x = 0.32 mm after 3.2 ms; then it slips
TEST(Beta2, SticksUntilForceReachesStaticLimit) {
    const Motion motion = run(model::mass_on_belt(belt), velocity, 0.005, {Initial::stuck, 0.0}, {1e-6, 0.5},
                              {record::KeepHistory::yes, {}});
    ASSERT_GE(motion.record.histories.front().size(), 2U);
    EXPECT_EQ(motion.record.histories.front()[0].state, ContactState::stick);
    EXPECT_EQ(motion.record.histories.front()[1].state, ContactState::slip);
    EXPECT_NEAR(motion.record.histories.front()[0].to, 3.2e-3, 2e-6);  // changes are known to one step
}

TEST(Beta2, GivesTheTraceItsAskedTimesAndClosedFormWhileSticking) {
    const Motion motion = run(model::mass_on_belt(belt), velocity, 0.004, {Initial::stuck, 0.0}, {1e-6, 0.5},
                              {record::KeepHistory::no, {0.001, 0.003, 0.0005}});
    const record::Trace& trace = motion.record.trace;
    ASSERT_EQ(trace.time.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        const double time = 0.001 + 0.0005 * static_cast<double>(k);
        EXPECT_NEAR(trace.time[k], time, 1e-15);
        EXPECT_NEAR(trace.displacement[0][k], velocity * time, 1e-15);
        EXPECT_NEAR(trace.velocity[0][k], velocity, 1e-10);
        EXPECT_NEAR(trace.contacts.front().friction_force[k], w0 * w0 * velocity * time,
                    1e-4);  // 100 N, cancelled by 1 / h^2
        EXPECT_NEAR(trace.contacts.front().normal_force[k], 100.0, 1e-4);
        EXPECT_EQ(trace.surface_velocity[k], velocity);
        EXPECT_EQ(trace.contacts.front().state[k], ContactState::stick);
    }
    EXPECT_EQ(trace.displacement.size(), 2U);
    EXPECT_EQ(trace.contacts.front().gap.size(), 5U);
}

TEST(Beta2, WithoutATraceKeepsNone) {
    const Motion motion = run(model::mass_on_belt(belt), velocity, 0.004, {}, {1e-6, 0.5});
    EXPECT_TRUE(motion.record.trace.time.empty());
    EXPECT_TRUE(motion.record.histories.front().empty());
}

TEST(Beta2, RefusesAPainleveConfiguration) {
    auto structure = model::mass_on_belt(belt);
    structure.mass(0, 1) = structure.mass(1, 0) = 0.5;
    structure.contacts[0].friction = model::Coulomb{2.5, 2.1};  // above 1 / 0.5
    const auto thrown = support::thrown_by([&] { run(structure, velocity, 0.01, {}, {1e-6, 0.5}); });
    EXPECT_EQ(thrown.kind, ErrorKind::numerical);
    EXPECT_TRUE(thrown.says("Painleve")) << thrown.message;
}

}  // namespace
}  // namespace stridor::integration
