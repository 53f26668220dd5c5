#include "stridor/model/laws/friction.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace stridor::model {

namespace {

// (|w|/v_s)^delta
double speed_power(const Stribeck& law, double speed) {
    return base::power(speed / law.velocity, law.exponent);
}

// [s/m] its slope over |w|
double power_slope(const Stribeck& law, double speed) {
    return law.exponent * base::power(speed / law.velocity, law.exponent - 1.0) / law.velocity;
}

// [s/m] between which the slope of a curve stays: of a cubic piece it is a parabola, largest at an end or its top
SlopeRange range_of(const MeasuredCurve& curve) {
    SlopeRange range;
    const auto widen = [&](double slope) {
        range.least = std::min(range.least, slope);
        range.most = std::max(range.most, slope);
    };
    for (std::size_t k = 0; k + 1 < curve.places.size(); ++k) {
        const double secant = (curve.values[k + 1] - curve.values[k]) / (curve.places[k + 1] - curve.places[k]);
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
    const double x = speed_power(*this, speed);
    const double lost = is_exponential() ? 1.0 - base::exponential(-x) : x / (1.0 + x);
    return static_coefficient - fall() * lost + viscous * speed;
}

double Stribeck::resistance_slope(Slip, double speed) const {
    const double x = speed_power(*this, speed), slope = power_slope(*this, speed);
    if (is_exponential()) return viscous - fall() * slope * base::exponential(-x);
    return viscous - fall() * (slope / (1.0 + x)) / (1.0 + x);
}

double Measured::resistance(Slip, double speed) const {
    const MeasuredCurve& c = *curve;
    // both ends hold
    if (speed >= c.places.back()) return std::min(c.values.back(), static_coefficient);
    if (speed <= c.places.front()) return std::min(c.values.front(), static_coefficient);
    return std::clamp(value_behind_row(c, row_before(c, speed), speed), 0.0, static_coefficient);
}

double Measured::resistance_slope(Slip, double speed) const {
    const MeasuredCurve& c = *curve;
    if (speed >= c.places.back() || speed < c.places.front()) return 0.0;
    return slope_behind_row(c, row_before(c, speed), speed);
}

double Regularised::resistance(Slip, double speed) const {
    if (kind == parameters::FrictionKind::arctan)
        return coefficient * (2.0 * std::numbers::inv_pi) * base::arctangent(speed / velocity);
    // 1 - tanh x = 2/(exp(2 x) + 1)
    const double fading = base::exponential(-2.0 * speed / velocity);
    return coefficient * ((1.0 - fading) / (1.0 + fading));
}

double Regularised::resistance_slope(Slip, double speed) const {
    if (kind == parameters::FrictionKind::arctan) {
        const double x = speed / velocity;
        return coefficient * (2.0 * std::numbers::inv_pi) / velocity / (1.0 + x * x);
    }
    const double fading = base::exponential(-2.0 * speed / velocity);
    return coefficient / velocity * (4.0 * fading / ((1.0 + fading) * (1.0 + fading)));
}

bool holds(const FrictionLaw& law, double normal_force, double friction_force) {
    return normal_force >= 0.0 &&
           std::abs(friction_force) <= stick_limit(law, slip_against(friction_force)) * normal_force;
}

namespace {

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
        case parameters::FrictionKind::stribeck_rational:
            return Stribeck{contact.static_friction,   contact.kinetic_friction, contact.stribeck_velocity,
                            contact.stribeck_exponent, contact.viscous_friction, contact.friction};
        case parameters::FrictionKind::table:
            return measured(contact);
        case parameters::FrictionKind::tanh:
        case parameters::FrictionKind::arctan:
            return Regularised{contact.kinetic_friction, contact.regularisation, contact.friction};
        case parameters::FrictionKind::lugre:
            return LuGre{{contact.static_friction, contact.kinetic_friction, contact.stribeck_velocity,
                          contact.stribeck_exponent, contact.viscous_friction},
                         contact.bristle_stiffness,
                         contact.bristle_damping};
        case parameters::FrictionKind::dieterich:
        case parameters::FrictionKind::ruina:
            return RateAndState{contact.friction,         contact.kinetic_friction, contact.direct_effect,
                                contact.evolution_effect, contact.slip_length,      contact.reference_velocity};
    }
    return {};
}

}  // namespace stridor::model
