// A run ends soon after it is told to, wherever its time goes; and by itself where numbers are none.

#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/record/schedule.hpp"
#include "support/patience.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::integration {
namespace {

using parameters::Case;

Case constant_squeal(double duration) {
    Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = 0.1;
    c.run.duration = c.run.window = duration;
    return c;
}

// the engine itself: what a case must be to get here is checked before it
Motion run(const Case& c, const record::Request& request, std::stop_token stop) {
    return integrate_exact(model::rubbing_system(c), c.drive, {c.run.initial, c.run.perturbation}, {c.run.early_ending},
                           record::Recorder(record::schedule(c), request, model::rubbing_system_dofs), std::move(stop));
}

// it took 2^27 intervals a step, and no stop request was seen
TEST(Cancelling, IsNotNeededWhereCoefficientsAreNoNumbers) {
    for (const double large : {1e308, 1e200, 1e160, std::numeric_limits<double>::infinity()}) {
        for (double parameters::Plate::*field : {&parameters::Plate::damping, &parameters::Plate::stiffness}) {
            Case c = constant_squeal(1.0);
            c.plate.*field = large;
            support::Patience patience(0.5);
            const Motion motion = run(c, {}, patience.token());
            EXPECT_FALSE(has_result(motion.outcome)) << large;
            EXPECT_FALSE(patience.is_worn_out()) << large;
        }
    }
}

// a cycle of 19 ms in a thousand million seconds: it was repeated to the end
TEST(Cancelling, EndsTheRepetitionOfALimitCycle) {
    support::Patience patience(0.2);
    const Motion motion = run(constant_squeal(1e9), {}, patience.token());
    EXPECT_EQ(motion.outcome.reason, Reason::cancelled);
    EXPECT_FALSE(patience.is_worn_out());
}

// a heavy joint on soft springs takes steps of minutes, with a thousand million samples in each
TEST(Cancelling, EndsTheSamplesOfOneStep) {
    Case c = constant_squeal(1000.0);
    c.joint() = {1e6, 1.0, 1.0, 0.0, 0.0, 70.0};
    c.plate = {1e6, 1.0, 0.0};
    std::stop_source stop;
    std::size_t samples = 0;
    record::Request request;
    request.trace = {0.0, c.run.duration, 1e-6, [&](const record::Trace& trace) {
                         samples += trace.time.size();
                         stop.request_stop();
                     }};
    EXPECT_EQ(run(c, request, stop.get_token()).outcome.reason, Reason::cancelled);
    EXPECT_LE(samples, 4 * record::trace_block);
}

}  // namespace
}  // namespace stridor::integration
