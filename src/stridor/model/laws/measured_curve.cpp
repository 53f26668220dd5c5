#include "stridor/model/laws/measured_curve.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::model {

namespace {

// slope of the cubic at the first or last row: that of the parabola through three rows, held to the monotone ones
double end_slope(double near_width, double far_width, double near, double far) {
    const double slope = ((2.0 * near_width + far_width) * near - near_width * far) / (near_width + far_width);
    if (slope * near <= 0.0) return 0.0;
    if (near * far <= 0.0 && std::abs(slope) > 3.0 * std::abs(near)) return 3.0 * near;
    return slope;
}

}  // namespace

double convolution(std::span<const double> a, std::span<const double> b, std::size_t first, std::size_t m) {
    double sum = 0.0;
    for (std::size_t j = first; j <= m; ++j)
        sum += a[j] * b[m - j];
    return sum;
}

SmoothStretch stretch_between(std::span<const double> corners, double place, double rounding, CornerSide side) {
    SmoothStretch stretch;
    for (const double corner : corners) {
        const bool is_above = side == CornerSide::above ? place >= corner - rounding : place > corner + rounding;
        if (!is_above) {
            stretch.to = corner;
            break;
        }
        stretch.from = corner;
    }
    return stretch;
}

MeasuredCurve measured_curve(const std::vector<double>& places, const std::vector<double>& values,
                             parameters::Interpolation interpolation) {
    MeasuredCurve curve{places, values, {}};
    const std::size_t rows = places.size();
    if (interpolation == parameters::Interpolation::linear || rows < 3) return curve;
    std::vector<double> widths, secants;
    for (std::size_t k = 0; k + 1 < rows; ++k) {
        widths.push_back(places[k + 1] - places[k]);
        secants.push_back((values[k + 1] - values[k]) / widths[k]);
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

std::size_t row_before(const MeasuredCurve& curve, double place) {
    const auto next = std::upper_bound(curve.places.begin(), curve.places.end(), place);
    const auto row = static_cast<std::size_t>(next - curve.places.begin());
    return std::clamp<std::size_t>(row, 1, curve.places.size() - 1) - 1;
}

double value_behind_row(const MeasuredCurve& curve, std::size_t k, double place) {
    const double width = curve.places[k + 1] - curve.places[k], x = (place - curve.places[k]) / width;
    const double rise = curve.values[k + 1] - curve.values[k];
    const double value = curve.values[k] + x * rise;
    if (curve.slopes.empty()) return value;
    const double from = width * curve.slopes[k] - rise, to = width * curve.slopes[k + 1] - rise;
    return value + x * (1.0 - x) * (from * (1.0 - x) - to * x);
}

double slope_behind_row(const MeasuredCurve& curve, std::size_t k, double place) {
    const double width = curve.places[k + 1] - curve.places[k], x = (place - curve.places[k]) / width;
    const double secant = (curve.values[k + 1] - curve.values[k]) / width;
    if (curve.slopes.empty()) return secant;
    const double from = curve.slopes[k] - secant, to = curve.slopes[k + 1] - secant;
    return secant + from * (1.0 - x) * (1.0 - 3.0 * x) + to * x * (3.0 * x - 2.0);
}

// within rows that stand h apart, x = (place - x_k)/h: y_k + x d + x (1 - x) (a (1 - x) - b x), a = h s_k - d,
// b = h s_(k+1) - d
double jet_behind_row(const MeasuredCurve& curve, std::size_t k, std::span<const double> place,
                      std::span<JetSeries, 3> kept) {
    const std::size_t m = place.size() - 1;
    const double h = curve.places[k + 1] - curve.places[k], d = curve.values[k + 1] - curve.values[k];
    JetSeries &x = kept[0], &square = kept[1], &cube = kept[2];
    if (m == 1) {
        x[0] = (place[0] - curve.places[k]) / h;
        square[0] = x[0] * x[0];
        cube[0] = square[0] * x[0];
    }
    x[m] = place[m] / h;
    if (curve.slopes.empty()) return d * x[m];
    square[m] = convolution(x, x, 0, m);
    cube[m] = convolution(square, x, 0, m);
    const double a = h * curve.slopes[k] - d, b = h * curve.slopes[k + 1] - d;
    return (d + a) * x[m] - (2.0 * a + b) * square[m] + (a + b) * cube[m];
}

}  // namespace stridor::model
