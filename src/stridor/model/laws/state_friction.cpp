#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/laws/friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <variant>

/// The laws of friction with a friction state.
namespace stridor::model {

namespace {

// what bristles bear in a steady slip, and how that changes with its speed
struct BristleBearing {
    double value = 0.0;  // [1] g
    double slope = 0.0;  // [s/m]
};

BristleBearing bristle_bearing(const Stribeck& curve, double speed) {
    const double x = speed / curve.velocity, fall = curve.static_coefficient - curve.kinetic_coefficient;
    const double left = base::exponential(-base::power(x, curve.exponent));
    const double steepness = curve.exponent * base::power(x, curve.exponent - 1.0) / curve.velocity;
    return {curve.kinetic_coefficient + fall * left, -fall * steepness * left};
}

}  // namespace

double LuGre::resistance(Slip, double speed) const {
    return bristle_bearing(curve, speed).value + curve.viscous * speed;
}

double LuGre::resistance_slope(Slip, double speed) const {
    return bristle_bearing(curve, speed).slope + curve.viscous;
}

double LuGre::steady_state(double speed) const {
    return bristle_bearing(curve, speed).value;
}

double LuGre::state_rate(double speed, double state) const {
    return stiffness * (speed - speed * (state / bristle_bearing(curve, speed).value));
}

double LuGre::state_resistance(double speed, double state) const {
    return state + damping * (state_rate(speed, state) / stiffness) + curve.viscous * speed;
}

// z' changes by -|w|/g with s, and by |w| g'/g with |w|, where s = g
StateSlopes LuGre::state_slopes(double speed) const {
    const BristleBearing g = bristle_bearing(curve, speed);
    const double bend_by_state = -speed / g.value, bend_by_speed = speed * g.slope / g.value;
    StateSlopes slopes;
    slopes.rate_by_state = stiffness * bend_by_state;
    slopes.rate_by_speed = stiffness * bend_by_speed;
    slopes.resistance_by_state = 1.0 + damping * bend_by_state;
    slopes.resistance_by_speed = curve.viscous + damping * bend_by_speed;
    return slopes;
}

namespace {

constexpr double rest_share = 1e-15;  // [1] of V_0 that a speed has at rest
constexpr double ln_2 = 0.6931471805599453;
constexpr double all_logarithm = 20.0;  // [1] ln u from which arsinh u is ln(2 u): the rest is exp(-40)/4

double natural_logarithm(double x) {
    return ln_2 * base::logarithm_2(x);
}

// ln(|w|/V_0), a number at rest too
double logarithm_of(const RateAndState& law, double speed) {
    return natural_logarithm(speed / law.velocity + rest_share);
}

// of u >= 0
double arsinh(double u) {
    constexpr double small = 0.01;
    if (u > small) return natural_logarithm(u + std::sqrt(1.0 + u * u));
    const double square = u * u;
    return u * (1.0 - square * (1.0 / 6.0 - square * (3.0 / 40.0 - square * (15.0 / 336.0))));
}

// exp((mu_0 + b psi)/a)/(2 V_0) |w| by its logarithm, and arsinh of it
struct ArsinhArgument {
    double logarithm = -std::numeric_limits<double>::infinity();  // of u
    double value = 0.0;                                           // u, where it is not all logarithm
    bool is_all_logarithm() const { return logarithm > all_logarithm; }
};

ArsinhArgument argument_of(const RateAndState& law, double speed, double state) {
    if (!(speed > 0.0)) return {};
    const double exponent = (law.coefficient + law.evolution_effect * state) / law.direct_effect;
    ArsinhArgument u;
    u.logarithm = natural_logarithm(speed / law.velocity) - ln_2 + exponent;
    u.value = u.is_all_logarithm() ? 0.0 : base::exponential(u.logarithm);
    return u;
}

// u/sqrt(1 + u^2), by how much arsinh follows ln u
double followed(const ArsinhArgument& u) {
    return u.is_all_logarithm() ? 1.0 : u.value / std::sqrt(1.0 + u.value * u.value);
}

// sum of a_j b_(m-j), j = first..last
double sum_of_products(std::span<const double> a, std::span<const double> b, std::size_t first, std::size_t last,
                       std::size_t m) {
    double sum = 0.0;
    for (std::size_t j = first; j <= last; ++j)
        sum += a[j] * b[m - j];
    return sum;
}

// sum of j a_j b_(m-j), j = 1..last
double sum_of_slopes(std::span<const double> a, std::span<const double> b, std::size_t last, std::size_t m) {
    double sum = 0.0;
    for (std::size_t j = 1; j <= last; ++j)
        sum += static_cast<double>(j) * a[j] * b[m - j];
    return sum;
}

}  // namespace

double RateAndState::steady_state(double speed) const {
    return -logarithm_of(*this, speed);
}

double RateAndState::state_rate(double speed, double state) const {
    if (kind == parameters::FrictionKind::ruina) return -speed / length * (logarithm_of(*this, speed) + state);
    return (velocity * base::exponential(-state) - speed) / length;
}

double RateAndState::state_resistance(double speed, double state) const {
    const ArsinhArgument u = argument_of(*this, speed, state);
    return direct_effect * (u.is_all_logarithm() ? u.logarithm + ln_2 : arsinh(u.value));
}

double RateAndState::resistance_slope(Slip, double speed) const {
    if (!(speed > 0.0)) return 0.0;
    const double share = followed(argument_of(*this, speed, steady_state(speed)));
    return share * (direct_effect / speed - evolution_effect / (speed + rest_share * velocity));
}

SlopeRange RateAndState::slopes() const {
    const double steepest = std::max(direct_effect, evolution_effect) / (rest_share * velocity);
    return {-steepest, steepest};
}

StateSlopes RateAndState::state_slopes(double speed) const {
    const double share = followed(argument_of(*this, speed, steady_state(speed)));
    StateSlopes slopes;
    slopes.resistance_by_state = evolution_effect * share;
    slopes.resistance_by_speed = direct_effect / speed * share;
    slopes.rate_by_state = -speed / length;
    slopes.rate_by_speed = -1.0 / length;
    return slopes;
}

// x = |w|/V_0 + 1e-15, and l = ln x: x_0 m l_m = m x_m - sum j l_j x_(m-j)
namespace {

void add_logarithm(const RateAndState& law, JetTerms& terms) {
    const std::size_t m = terms.last();
    auto &x = terms.own[0], &l = terms.own[1];
    x[m] = terms.speed[m] / law.velocity + (m == 0 ? rest_share : 0.0);
    l[m] = m == 0 ? natural_logarithm(x[0]) : (x[m] - sum_of_slopes(l, x, m - 1, m) / static_cast<double>(m)) / x[0];
}

// y = exp(factor psi), from its first coefficient: m y_m = factor sum j psi_j y_(m-j)
void add_exponential(std::array<double, most_jet_coefficients>& y, double factor, const JetTerms& terms) {
    const std::size_t m = terms.last();
    if (m > 0) y[m] = factor * sum_of_slopes(terms.state, y, m, m) / static_cast<double>(m);
}

// of arsinh u, u = |w| E, E = exp((mu_0 + b psi)/a)/(2 V_0): r = sqrt(1 + u^2), r_0 m y_m = m u_m - sum j y_j r_(m-j)
double next_arsinh(const RateAndState& law, JetTerms& terms) {
    const std::size_t m = terms.last();
    auto &E = terms.own[3], &u = terms.own[4], &r = terms.own[5], &y = terms.own[6];
    if (m == 0)
        E[0] = base::exponential((law.coefficient + law.evolution_effect * terms.state[0]) / law.direct_effect) /
               (2.0 * law.velocity);
    add_exponential(E, law.evolution_effect / law.direct_effect, terms);
    u[m] = sum_of_products(terms.speed, E, 0, m, m);
    const double square = sum_of_products(u, u, 0, m, m);
    if (m == 0) {
        r[0] = std::sqrt(1.0 + square);
        return y[0] = arsinh(u[0]);
    }
    r[m] = (square - sum_of_products(r, r, 1, m - 1, m)) / (2.0 * r[0]);
    return y[m] = (u[m] - sum_of_slopes(y, r, m - 1, m) / static_cast<double>(m)) / r[0];
}

}  // namespace

double RateAndState::jet(Slip, JetTerms& terms) const {
    const std::size_t m = terms.last();
    auto &l = terms.own[1], &age = terms.own[2], &pull = terms.own[7];
    add_logarithm(*this, terms);
    if (kind == parameters::FrictionKind::ruina) {
        pull[m] = l[m] + terms.state[m];
        terms.rate[m] = -sum_of_products(terms.speed, pull, 0, m, m) / length;
    } else {
        if (m == 0) age[0] = base::exponential(-terms.state[0]);
        add_exponential(age, -1.0, terms);
        terms.rate[m] = (velocity * age[m] - terms.speed[m]) / length;
    }
    if (argument_of(*this, terms.speed[0], terms.state[0]).is_all_logarithm())
        return (m == 0 ? coefficient : 0.0) + direct_effect * l[m] + evolution_effect * terms.state[m];
    return direct_effect * next_arsinh(*this, terms);
}

double steady_friction_state(const FrictionLaw& law, double slip_velocity) {
    return std::visit(
        [&]<typename Law>(const Law& each) {
            if constexpr (HasFrictionState<Law>)
                if (slip_velocity != 0.0)
                    return state_sign(law, slip_of(slip_velocity)) * each.steady_state(std::abs(slip_velocity));
            return 0.0;
        },
        law);
}

std::optional<base::Problem> doubt_of(const FrictionLaw& law) {
    const auto* bristles = std::get_if<LuGre>(&law);
    if (bristles == nullptr) return std::nullopt;
    const Stribeck& curve = bristles->curve;
    const double least = bristles->damping * (curve.static_coefficient / curve.kinetic_coefficient - 1.0);
    if (!(curve.viscous < least)) return std::nullopt;
    return base::Problem{"friction may feed a motion for a moment",
                         "viscous_friction = " + base::shortest(curve.viscous) +
                             " s/m is less than bristle_damping (mu_s/mu_d - 1) = " + base::shortest(least) + " s/m",
                         "Raise it, or lower bristle_damping."};
}

StateSlopes state_slopes(const FrictionLaw& law, double speed) {
    return std::visit(
        [&]<typename Law>(const Law& each) {
            if constexpr (HasFrictionState<Law>)
                return each.state_slopes(speed);
            else
                return StateSlopes();
        },
        law);
}

}  // namespace stridor::model
