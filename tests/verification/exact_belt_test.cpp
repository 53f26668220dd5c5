// The exact engine against closed forms of one mass: stick-slip, the damped vibration, Den Hartog's oscillator.

#include "stridor/integration/exact/exact.hpp"
#include "stridor/model/built/mass_on_belt.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/verification/single_mass.hpp"
#include "support/belt_run.hpp"
#include "support/periods.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor {
namespace {

using model::ContactState;

integration::Motion exactly(const support::BeltRun& run) {
    parameters::Case c;
    c.drive = support::constant_drive(1.0);  // one phase, whatever really drives the belt
    c.run.duration = c.run.window = run.duration;
    return integration::integrate_exact(model::mass_on_belt(run.belt), run.drive, run.start, {},
                                        record::Recorder(record::schedule(c), run.request, 2));
}

TEST(ExactBelt, SticksAndSlipsForTheTimesOfTheClosedForm) {
    constexpr double w0 = 500.0, distance = 2e-4;
    for (const double lambda : {0.01, 0.5, 1.0, 2.0, 5.0, 100.0}) {
        support::BeltRun run;
        run.belt = {1.0, w0 * w0, 0.0, 100.0, {0.8, 0.3}};
        run.drive = support::constant_drive(w0 * distance / lambda);
        run.start = {parameters::Initial::stuck, 0.0};
        run.request = {record::KeepHistory::yes, {}};
        const double stick = verification::belt_stick_time(lambda, w0), slip = verification::belt_slip_time(lambda, w0);
        run.duration = 20.5 * (stick + slip);
        const support::Periods periods =
            support::whole_periods(exactly(run).record.histories.front(), ContactState::stick, 1e-9);
        ASSERT_GE(periods.count, 18);
        // rounding of some hundred steps; a stick of 1 % of the period is known as well as the period is
        EXPECT_NEAR(periods.period, stick + slip, 1e-12 * (stick + slip)) << lambda;
        EXPECT_NEAR(periods.shares[model::index_of(ContactState::stick)], stick / (stick + slip), 1e-12) << lambda;
    }
}

// x = A exp(-d t) cos(w t) about the sliding equilibrium, on a belt too fast to be reached: 80 periods to rounding
TEST(ExactBelt, VibratesAsTheDampedOscillator) {
    constexpr double m = 0.7, k = 3e5, c = 4.0, F = 50.0, mu = 0.3, push = 0.8;
    support::BeltRun run;
    run.belt = {m, k, c, F, {0.5, mu}};
    run.drive = support::constant_drive(10.0);
    run.start = {parameters::Initial::sliding, push};
    run.duration = 0.8;
    run.request.trace = {0.0, 0.8, 1e-3};
    const record::Trace trace = exactly(run).record.trace;
    const double decay = c / (2.0 * m), rate = std::sqrt(k / m - decay * decay);
    const verification::DampedSlip exact{mu * F / k, push, decay, rate};
    ASSERT_EQ(trace.time.size(), 801U);
    for (std::size_t i = 0; i < trace.time.size(); ++i) {
        const double t = trace.time[i];
        ASSERT_NEAR(trace.displacement[0][i], displacement(exact, t), 1e-13 * push / rate) << t;
    }
}

// largest |x1 - x2| of the last periods: it lies where the slip reverses, z' = 0, which is where states begin
double den_hartog_amplitude(double g, double r) {
    support::BeltRun run;
    run.belt = {1.0, 1.0, 0.0, 1.0, {r, r}};
    run.drive.amplitude = 1.0 / (g * g - 1.0);
    run.drive.frequency = g / (2.0 * std::numbers::pi);
    run.duration = 3000.0;
    run.request.trace = {2990.0, 3000.0, 1e-3};
    const record::Trace trace = exactly(run).record.trace;
    double largest = 0.0;
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        const double belt = run.drive.amplitude * std::sin(g * trace.time[k]);
        largest = std::max(largest, std::abs(trace.displacement[0][k] - belt));
    }
    return largest;
}

// samples 1e-3 apart miss a peak by g^2 1e-6 / 8 = 5e-7; the printed digits are good to 5e-7
TEST(ExactDenHartog, HasThePublishedAmplitudes) {
    for (const verification::DenHartog& each : verification::den_hartog_motions)
        EXPECT_NEAR(den_hartog_amplitude(each.g, each.r), each.amplitude, 1e-6) << each.g << ' ' << each.r;
}

}  // namespace
}  // namespace stridor
