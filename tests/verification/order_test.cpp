// Order and numerical damping of the beta_2 scheme where nothing but the scheme acts: pure slip, no change of state.

#include "stridor/integration/simulate.hpp"
#include "stridor/verification/single_mass.hpp"
#include "support/belt_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

namespace stridor {
namespace {

constexpr double w0 = 500.0;  // [rad/s]

// steady sliding on a fast belt, pushed by 0.1 m/s
support::BeltRun sliding(double damping_ratio, double h, double beta_2) {
    support::BeltRun run;
    run.belt = {1.0, w0 * w0, 2.0 * damping_ratio * w0, 100.0, {0.8, 0.3}};
    run.drive = support::constant_drive(100.0);
    run.start = {parameters::Initial::sliding, 0.1};
    run.settings = {h, beta_2};
    return run;
}

constexpr double slid = 100.0 * 0.3 / (w0 * w0);  // [m] x_e = mu_d F / k

double belt_error(double h, double beta_2) {
    constexpr double damping_ratio = 0.05;
    constexpr double end = 0.02;  // [s] ten radians
    support::BeltRun run = sliding(damping_ratio, h, beta_2);
    run.duration = end + 2.0 * h;
    run.request.trace = {end, end, h};
    const record::Trace trace = integrate(run).record.trace;
    const double damped = w0 * std::sqrt(1.0 - damping_ratio * damping_ratio);
    const verification::DampedSlip exact{slid, 0.1, damping_ratio * w0, damped};
    return std::abs(trace.displacement[0].at(0) - displacement(exact, end));
}

// errors at h and h/2, in powers of two
TEST(ObservedOrder, OnTheBeltIsTwoForTheCentralDifference) {
    for (const double h : {4e-5, 2e-5, 1e-5})
        EXPECT_NEAR(std::log2(belt_error(h, 0.5) / belt_error(0.5 * h, 0.5)), 2.0, 0.1) << h;
}

TEST(ObservedOrder, OnTheBeltIsOneAboveIt) {
    for (const double h : {4e-5, 2e-5, 1e-5})
        EXPECT_NEAR(std::log2(belt_error(h, 0.8) / belt_error(0.5 * h, 0.8)), 1.0, 0.1) << h;
}

// plate displacement of the paper's system, sliding without flutter, at 5 ms
double plate_displacement(double h, double beta_2) {
    parameters::Case c;
    c.contact().kinetic_friction = 0.3;
    c.drive = support::constant_drive(10.0);
    c.run.initial = parameters::Initial::sliding;
    c.run.perturbation = 0.01;
    c.run.engine = parameters::Engine::beta_2;
    c.run.step = h;
    c.run.beta_2 = beta_2;
    constexpr double end = 5e-3;
    c.run.duration = c.run.window = end + 2.0 * h;
    const auto motion = integration::simulate(c, {record::KeepHistory::yes, {end, end, h}});
    EXPECT_EQ(motion.record.histories.front().size(), 1U) << "it does not slip throughout";
    return motion.record.trace.displacement[2].at(0);
}

// Richardson: successive differences fall by 2^order
double observed_order(double h, double beta_2) {
    const double coarse = plate_displacement(h, beta_2);
    const double middle = plate_displacement(0.5 * h, beta_2);
    const double fine = plate_displacement(0.25 * h, beta_2);
    return std::log2(std::abs((coarse - middle) / (middle - fine)));
}

TEST(ObservedOrder, OfTheRubbingSystemIsTwoForTheCentralDifference) {
    EXPECT_NEAR(observed_order(4e-6, 0.5), 2.0, 0.1);
    EXPECT_NEAR(observed_order(2e-6, 0.5), 2.0, 0.1);
}

TEST(ObservedOrder, OfTheRubbingSystemIsOneAboveIt) {
    EXPECT_NEAR(observed_order(4e-6, 0.8), 1.0, 0.1);
    EXPECT_NEAR(observed_order(2e-6, 0.8), 1.0, 0.1);
}

// An undamped mode obeys y(n+1) = tau y(n) - rho^2 y(n-1), so that D(n) = y(n)^2 - y(n-1) y(n+1) falls by rho^2 each
// step, exactly, where rho = sqrt(1 - (beta_2 - 1/2) (w0 h)^2) is the scheme's spectral radius.
double spectral_radius(double h, double beta_2) {
    constexpr int steps = 200;
    support::BeltRun run = sliding(0.0, h, beta_2);
    run.duration = 2.0 * steps * h;
    run.request.trace = {0.0, run.duration, h};
    const record::Trace trace = integrate(run).record.trace;
    const auto decrement = [&](std::size_t n) {
        const auto y = [&](std::size_t k) { return trace.displacement[0].at(k) - slid; };
        return y(n) * y(n) - y(n - 1) * y(n + 1);
    };
    return std::pow(decrement(steps) / decrement(1), 0.5 / (steps - 1));
}

TEST(NumericalDamping, HasTheSpectralRadiusOfTheScheme) {
    for (const double h : {4e-4, 1e-4})
        for (const double beta_2 : {0.5, 0.6, 0.8, 1.0}) {
            const double exact = std::sqrt(1.0 - (beta_2 - 0.5) * w0 * w0 * h * h);
            // D cancels to (w0 h)^2 of its terms, each rounded to 1e-16; the root takes 1/400 of that
            EXPECT_NEAR(spectral_radius(h, beta_2), exact, 1e-14 / (w0 * w0 * h * h)) << h << " " << beta_2;
        }
}

}  // namespace
}  // namespace stridor
