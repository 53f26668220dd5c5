// What is known of silence without computing it is what computing it gives.

#include "stridor/integration/exact/silence.hpp"

#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::integration {
namespace {

using parameters::Case;

Case sliding_case() {
    Case c = parameters::paper_case(parameters::PaperCase::quiet);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = -0.1;
    c.run.duration = 0.8;
    return c;
}

Motion computed_to_the_end(Case c) {
    c.run.early_ending = parameters::EarlyEnding::never;
    return simulate(c);
}

TEST(Silence, LeavesTheVibrationOfTheWindowAsItIs) {
    for (const double window : {0.8, 0.7, 0.600001}) {
        Case c = sliding_case();
        c.run.window = window;
        const Motion early = simulate(c);
        const Motion late = computed_to_the_end(c);
        ASSERT_EQ(early.outcome.reason, Reason::settled);
        ASSERT_EQ(late.outcome.reason, Reason::completed);
        ASSERT_EQ(early.record.phases.size(), 1U);
        const auto& known = early.record.phases[0].vibration;
        const auto& computed = late.record.phases[0].vibration;
        ASSERT_EQ(known.size(), computed.size());
        double most = 0.0;
        for (const record::Vibration& each : computed)
            most = std::max(most, each.square_time);
        ASSERT_GT(most, 0.0);
        for (std::size_t dof = 0; dof < known.size(); ++dof) {
            // both round: some 1e5 steps of 1e-16 each, and P of A'P + P A = -Q as well as its condition lets it
            EXPECT_NEAR(known[dof].square_time, computed[dof].square_time, 1e-9 * most) << dof << ", " << window;
            // a peak is that of samples, a step apart, and these stand elsewhere
            EXPECT_NEAR(known[dof].peak_square, computed[dof].peak_square, 0.01 * computed[dof].peak_square) << dof;
        }
    }
}

TEST(Silence, IsNoBolderThanTheMotionIs) {
    const Case c = sliding_case();
    const Motion early = simulate(c);
    ASSERT_TRUE(early.silence);
    EXPECT_GT(early.silence->time, 0.0);
    EXPECT_LT(early.silence->time, c.run.duration);

    Case traced = c;
    traced.run.early_ending = parameters::EarlyEnding::never;
    record::Request request;
    request.trace = {early.silence->time, c.run.duration, 1e-4};
    const record::ContactTrace trace = simulate(traced, request).record.trace.contacts.front();
    ASSERT_GT(trace.normal_force.size(), 100U);
    for (std::size_t k = 0; k < trace.normal_force.size(); ++k) {
        EXPECT_GE(trace.normal_force[k], early.silence->normal_force);
        EXPECT_EQ(trace.state[k], model::ContactState::slip);
    }
}

}  // namespace
}  // namespace stridor::integration
