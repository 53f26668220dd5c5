#pragma once

#include "stridor/base/error.hpp"
#include "stridor/model/laws/measured_curve.hpp"
#include "stridor/parameters/case.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

/// Friction of a contact. A law is a struct of its numbers and the functions below; the engines hold a `FrictionLaw`,
/// call these and know no law.
///
/// A law is *state-wise* where its coefficients do not change as long as the contact sticks, or slips one way: the
/// motion within a contact state is then linear, which is what the exact engine solves. Another law has a *jet*, the
/// power series of its resistance along that of the slip velocity, for the Taylor engine. A new law is a struct here
/// and its name in the list; tests/contract/friction_contract.cpp says what it must keep.
///
/// A law may have a *friction state* [1], a number of the contact that changes with the slip: what bent bristles bear.
/// Then friction follows from speed and state. Limit, resistance and slope are those of a steady slip, whose state does
/// not change. Such a contact never sticks by itself: it creeps.
namespace stridor::model {

/// The two ways in which a closed contact slips.
enum class Slip {
    forward,   // w > 0: the rubbed mass is ahead of the surface, T <= 0
    backward,  // w < 0: it lags behind, T >= 0; steady sliding over a surface that moves going
};

inline constexpr std::array<Slip, 2> slips{Slip::forward, Slip::backward};
inline constexpr std::array<std::string_view, 2> slip_names{"forward", "backward"};

/// Returns the way's place in arrays of shape [slip].
constexpr std::size_t index_of(Slip way) {
    return static_cast<std::size_t>(way);
}

/// Returns the way of a slip velocity [m/s] other than zero.
constexpr Slip slip_of(double slip_velocity) {
    return slip_velocity > 0.0 ? Slip::forward : Slip::backward;
}

/// Returns the way in which a stuck contact begins to slip under a friction force [N]: against that force.
constexpr Slip slip_against(double friction_force) {
    return friction_force > 0.0 ? Slip::backward : Slip::forward;
}

/// Between what slopes over the speed of slip a coefficient stays.
struct SlopeRange {
    double least = 0.0;  // [s/m] at most 0: how fast it falls
    double most = 0.0;   // [s/m] at least 0: how fast it rises
    bool operator==(const SlopeRange&) const = default;
};

/// What the recurrences of a law know when they find the next coefficient of its resistance along a motion.
struct JetTerms {
    std::span<const double> speed{};                                 // [m/s] of slip; its last is of the wanted power
    SmoothStretch stretch{};                                         // of speeds, whose function is expanded
    JetSeries resistance{};                                          // [1] those found
    std::array<double, most_jet_coefficients> state{};               // [1] of a law with one, up to the wanted power
    std::array<double, most_jet_coefficients> rate{};                // [1/s] of it: the law adds its own
    std::array<std::array<double, most_jet_coefficients>, 9> own{};  // series that the law keeps beside it

    std::size_t last() const { return speed.size() - 1; }
};

/// Coulomb friction with two coefficients, the same both ways and independent of the slip velocity (Elmaian et al.
/// 2012, Figure 3):
///
///     stick  |T| <= mu_s N        slip  T = -sign(w) mu_d N
struct Coulomb {
    static constexpr auto kind = parameters::FrictionKind::coulomb;

    double static_coefficient = 0.0;   // [1] mu_s
    double kinetic_coefficient = 0.0;  // [1] mu_d <= mu_s

    double limit(Slip) const { return static_coefficient; }
    double resistance(Slip, double) const { return kinetic_coefficient; }
    double resistance_slope(Slip, double) const { return 0.0; }
    SlopeRange slopes() const { return {}; }
    bool operator==(const Coulomb&) const = default;
};

/// Coulomb friction with two coefficients each way: bristles, fibres, a grain that is stroked or ruffled.
///
///     stick  -mu_s(forward) N <= T <= mu_s(backward) N        slip  T = -mu_d(forward) N or +mu_d(backward) N
struct Directional {
    static constexpr auto kind = parameters::FrictionKind::directional;

    std::array<double, 2> static_coefficients{};   // [1] mu_s, shape [slip]
    std::array<double, 2> kinetic_coefficients{};  // [1] mu_d <= mu_s, shape [slip]

    double limit(Slip way) const { return static_coefficients[index_of(way)]; }
    double resistance(Slip way, double) const { return kinetic_coefficients[index_of(way)]; }
    double resistance_slope(Slip, double) const { return 0.0; }
    SlopeRange slopes() const { return {}; }
    bool operator==(const Directional&) const = default;
};

/// Coulomb friction whose kinetic coefficient falls linearly with the slip velocity, down to zero:
///
///     stick  |T| <= mu_s N        slip  T = -sign(w) max(0, mu_d - s |w|) N
///
/// Falling friction feeds vibration: it damps a motion along t by -s N. Beyond |w| = mu_d/s there is no friction left.
struct Linear {
    static constexpr auto kind = parameters::FrictionKind::linear;

    double static_coefficient = 0.0;   // [1] mu_s
    double kinetic_coefficient = 0.0;  // [1] mu_d <= mu_s, of a slip that begins
    double slope = 0.0;                // [s/m] s >= 0

    double limit(Slip) const { return static_coefficient; }
    double resistance(Slip, double speed) const {
        const double left = kinetic_coefficient - slope * speed;
        return left > 0.0 ? left : 0.0;
    }
    double resistance_slope(Slip, double speed) const { return slope * speed < kinetic_coefficient ? -slope : 0.0; }
    SlopeRange slopes() const { return {-slope, 0.0}; }
    std::array<double, 1> corners(Slip) const {
        return {slope > 0.0 ? kinetic_coefficient / slope : std::numeric_limits<double>::infinity()};
    }
    double jet(Slip way, const JetTerms& terms) const {
        if (terms.last() == 0) return resistance(way, terms.speed[0]);
        return terms.stretch.from > 0.0 ? 0.0 : -slope * terms.speed.back();
    }
    bool operator==(const Linear&) const = default;
};

/// Stribeck friction: it falls from mu_s, where a slip begins, towards mu_d, and rises again with the viscosity of what
/// lies between the surfaces,
///
///     stick  |T| <= mu_s N        slip  T = -sign(w) (mu_d + (mu_s - mu_d) f((|w|/v_s)^delta) + k_v |w|) N
///
/// with f(x) = exp(-x), or 1/(1 + x) of the rational one. It is continuous: a slip begins with mu_s. mu_d <= mu_s, so
/// that friction never rises as a slip begins but by k_v. delta >= 1: below it friction falls infinitely fast at w = 0,
/// and a slip that begins has no certain course (w' grows as w to a power below 1).
///
/// Source: R. Stribeck 1902 for the curve; L. C. Bo and D. Pavelescu 1982 for the exponential (delta = 1 is Tustin's, 2
/// a Gaussian curve); B. Armstrong-Helouvry and others 1994. Rational: R. I. Leine and others 1998, whose
/// F_s/(1 + 3 |w|) has mu_d = 0, v_s = 1/3 m/s and delta = 1; Hess and Soom 1990 for delta = 2.
struct Stribeck {
    double static_coefficient = 0.0;                                     // [1] mu_s
    double kinetic_coefficient = 0.0;                                    // [1] mu_d <= mu_s, far beyond v_s
    double velocity = 1.0;                                               // [m/s] v_s > 0
    double exponent = 1.0;                                               // [1] delta >= 1
    double viscous = 0.0;                                                // [s/m] k_v >= 0
    parameters::FrictionKind kind = parameters::FrictionKind::stribeck;  // or stribeck_rational: which f

    double limit(Slip) const { return static_coefficient; }
    double resistance(Slip way, double speed) const;
    double resistance_slope(Slip way, double speed) const;
    // no steeper than this: x^(delta - 1) exp(-x^delta) and x^(delta - 1)/(1 + x^delta)^2 are at most 1
    SlopeRange slopes() const { return {-exponent * fall() / velocity, viscous}; }
    // a power that is no whole number is not analytic where a slip begins
    bool has_jet() const { return exponent == std::floor(exponent); }
    // Friction has fallen beyond it: what is left of the fall is below rounding. A power series that begins there would
    // not tell that friction rises again as the speed falls.
    std::array<double, 1> corners(Slip) const;
    // As a slip begins its series has terms of multiples of delta alone. The last of 24 show up to delta = 4 whether it
    // has converged; with more they may lie between two, and a fifth of v_s is certain.
    double told_change(double speed) const {
        return exponent > 4.0 && speed < velocity ? 0.2 * velocity : std::numeric_limits<double>::infinity();
    }
    double jet(Slip way, JetTerms& terms) const;
    double fall() const { return static_coefficient - kinetic_coefficient; }
    bool is_exponential() const { return kind == parameters::FrictionKind::stribeck; }
    bool operator==(const Stribeck&) const = default;
};

/// Friction as measured over the slip velocity:
///
///     stick  |T| <= mu_s N        slip  T = -sign(w) mu(|w|) N
///
/// mu_s is that of the table at rest, or more: then it drops as a slip begins. Above mu_s no row counts. Before its
/// first row and beyond its last one their values hold.
struct Measured {
    static constexpr auto kind = parameters::FrictionKind::table;

    double static_coefficient = 0.0;             // [1] mu_s
    std::shared_ptr<const MeasuredCurve> curve;  // shared: it is never changed
    SlopeRange range;                            // [s/m] of the curve

    double limit(Slip) const { return static_coefficient; }
    double resistance(Slip way, double speed) const;
    double resistance_slope(Slip way, double speed) const;
    SlopeRange slopes() const { return range; }
    std::vector<double> corners(Slip) const;
    double jet(Slip way, JetTerms& terms) const;
    bool operator==(const Measured& other) const {
        return static_coefficient == other.static_coefficient && *curve == *other.curve;
    }
};

/// Friction without a stick, as programs have it that cannot stick; for comparison only:
///
///     T = -mu_d tanh(w/v_r) N        or        T = -mu_d (2/pi) arctan(w/v_r) N
///
/// Where a contact should stick it creeps. The smaller v_r, the slower it creeps, and the stiffer the motion.
struct Regularised {
    double coefficient = 0.0;                                        // [1] mu_d
    double velocity = 1.0;                                           // [m/s] v_r > 0
    parameters::FrictionKind kind = parameters::FrictionKind::tanh;  // or arctan

    double limit(Slip) const { return 0.0; }
    double resistance(Slip way, double speed) const;
    double resistance_slope(Slip way, double speed) const;
    SlopeRange slopes() const { return {0.0, coefficient / velocity}; }
    bool operator==(const Regularised&) const = default;
};

/// How a law with a friction state answers small changes of a steady slip.
struct StateSlopes {
    double resistance_by_state = 0.0;  // [1]
    double resistance_by_speed = 0.0;  // [s/m]
    double rate_by_state = 0.0;        // [1/s]
    double rate_by_speed = 0.0;        // [1/m]
};

/// Friction of bristles that bend, by their mean bend z [m] (LuGre):
///
///     z' = w - |w| s/g,    s = sigma_0 z,    g = mu_d + (mu_s - mu_d) exp(-(|w|/v_s)^delta)
///     T = -(s + sigma_1 z' + k_v w) N
///
/// The friction state is s, which a slip forward has with this sign and one backward with the other. A steady slip has
/// s = g, Stribeck's curve. Below mu_s the bristles bend as a spring of sigma_0 N, and the contact creeps. With
/// mu_s = mu_d and sigma_1 = k_v = 0 it is Dahl's friction. What the bristles hold aside, friction adds no energy where
/// k_v >= sigma_1 (mu_s/mu_d - 1). Source: C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky 1995; P. Dahl
/// 1968; N. Barabanov and R. Ortega 2000 for that bound.
struct LuGre {
    static constexpr auto kind = parameters::FrictionKind::lugre;
    static constexpr bool state_turns = true;  // with the way of the slip

    Stribeck curve;          // exponential, mu_d > 0
    double stiffness = 1.0;  // [1/m] sigma_0 > 0, of the bristles per normal force
    double damping = 0.0;    // [s/m] sigma_1 >= 0, likewise

    double limit(Slip) const { return curve.static_coefficient; }
    double resistance(Slip way, double speed) const;
    double resistance_slope(Slip way, double speed) const;
    SlopeRange slopes() const { return curve.slopes(); }
    double steady_state(double speed) const;
    double state_rate(double speed, double state) const;        // [1/s]
    double state_resistance(double speed, double state) const;  // [1]
    StateSlopes state_slopes(double speed) const;
    bool has_jet() const { return curve.has_jet(); }
    std::array<double, 1> corners(Slip way) const { return curve.corners(way); }
    double told_change(double speed) const { return curve.told_change(speed); }
    double jet(Slip way, JetTerms& terms) const;
    bool operator==(const LuGre&) const = default;
};

/// Friction that follows the rate of slip and the state of the surfaces, psi = ln(V_0 theta/D_c) [1], where theta is
/// the age of their contacts:
///
///     T = -sign(w) a arsinh(|w|/(2 V_0) exp((mu_0 + b psi)/a)) N
///     ageing law (Dieterich)   psi' = V_0/D_c exp(-psi) - |w|/D_c
///     slip law (Ruina)         psi' = -|w|/D_c (ln(|w|/V_0) + psi)
///
/// Away from rest that is mu_0 + a ln(|w|/V_0) + b psi; the arsinh makes it pass through zero at w = 0. A steady slip
/// has mu_0 + (a - b) ln(|w|/V_0). Its state counts 1e-15 V_0 to |w|, so that it is a number at rest, and so does the
/// slip law. Source: J. H. Dieterich 1979; A. Ruina 1983; J. R. Rice, N. Lapusta, K. Ranjith 2001 for the arsinh.
struct RateAndState {
    static constexpr bool state_turns = false;

    parameters::FrictionKind kind = parameters::FrictionKind::dieterich;  // or ruina
    double coefficient = 0.0;                                             // [1] mu_0, of a steady slip with V_0
    double direct_effect = 1.0;                                           // [1] a > 0
    double evolution_effect = 0.0;                                        // [1] b >= 0
    double length = 1.0;                                                  // [m] D_c > 0
    double velocity = 1.0;                                                // [m/s] V_0 > 0

    double limit(Slip) const { return 0.0; }
    double resistance(Slip, double speed) const { return state_resistance(speed, steady_state(speed)); }
    double resistance_slope(Slip way, double speed) const;
    SlopeRange slopes() const;
    double steady_state(double speed) const;
    double state_rate(double speed, double state) const;        // [1/s]
    double state_resistance(double speed, double state) const;  // [1]
    StateSlopes state_slopes(double speed) const;
    double jet(Slip way, JetTerms& terms) const;
    bool operator==(const RateAndState&) const = default;
};

using FrictionLaw = std::variant<Coulomb, Directional, Linear, Stribeck, Measured, Regularised, LuGre, RateAndState>;

/// Returns the law's kind, by which a case names it.
inline parameters::FrictionKind kind_of(const FrictionLaw& law) {
    return std::visit([](const auto& each) { return each.kind; }, law);
}

/// Says whether the law keeps its coefficients while the contact sticks, or slips one way.
inline bool is_state_wise(const FrictionLaw& law) {
    return parameters::is_state_wise(kind_of(law));
}

/// Returns the largest friction force over normal force [1], without sign, that keeps a stuck contact from slipping
/// that way.
inline double stick_limit(const FrictionLaw& law, Slip way) {
    return std::visit([way](const auto& each) { return each.limit(way); }, law);
}

/// Returns friction force over normal force [1], T/N on the rubbed mass, while the contact slips that way with a slip
/// velocity w [m/s]. It acts against the slip: at most 0 forward, at least 0 backward, and within the limit of the
/// stick that way. A w that points the other way counts as 0.
inline double slip_ratio(const FrictionLaw& law, Slip way, double slip_velocity) {
    const double sign = way == Slip::forward ? 1.0 : -1.0;
    const double speed = sign * slip_velocity > 0.0 ? sign * slip_velocity : 0.0;
    return std::visit([=](const auto& each) { return -sign * each.resistance(way, speed); }, law);
}

/// Returns the ratio [1] of a slip that begins, w = 0. For a state-wise law that is the ratio of any slip.
inline double slip_ratio(const FrictionLaw& law, Slip way) {
    return slip_ratio(law, way, 0.0);
}

/// Returns the change of `slip_ratio` with the slip velocity [s/m], above zero where friction falls with the speed of
/// slip.
inline double slip_ratio_slope(const FrictionLaw& law, Slip way, double slip_velocity) {
    const double speed = way == Slip::forward ? slip_velocity : -slip_velocity;
    if (speed < 0.0) return 0.0;
    return std::visit([=](const auto& each) { return -each.resistance_slope(way, speed); }, law);
}

/// Returns between what slopes over the speed of slip the law's coefficient stays: steps tell from it whether they
/// leave more than one lawful slip.
inline SlopeRange slope_range(const FrictionLaw& law) {
    return std::visit([](const auto& each) { return each.slopes(); }, law);
}

template <typename Law>
concept HasFrictionState = requires(const Law& law) {
    law.steady_state(0.0);
};

/// Says whether the law has a friction state. A contact that rubs by it creeps, and never sticks.
inline bool has_friction_state(const FrictionLaw& law) {
    return std::visit([]<typename Law>(const Law&) { return HasFrictionState<Law>; }, law);
}

/// Returns -1 where a slip that way has the law's state with the other sign, else 1.
inline double state_sign(const FrictionLaw& law, Slip way) {
    const bool turns = std::visit(
        []<typename Law>(const Law&) {
            if constexpr (HasFrictionState<Law>)
                return Law::state_turns;
            else
                return false;
        },
        law);
    return turns && way == Slip::backward ? -1.0 : 1.0;
}

/// Returns the friction state of a steady slip with this slip velocity [m/s]; 0 at rest, and for a law without one.
double steady_friction_state(const FrictionLaw& law, double slip_velocity);

/// Returns how a law with a friction state answers small changes of a steady slip with this speed [m/s].
StateSlopes state_slopes(const FrictionLaw& law, double speed);

/// Says whether a contact can stick with these forces [N]. It cannot if N < 0.
bool holds(const FrictionLaw& law, double normal_force, double friction_force);

/// Returns what may be doubted about a law: bristles whose damping adds energy to some motions; nothing where
/// friction only takes it.
std::optional<base::Problem> doubt_of(const FrictionLaw& law);

/// Returns the friction law of a case's contact.
FrictionLaw friction_law(const parameters::Contact& contact);

}  // namespace stridor::model
