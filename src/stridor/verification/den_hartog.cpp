#include "stridor/verification/den_hartog.hpp"

#include "stridor/verification/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor::verification {

namespace {

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
