#include "stridor/model/friction.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridor::model {

namespace {

// (|w|/v_s)^delta
double speed_power(const StribeckCurve& curve, double speed) {
    return base::power(speed / curve.velocity, curve.exponent);
}

// [s/m] its slope over |w|
double power_slope(const StribeckCurve& curve, double speed) {
    return curve.exponent * base::power(speed / curve.velocity, curve.exponent - 1.0) / curve.velocity;
}

double falling(const StribeckCurve& curve) {
    return curve.static_coefficient - curve.kinetic_coefficient;
}

// [s/m] of the cubic at the first or last row: that of the parabola through three rows, held to the monotone ones
double end_slope(double near_width, double far_width, double near, double far) {
    const double slope = ((2.0 * near_width + far_width) * near - near_width * far) / (near_width + far_width);
    if (slope * near <= 0.0) return 0.0;
    if (near * far <= 0.0 && std::abs(slope) > 3.0 * std::abs(near)) return 3.0 * near;
    return slope;
}

// the row before a speed within the table
std::size_t row_before(const MeasuredCurve& curve, double speed) {
    const auto next = std::upper_bound(curve.speeds.begin(), curve.speeds.end(), speed);
    const auto row = static_cast<std::size_t>(next - curve.speeds.begin());
    return std::clamp<std::size_t>(row, 1, curve.speeds.size() - 1) - 1;
}

// [s/m] between which the slope of a curve stays: of a cubic piece it is a parabola, largest at an end or its top
SlopeRange range_of(const MeasuredCurve& curve) {
    SlopeRange range;
    const auto widen = [&](double slope) {
        range.least = std::min(range.least, slope);
        range.most = std::max(range.most, slope);
    };
    for (std::size_t k = 0; k + 1 < curve.speeds.size(); ++k) {
        const double secant =
            (curve.coefficients[k + 1] - curve.coefficients[k]) / (curve.speeds[k + 1] - curve.speeds[k]);
        widen(secant);
        if (curve.slopes.empty()) continue;
        const double from = curve.slopes[k], to = curve.slopes[k + 1];
        const double bend = 3.0 * (from + to - 2.0 * secant), tilt = 2.0 * (3.0 * secant - 2.0 * from - to);
        widen(from);
        widen(to);
        const double top = bend != 0.0 ? -0.5 * tilt / bend : 0.0;
        if (top > 0.0 && top < 1.0) widen(from + top * (tilt + top * bend));
    }
    return range;
}

}  // namespace

double Stribeck::resistance(Slip, double speed) const {
    const double lost = 1.0 - base::exponential(-speed_power(curve, speed));
    return curve.static_coefficient - falling(curve) * lost + curve.viscous * speed;
}

double Stribeck::resistance_slope(Slip, double speed) const {
    const double left = base::exponential(-speed_power(curve, speed));
    return curve.viscous - falling(curve) * power_slope(curve, speed) * left;
}

double RationalStribeck::resistance(Slip, double speed) const {
    const double power = speed_power(curve, speed);
    return curve.static_coefficient - falling(curve) * (power / (1.0 + power)) + curve.viscous * speed;
}

double RationalStribeck::resistance_slope(Slip, double speed) const {
    const double whole = 1.0 + speed_power(curve, speed);
    return curve.viscous - falling(curve) * (power_slope(curve, speed) / whole) / whole;
}

MeasuredCurve measured_curve(const std::vector<double>& speeds, const std::vector<double>& coefficients,
                             parameters::Interpolation interpolation) {
    MeasuredCurve curve{speeds, coefficients, {}};
    const std::size_t rows = speeds.size();
    if (interpolation == parameters::Interpolation::linear || rows < 3) return curve;
    std::vector<double> widths, secants;
    for (std::size_t k = 0; k + 1 < rows; ++k) {
        widths.push_back(speeds[k + 1] - speeds[k]);
        secants.push_back((coefficients[k + 1] - coefficients[k]) / widths[k]);
    }
    curve.slopes.assign(rows, 0.0);
    for (std::size_t k = 1; k + 1 < rows; ++k) {
        if (secants[k - 1] * secants[k] <= 0.0) continue;
        const double before = 2.0 * widths[k] + widths[k - 1], after = widths[k] + 2.0 * widths[k - 1];
        curve.slopes[k] = (before + after) / (before / secants[k - 1] + after / secants[k]);
    }
    curve.slopes.front() = end_slope(widths[0], widths[1], secants[0], secants[1]);
    curve.slopes.back() = end_slope(widths[rows - 2], widths[rows - 3], secants[rows - 2], secants[rows - 3]);
    return curve;
}

double Measured::resistance(Slip, double speed) const {
    const MeasuredCurve& c = *curve;
    // both ends hold
    if (speed >= c.speeds.back()) return std::min(c.coefficients.back(), static_coefficient);
    if (speed <= c.speeds.front()) return std::min(c.coefficients.front(), static_coefficient);
    const std::size_t k = row_before(c, speed);
    const double width = c.speeds[k + 1] - c.speeds[k], x = (speed - c.speeds[k]) / width;
    const double rise = c.coefficients[k + 1] - c.coefficients[k];
    double value = c.coefficients[k] + x * rise;
    if (!c.slopes.empty()) {
        const double from = width * c.slopes[k] - rise, to = width * c.slopes[k + 1] - rise;
        value += x * (1.0 - x) * (from * (1.0 - x) - to * x);
    }
    return std::clamp(value, 0.0, static_coefficient);
}

double Measured::resistance_slope(Slip, double speed) const {
    const MeasuredCurve& c = *curve;
    if (speed >= c.speeds.back() || speed < c.speeds.front()) return 0.0;
    const std::size_t k = row_before(c, speed);
    const double width = c.speeds[k + 1] - c.speeds[k], x = (speed - c.speeds[k]) / width;
    const double secant = (c.coefficients[k + 1] - c.coefficients[k]) / width;
    if (c.slopes.empty()) return secant;
    const double from = c.slopes[k] - secant, to = c.slopes[k + 1] - secant;
    return secant + from * (1.0 - x) * (1.0 - 3.0 * x) + to * x * (3.0 * x - 2.0);
}

double Tanh::resistance(Slip, double speed) const {
    // 1 - tanh x = 2/(exp(2 x) + 1)
    const double fading = base::exponential(-2.0 * speed / step.velocity);
    return step.coefficient * ((1.0 - fading) / (1.0 + fading));
}

double Tanh::resistance_slope(Slip, double speed) const {
    const double fading = base::exponential(-2.0 * speed / step.velocity);
    return step.coefficient / step.velocity * (4.0 * fading / ((1.0 + fading) * (1.0 + fading)));
}

double Arctan::resistance(Slip, double speed) const {
    return step.coefficient * (2.0 * std::numbers::inv_pi) * base::arctangent(speed / step.velocity);
}

double Arctan::resistance_slope(Slip, double speed) const {
    const double x = speed / step.velocity;
    return step.coefficient * (2.0 * std::numbers::inv_pi) / step.velocity / (1.0 + x * x);
}

bool holds(const FrictionLaw& law, double normal_force, double friction_force) {
    return normal_force >= 0.0 &&
           std::abs(friction_force) <= stick_limit(law, slip_against(friction_force)) * normal_force;
}

namespace {

StribeckCurve curve_of(const parameters::Contact& contact) {
    return {contact.static_friction, contact.kinetic_friction, contact.stribeck_velocity, contact.stribeck_exponent,
            contact.viscous_friction};
}

Measured measured(const parameters::Contact& contact) {
    const parameters::FrictionTable& table = contact.friction_table;
    // the rows of a file that is not read yet are unknown: a case without any is refused
    const double limit = contact.static_friction;
    auto curve = std::make_shared<const MeasuredCurve>(
        table.speeds.size() < 2 ? MeasuredCurve{{0.0, 1.0}, {limit, limit}, {}}
                                : measured_curve(table.speeds, table.coefficients, contact.interpolation));
    const SlopeRange range = range_of(*curve);
    return {contact.static_friction, std::move(curve), range};
}

}  // namespace

FrictionLaw friction_law(const parameters::Contact& contact) {
    switch (contact.friction) {
        case parameters::FrictionKind::coulomb:
            return Coulomb{contact.static_friction, contact.kinetic_friction};
        case parameters::FrictionKind::directional:  // a plate that goes drags the joint, which slips backward
            return Directional{{contact.static_friction_coming, contact.static_friction},
                               {contact.kinetic_friction_coming, contact.kinetic_friction}};
        case parameters::FrictionKind::linear:
            return Linear{contact.static_friction, contact.kinetic_friction, contact.friction_slope};
        case parameters::FrictionKind::stribeck:
            return Stribeck{curve_of(contact)};
        case parameters::FrictionKind::stribeck_rational:
            return RationalStribeck{curve_of(contact)};
        case parameters::FrictionKind::table:
            return measured(contact);
        case parameters::FrictionKind::tanh:
            return Tanh{{contact.kinetic_friction, contact.regularisation}};
        case parameters::FrictionKind::arctan:
            return Arctan{{contact.kinetic_friction, contact.regularisation}};
    }
    return {};
}

}  // namespace stridor::model
