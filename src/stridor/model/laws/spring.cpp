#include "stridor/model/laws/spring.hpp"

#include "stridor/base/elementary.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace stridor::model {

namespace {

constexpr double blunt_share = 1e-6;  // [1] of a usual deflection: what it changes of an impulse is 1e-15

// y = c1 x + c2 x² + c3 x³ [N] of x = (e - g)/length
struct PowerPiece {
    double length = 1.0;  // [m]
    std::array<double, 3> c{};
};

bool is_whole(double p) {
    return p == std::floor(p);
}

// x to the power p for x >= 0: half powers by a square root, which has the same bits on every machine
double power_of(double x, double p) {
    if (p == 1.5) return x * std::sqrt(x);
    if (p == 2.5) return x * x * std::sqrt(x);
    return base::power(x, p);
}

double force_beyond(const PowerSpring& law, double way) {
    return law.reference_force * power_of(way / law.reference_deflection, law.exponent);
}

// of a whole power, or next to the gap
PowerPiece piece_of(const PowerSpring& law) {
    PowerPiece piece{law.reference_deflection, {}};
    if (is_whole(law.exponent)) {
        piece.c.at(static_cast<std::size_t>(law.exponent) - 1) = law.reference_force;
        return piece;
    }
    const double there = force_beyond(law, law.blunt);
    return {law.blunt, {0.0, there * (3.0 - law.exponent), there * (law.exponent - 2.0)}};
}

bool is_polynomial(const PowerSpring& law, double way) {
    return is_whole(law.exponent) || way < law.blunt;
}

// an elongation [m] within a stretch
double place_within(const SmoothStretch& stretch) {
    if (!std::isfinite(stretch.from)) return stretch.to - 1.0;
    return std::isfinite(stretch.to) ? 0.5 * (stretch.from + stretch.to) : stretch.from + 1.0;
}

double slope_beyond(const MeasuredCurve& curve, bool is_last) {
    const std::size_t rows = curve.places.size();
    return is_last ? slope_behind_row(curve, rows - 2, curve.places.back())
                   : slope_behind_row(curve, 0, curve.places.front());
}

// [J] from row k up to a share x of the way to the next
double stored_behind_row(const MeasuredCurve& curve, std::size_t k, double x) {
    const double h = curve.places[k + 1] - curve.places[k], d = curve.values[k + 1] - curve.values[k];
    double sum = curve.values[k] * x + 0.5 * d * x * x;
    if (!curve.slopes.empty()) {
        const double a = h * curve.slopes[k] - d, b = h * curve.slopes[k + 1] - d;
        sum += x * x * (a * (0.5 - x * (2.0 / 3.0 - 0.25 * x)) - b * x * (1.0 / 3.0 - 0.25 * x));
    }
    return h * sum;
}

}  // namespace

double CubicSpring::jet(SpringTerms& terms) const {
    const std::size_t m = terms.elongation.size() - 1;
    terms.own[0][m] = convolution(terms.elongation, terms.elongation, 0, m);
    return cubic * convolution(terms.own[0], terms.elongation, 0, m);
}

double PowerSpring::force(double e) const {
    const double way = e - gap;
    if (!(way > 0.0)) return 0.0;
    if (!is_polynomial(*this, way)) return force_beyond(*this, way);
    const auto [length, c] = piece_of(*this);
    const double x = way / length;
    return x * (c[0] + x * (c[1] + x * c[2]));
}

double PowerSpring::stiffness(double e) const {
    const double way = e - gap;
    if (!(way > 0.0)) return 0.0;
    if (!is_polynomial(*this, way)) return exponent * force_beyond(*this, way) / way;
    const auto [length, c] = piece_of(*this);
    const double x = way / length;
    return (c[0] + x * (2.0 * c[1] + x * 3.0 * c[2])) / length;
}

double PowerSpring::energy(double e) const {
    const double way = e - gap;
    if (!(way > 0.0)) return 0.0;
    const auto [length, c] = piece_of(*this);
    const bool is_near = is_polynomial(*this, way);
    const double x = is_near ? way / length : 1.0;
    const double near = length * (x * x * (0.5 * c[0] + x * (c[1] / 3.0 + 0.25 * x * c[2])));
    if (is_near) return near;
    return near + (way * force_beyond(*this, way) - length * force_beyond(*this, length)) / (exponent + 1.0);
}

std::vector<double> PowerSpring::corners() const {
    if (is_whole(exponent)) return {gap};
    return {gap, gap + blunt};
}

// y = x^p has m x_0 y_m = sum (j (p + 1) - m) x_j y_(m-j), j = 1..m
double PowerSpring::jet(SpringTerms& terms) const {
    const std::size_t m = terms.elongation.size() - 1;
    const bool is_apart = terms.stretch.to == gap;
    const bool is_near = is_whole(exponent) || terms.stretch.from == gap;
    const auto [length, c] = is_near ? piece_of(*this) : PowerPiece{reference_deflection, {}};
    JetSeries &x = terms.own[0], &square = terms.own[1], &cube = terms.own[2];
    x[m] = (m == 0 ? terms.elongation[0] - gap : terms.elongation[m]) / length;
    if (is_apart) return 0.0;
    if (is_near) {
        square[m] = convolution(x, x, 0, m);
        cube[m] = convolution(square, x, 0, m);
        return c[0] * x[m] + c[1] * square[m] + c[2] * cube[m];
    }
    JetSeries& y = square;
    if (m == 0) {
        y[0] = power_of(x[0], exponent);
        return reference_force * y[0];
    }
    double sum = 0.0;
    for (std::size_t j = 1; j <= m; ++j)
        sum += (static_cast<double>(j) * (exponent + 1.0) - static_cast<double>(m)) * x[j] * y[m - j];
    y[m] = sum / (static_cast<double>(m) * x[0]);
    return reference_force * y[m];
}

double TableSpring::force(double e) const {
    const MeasuredCurve& c = *curve;
    if (e < c.places.front()) return c.values.front() + slope_beyond(c, false) * (e - c.places.front());
    if (e > c.places.back()) return c.values.back() + slope_beyond(c, true) * (e - c.places.back());
    return value_behind_row(c, row_before(c, e), e);
}

double TableSpring::stiffness(double e) const {
    const MeasuredCurve& c = *curve;
    if (e < c.places.front()) return slope_beyond(c, false);
    if (e > c.places.back()) return slope_beyond(c, true);
    return slope_behind_row(c, row_before(c, e), e);
}

double TableSpring::energy(double e) const {
    const MeasuredCurve& c = *curve;
    const auto straight = [&](double from, double force, double slope) {
        return (e - from) * (force + 0.5 * slope * (e - from));
    };
    if (e < c.places.front()) return straight(c.places.front(), c.values.front(), slope_beyond(c, false));
    if (e > c.places.back()) return stored.back() + straight(c.places.back(), c.values.back(), slope_beyond(c, true));
    const std::size_t k = row_before(c, e);
    return stored[k] + stored_behind_row(c, k, (e - c.places[k]) / (c.places[k + 1] - c.places[k]));
}

double TableSpring::jet(SpringTerms& terms) const {
    const std::size_t m = terms.elongation.size() - 1;
    if (m == 0) return force(terms.elongation[0]);
    const double within = place_within(terms.stretch);
    if (within < curve->places.front()) return slope_beyond(*curve, false) * terms.elongation[m];
    if (within > curve->places.back()) return slope_beyond(*curve, true) * terms.elongation[m];
    return jet_behind_row(*curve, row_before(*curve, within), terms.elongation, terms.own);
}

TableSpring table_spring(const std::vector<double>& elongations, const std::vector<double>& forces,
                         parameters::Interpolation interpolation) {
    auto curve = std::make_shared<const MeasuredCurve>(measured_curve(elongations, forces, interpolation));
    std::vector<double> stored{0.0};
    for (std::size_t k = 0; k + 1 < elongations.size(); ++k)
        stored.push_back(stored.back() + stored_behind_row(*curve, k, 1.0));
    return {std::move(curve), std::move(stored)};
}

PowerSpring power_spring(double reference_force, double reference_deflection, double exponent, double gap,
                         double usual_force) {
    PowerSpring law{reference_force, reference_deflection, exponent, gap, 0.0};
    if (is_whole(exponent)) return law;
    const bool is_known = usual_force > 0.0 && reference_force > 0.0;
    law.blunt = blunt_share * reference_deflection *
                (is_known ? base::power(usual_force / reference_force, 1.0 / exponent) : 1.0);
    return law;
}

SmoothStretch elongation_stretch(const SpringLaw& law, double e, double rounding, CornerSide side) {
    return std::visit([&](const auto& each) { return stretch_between(each.corners(), e, rounding, side); }, law);
}

double elongation_under(const SpringLaw& law, double linear, double force) {
    constexpr double longest = 1e6;  // [m]
    const auto pushes_more = [&](double e) { return linear * e + force_of(law, e) > force; };
    double low = 0.0, high = 0.0;
    const bool is_beyond = pushes_more(0.0);
    for (double way = 1e-9; is_beyond ? pushes_more(low) : !pushes_more(high); way *= 2.0) {
        if (way > longest) return std::numeric_limits<double>::infinity();
        (is_beyond ? low : high) = is_beyond ? -way : way;
    }
    for (;;) {
        const double between = 0.5 * (low + high);
        if (!(between > low && between < high)) return low;
        (pushes_more(between) ? high : low) = between;
    }
}

}  // namespace stridor::model
