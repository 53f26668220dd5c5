// Den Hartog's oscillator by beta_2 (verification/single_mass.hpp has the closed form).

#include "stridor/verification/single_mass.hpp"
#include "support/belt_run.hpp"
#include "support/effort.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor {
namespace {

// largest |z| over the last ten periods of the belt
double amplitude(double g, double r) {
    support::BeltRun run;
    run.belt = {1.0, 1.0, 0.0, 1.0, {r, r}};
    run.drive.amplitude = 1.0 / (g * g - 1.0);
    run.drive.frequency = g / (2.0 * std::numbers::pi);
    run.duration = support::effort(1000.0, 500.0);
    run.settings = {support::effort(2e-4, 5e-4), 0.5};
    run.request.trace = {run.duration - 20.0 * std::numbers::pi / g, run.duration, 1e-2};
    const record::Trace trace = integrate(run).record.trace;
    double largest = 0.0;
    for (std::size_t k = 0; k < trace.time.size(); ++k) {
        const double belt = run.drive.amplitude * std::sin(g * trace.time[k]);
        largest = std::max(largest, std::abs(trace.displacement[0][k] - belt));
    }
    return largest;
}

TEST(DenHartog, HasThePublishedAmplitudes) {
    // samples miss the peak by g^2 0.01^2 / 8; captures of the slip velocity r h at each reversal act over one step
    for (const verification::DenHartog& each : verification::den_hartog_motions)
        EXPECT_NEAR(amplitude(each.g, each.r), each.amplitude, 1e-3) << "g " << each.g << ", r " << each.r;
}

}  // namespace
}  // namespace stridor
