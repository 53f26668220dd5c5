#include "stridor/verification/single_mass.hpp"

#include "stridor/analysis/rates.hpp"
#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/verification/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridor::verification {

namespace {

double computed_stick_fraction(double lambda, parameters::Engine engine) {
    const double w0 = 100.0;  // [rad/s] about 1e5 steps of 1e-6 s a cycle
    const model::Belt belt{1.0, w0 * w0, 0.0, 10.0, {0.6, 0.2}};
    const double excess =
        (belt.friction.static_coefficient - belt.friction.kinetic_coefficient) * belt.preload / belt.stiffness;
    const double velocity = w0 * excess / lambda;
    const double cycle = belt_period(lambda, w0);
    const integration::Motion motion =
        run_belt(belt, constant_drive(velocity), engine, whole_run(2.0 * cycle, 10.0 * cycle));
    return analysis::rates(motion.record.phases.at(0).contacts.at(0).time).stick;
}

// of beta_2 at one instant
double slip_error(double step, double beta_2) {
    const double w0 = 100.0, zeta = 0.05, velocity = 10.0, time = 0.1, kick = 1.0;
    const model::Belt belt{1.0, w0 * w0, 2.0 * zeta * w0, 10.0, {0.3, 0.3}};
    const integration::Motion motion = integration::integrate_beta_2(
        model::mass_on_belt(belt), constant_drive(velocity), {parameters::Initial::sliding, kick}, {step, beta_2},
        whole_run(0.0, time + step, {time, time, step}));
    const DampedSlip slip{belt.friction.kinetic_coefficient * belt.preload / belt.stiffness, kick, zeta * w0,
                          w0 * std::sqrt(1.0 - zeta * zeta)};
    return std::abs(motion.record.trace.displacement[0].at(0) - displacement(slip, time));
}

constexpr double pi = std::numbers::pi;

double computed_amplitude(double g, double r, parameters::Engine engine) {
    const double w0 = 100.0;  // [rad/s] time runs w0 times faster than in the formula
    const double amplitude = 1.0 / (g * g - 1.0);
    const model::Belt belt{1.0, w0 * w0, 0.0, w0 * w0 * 10.0, {r / 10.0, r / 10.0}};
    parameters::Drive drive;
    drive.kind = parameters::DriveKind::sinusoidal;
    drive.amplitude = amplitude;
    drive.frequency = g * w0 / (2.0 * pi);
    const double period = 2.0 * pi / (g * w0);
    const double end = 200.0 * period;
    const integration::Motion motion =
        run_belt(belt, drive, engine, whole_run(0.0, end, {end - 2.0 * period, end, 1e-6}));
    double largest = 0.0;
    const record::Trace& trace = motion.record.trace;
    for (std::size_t k = 0; k < trace.time.size(); ++k)
        largest = std::max(largest, std::abs(trace.displacement[0][k] - amplitude * std::sin(g * w0 * trace.time[k])));
    return largest;
}

}  // namespace

double belt_stick_time(double lambda, double w0) {
    return 2.0 * lambda / w0;
}

double belt_slip_time(double lambda, double w0) {
    return 2.0 * (std::numbers::pi - std::atan(lambda)) / w0;
}

double belt_period(double lambda, double w0) {
    return (2.0 * lambda + 2.0 * (std::numbers::pi - std::atan(lambda))) / w0;
}

double belt_stick_fraction(double lambda) {
    return lambda / (lambda + std::numbers::pi - std::atan(lambda));
}

std::vector<Check> belt_checks() {
    std::vector<Check> checks;
    for (const double lambda : {0.5, 1.0, 2.0, 5.0}) {
        const double exact = belt_stick_fraction(lambda);
        const std::string name = fmt::format("belt stick fraction, lambda = {:g}, ", lambda);
        checks.push_back({name + "exact", exact, computed_stick_fraction(lambda, parameters::Engine::exact), 1e-12});
        checks.push_back({name + "beta_2", exact, computed_stick_fraction(lambda, parameters::Engine::beta_2), 1e-3});
    }
    return checks;
}

double displacement(const DampedSlip& slip, double time) {
    return slip.equilibrium + slip.push / slip.rate * std::exp(-slip.decay * time) * std::sin(slip.rate * time);
}

std::vector<Check> order_checks() {
    std::vector<Check> checks;
    for (const auto& [beta_2, order] : {std::pair{0.5, 2.0}, std::pair{0.8, 1.0}})
        for (const double step : {4e-4, 2e-4, 1e-4}) {
            const double observed = std::log2(slip_error(step, beta_2) / slip_error(0.5 * step, beta_2));
            checks.push_back({fmt::format("order at beta_2 = {:g}, h = {:g} to {:g} s", beta_2, step, 0.5 * step),
                              order, observed, 0.1});
        }
    return checks;
}

double den_hartog_amplitude(double g, double r) {
    const double v = 1.0 / (1.0 - g * g);
    const double u = std::sin(pi / g) / (g * (1.0 + std::cos(pi / g)));
    return std::sqrt(v * v - r * r * u * u);
}

std::vector<Check> den_hartog_checks() {
    std::vector<Check> checks;
    for (const DenHartog& each : den_hartog_motions) {
        const std::string name = fmt::format("Den Hartog amplitude, g = {:g}, r = {:g}, ", each.g, each.r);
        checks.push_back(
            {name + "exact", each.amplitude, computed_amplitude(each.g, each.r, parameters::Engine::exact), 1e-6});
        checks.push_back(
            {name + "beta_2", each.amplitude, computed_amplitude(each.g, each.r, parameters::Engine::beta_2), 1e-3});
    }
    return checks;
}

}  // namespace stridor::verification
