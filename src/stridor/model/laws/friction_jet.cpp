#include "stridor/model/laws/friction_jet.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>
#include <vector>

namespace stridor::model {

namespace {

template <typename Law>
concept HasJet = requires(const Law& law, JetTerms& terms) {
    { law.jet(Slip::forward, terms) } -> std::convertible_to<double>;
};

constexpr std::size_t outer = 7;     // of a law's own series, behind those of powers
constexpr std::size_t quotient = 8;  // behind it

// (|w|/v_s)^delta up to the wanted coefficient, by squares: delta is whole, and 20 at most
std::span<const double> speed_powers(const Stribeck& law, JetTerms& terms) {
    const std::size_t m = terms.last();
    std::size_t square = 0, next = 1, product = outer;
    terms.own[0][m] = terms.speed[m] / law.velocity;
    for (auto left = static_cast<unsigned>(law.exponent);;) {
        if (left % 2 == 1 && product == outer) {
            product = square;
        } else if (left % 2 == 1) {
            terms.own[next][m] = convolution(terms.own[product], terms.own[square], 0, m);
            product = next++;
        }
        left /= 2;
        if (left == 0) return terms.own[product];
        terms.own[next][m] = convolution(terms.own[square], terms.own[square], 0, m);
        square = next++;
    }
}

// a speed [m/s] within a stretch
double middle(const SmoothStretch& stretch) {
    const double from = stretch.from > 0.0 ? stretch.from : 0.0;
    return stretch.to < std::numeric_limits<double>::infinity() ? 0.5 * (from + stretch.to) : stretch.to;
}

}  // namespace

// where f(x) is the rounding of 1
std::array<double, 1> Stribeck::corners(Slip) const {
    if (!(fall() > 0.0)) return {std::numeric_limits<double>::infinity()};
    const double fallen = is_exponential() ? 37.0 : 0x1p53;  // [1] (|w|/v_s)^delta
    return {velocity * base::power(fallen, 1.0 / exponent)};
}

// y = exp(-x) has m y_m = -sum j x_j y_(m-j); y = 1/(1 + x) has (1 + x_0) y_m = -sum x_j y_(m-j)
double Stribeck::jet(Slip, JetTerms& terms) const {
    const std::size_t m = terms.last();
    std::array<double, most_jet_coefficients>& y = terms.own[outer];
    if (m > 0 && terms.stretch.from > 0.0) {
        y[m] = 0.0;
        return viscous * terms.speed[m];
    }
    const std::span<const double> x = speed_powers(*this, terms);
    if (m == 0) {
        y[0] = is_exponential() ? base::exponential(-x[0]) : 1.0 / (1.0 + x[0]);
        const double lost = is_exponential() ? 1.0 - y[0] : x[0] * y[0];
        return static_coefficient - fall() * lost + viscous * terms.speed[0];
    }
    if (is_exponential()) {
        double sum = 0.0;
        for (std::size_t j = 1; j <= m; ++j)
            sum += static_cast<double>(j) * x[j] * y[m - j];
        y[m] = -sum / static_cast<double>(m);
    } else {
        y[m] = -convolution(x, y, 1, m) / (1.0 + x[0]);
    }
    return fall() * y[m] + viscous * terms.speed[m];
}

// g = mu_d + (mu_s - mu_d) y with the curve's own y; u = s/g has g_0 u_m = s_m - sum g_j u_(m-j), j = 1..m
double LuGre::jet(Slip way, JetTerms& terms) const {
    const std::size_t m = terms.last();
    curve.jet(way, terms);
    const std::array<double, most_jet_coefficients>& y = terms.own[outer];
    std::array<double, most_jet_coefficients>& u = terms.own[quotient];
    double rest = terms.state[m];
    for (std::size_t j = 1; j <= m; ++j)
        rest -= curve.fall() * y[j] * u[m - j];
    u[m] = rest / (curve.kinetic_coefficient + curve.fall() * y[0]);
    const double bend = terms.speed[m] - convolution(terms.speed, u, 0, m);
    terms.rate[m] = stiffness * bend;
    return terms.state[m] + damping * bend + curve.viscous * terms.speed[m];
}

// the rows beyond rest, and where the curve passes mu_s: above it no row counts
std::vector<double> Measured::corners(Slip way) const {
    std::vector<double> corners;
    if (curve->places.front() > 0.0) corners.push_back(curve->places.front());
    for (std::size_t k = 0; k + 1 < curve->places.size(); ++k) {
        double low = curve->places[k], high = curve->places[k + 1];
        const bool begins_below = curve->values[k] < static_coefficient;
        const bool ends_below = curve->values[k + 1] < static_coefficient;
        for (bool halves = begins_below != ends_below; halves;) {
            const double place = 0.5 * (low + high);
            halves = place > low && place < high;
            ((resistance(way, place) < static_coefficient) == begins_below ? low : high) = place;
        }
        if (begins_below != ends_below && high < curve->places[k + 1]) corners.push_back(high);
        corners.push_back(curve->places[k + 1]);
    }
    return corners;
}

double Measured::jet(Slip way, JetTerms& terms) const {
    const std::size_t m = terms.last();
    if (m == 0) return resistance(way, terms.speed[0]);
    const double within = middle(terms.stretch);
    const bool is_level = within < curve->places.front() || within >= curve->places.back();
    if (is_level || resistance(way, within) >= static_coefficient) return 0.0;
    return jet_behind_row(*curve, row_before(*curve, within), terms.speed, std::span(terms.own).first<3>());
}

bool has_jet(const FrictionLaw& law) {
    return std::visit(
        [&]<typename Law>(const Law& each) {
            if constexpr (requires { each.has_jet(); })
                return each.has_jet();
            else
                return HasJet<Law> || is_state_wise(law);
        },
        law);
}

SmoothStretch speed_stretch(const FrictionLaw& law, Slip way, double speed, double rounding, CornerSide side) {
    return std::visit(
        [&](const auto& each) {
            if constexpr (requires { each.corners(way); })
                return stretch_between(each.corners(way), speed, rounding, side);
            else
                return SmoothStretch{};
        },
        law);
}

double told_change(const FrictionLaw& law, double speed) {
    return std::visit(
        [&](const auto& each) {
            if constexpr (requires { each.told_change(speed); })
                return each.told_change(speed);
            else
                return std::numeric_limits<double>::infinity();
        },
        law);
}

double FrictionJet::next(std::span<const double> speed) {
    STRIDOR_EXPECT(!speed.empty() && speed.size() <= most_jet_coefficients);
    terms_.speed = speed;
    const std::size_t m = terms_.last();
    if (m > 0) terms_.state[m] = step_ / static_cast<double>(m) * terms_.rate[m - 1];
    terms_.resistance[m] = std::visit(
        [&]<typename Law>(const Law& law) {
            if constexpr (HasJet<Law>)
                return law.jet(way_, terms_);
            else
                return m == 0 ? law.resistance(way_, speed[0]) : 0.0;
        },
        *law_);
    return terms_.resistance[m];
}

}  // namespace stridor::model
