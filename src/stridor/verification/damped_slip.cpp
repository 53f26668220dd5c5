#include "stridor/verification/damped_slip.hpp"

#include "stridor/integration/beta_2/beta_2.hpp"
#include "stridor/verification/runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace stridor::verification {

namespace {

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

}  // namespace

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

}  // namespace stridor::verification
