#include "stridor/verification/belt.hpp"

#include "stridor/analysis/rates.hpp"
#include "stridor/verification/runs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

}  // namespace stridor::verification
