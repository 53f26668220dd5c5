// The slip of a step against bisection: of all that are lawful the fastest, found by a scan.

#include "stridor/integration/rules/fastest_slip.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::integration {
namespace {

using model::FrictionLaw;
using model::Slip;
using support::signed_fraction;
using support::whole_between;

double decades(double from, double to) {
    return from * std::pow(to / from, 0.5 + 0.5 * *signed_fraction());
}

FrictionLaw any_law() {
    const double limit = decades(0.05, 3.0);
    model::Stribeck curve{limit, limit * (0.5 + 0.5 * *signed_fraction()), decades(1e-4, 10.0),
                          *whole_between(0, 1) == 0 ? 1.0 : decades(1.0, 20.0),
                          *whole_between(0, 1) == 0 ? 0.0 : decades(1e-3, 10.0)};
    switch (*whole_between(0, 4)) {
        case 0:
            return curve;
        case 1:
            curve.kind = parameters::FrictionKind::stribeck_rational;
            return curve;
        case 2:
            return model::Linear{limit, curve.kinetic_coefficient, decades(1e-3, 100.0)};
        case 3:
            return model::Regularised{limit, curve.velocity};
        default:
            return model::Regularised{limit, curve.velocity, parameters::FrictionKind::arctan};
    }
}

// what a step knows: w = free + sign reach T/N
struct OneStep {
    FrictionLaw law;
    Slip way = Slip::forward;
    double free = 0.0;   // [m/s] without friction
    double reach = 0.0;  // [m/s]
    double velocity(double ratio) const { return free + reach * ratio; }
    double psi(double mu) const {
        return mu - std::abs(slip_ratio(law, way, velocity(way == Slip::forward ? -mu : mu)));
    }
};

OneStep any_step() {
    OneStep step{any_law(), *whole_between(0, 1) == 0 ? Slip::forward : Slip::backward, decades(1e-4, 10.0),
                 decades(1e-6, 1e2)};
    if (step.way == Slip::backward) step.free = -step.free;
    return step;
}

double found_in(const OneStep& step) {
    const auto ratio =
        ratio_of_fastest_slip(step.law, step.way, step.reach, [&](double tried) { return step.velocity(tried); });
    return ratio ? std::abs(*ratio) : -1.0;
}

RC_GTEST_PROP(FastestSlip, IsLawful, ()) {
    const OneStep step = any_step();
    const double mu = found_in(step);
    RC_ASSERT(mu >= 0.0);
    // psi changes by 1 + reach times the slope, and mu is rounded
    const model::SlopeRange range = slope_range(step.law);
    const double steepest = 1.0 + step.reach * (range.most - range.least);
    RC_ASSERT(std::abs(step.psi(mu)) <= 2e-15 * std::max(1.0, mu) * steepest);
}

RC_GTEST_PROP(FastestSlip, IsWhereBisectionFindsIt, ()) {
    const OneStep step = any_step();
    const double mu = found_in(step);
    constexpr int points = 4000;
    const double most = 2.0 * std::max(mu, std::abs(slip_ratio(step.law, step.way)));
    double low = 0.0, high = most;
    for (int k = 1; k <= points; ++k) {
        const double tried = most * k / points;
        if (step.psi(tried) < 0.0) continue;
        low = most * (k - 1) / points;
        high = tried;
        break;
    }
    const double wide = high - low;
    for (int turn = 0; turn < 80; ++turn) {
        const double middle = 0.5 * (low + high);
        (step.psi(middle) < 0.0 ? low : high) = middle;
    }
    // two roots between two points of the scan are not seen: then the one found is a faster slip
    if (mu < low - wide) {
        RC_ASSERT(std::abs(step.psi(mu)) <= 1e-12);
    } else {
        RC_ASSERT(mu <= high + 1e-12 * std::max(1.0, mu) + wide);
        if (is_gentle(slope_range(step.law), step.reach)) RC_ASSERT(std::abs(mu - high) <= 1e-14 * std::max(1.0, mu));
    }
}

// friction that falls within 10 mm/s while the step reaches 1 m/s: the slip may go on, or have ended
TEST(FastestSlip, OfSeveralIsTheOneWithTheLeastFriction) {
    const OneStep step{model::Stribeck{0.8, 0.2, 1e-2, 1.0, 0.0}, Slip::forward, 0.5, 1.0};
    // with 0.8 it would have turned round; with 0.2 and a rest of exp(-30) it goes on with 0.3 m/s
    EXPECT_NEAR(step.psi(0.8), 0.0, 1e-15);
    EXPECT_NEAR(found_in(step), 0.2, 1e-9);
}

}  // namespace
}  // namespace stridor::integration
