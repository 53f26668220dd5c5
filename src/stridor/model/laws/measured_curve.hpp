#pragma once

#include "stridor/parameters/case.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

/// A curve through measured rows, and its power series along a motion: friction over the speed of slip, the force of a
/// spring over its elongation.
namespace stridor::model {

/// Most coefficients of a power series along a motion.
inline constexpr std::size_t most_jet_coefficients = 32;

/// Coefficients of a power series along a motion.
using JetSeries = std::array<double, most_jet_coefficients>;

/// Returns the sum of a_j b_(m-j), j = first..m.
double convolution(std::span<const double> a, std::span<const double> b, std::size_t first, std::size_t m);

/// The places around one over which a law is one analytic function. Its corners end it.
struct SmoothStretch {
    double from = -std::numeric_limits<double>::infinity();  // in the unit of the place; without end before all corners
    double to = std::numeric_limits<double>::infinity();
};

/// Which stretch a place belongs to that stands on the corner between two.
enum class CornerSide { below, above };

/// Returns the stretch of a place between rising corners; within `rounding` of a corner, the one on that side.
SmoothStretch stretch_between(std::span<const double> corners, double place, double rounding, CornerSide side);

/// A curve through measured rows: straight between them, or cubic without a new peak or valley.
///
/// Source: F. N. Fritsch and R. E. Carlson 1980, with the slopes of F. N. Fritsch and J. Butland 1984: at a row the
/// harmonic mean of those beside it, weighted by their widths, and 0 at a peak or valley.
struct MeasuredCurve {
    std::vector<double> places;  // rising, shape [row]: [m/s] of a slip, [m] of an elongation
    std::vector<double> values;  // shape [row]: [1] of friction, [N] of a force
    std::vector<double> slopes;  // value per place, at the rows if cubic; straight if empty
    bool operator==(const MeasuredCurve&) const = default;
};

/// Returns the curve through rows, two at least.
MeasuredCurve measured_curve(const std::vector<double>& places, const std::vector<double>& values,
                             parameters::Interpolation interpolation);

/// Returns the row before a place within the table; the first or the last but one beyond its ends.
std::size_t row_before(const MeasuredCurve& curve, double place);

/// Returns value and slope at a place between row k and the next one.
double value_behind_row(const MeasuredCurve& curve, std::size_t k, double place);
double slope_behind_row(const MeasuredCurve& curve, std::size_t k, double place);

/// Returns the last coefficient of the curve's value between row k and the next one, from those of the place up to it,
/// two at least. `kept`: the share of the way between the rows [1], its square and its cube, from coefficient to
/// coefficient.
double jet_behind_row(const MeasuredCurve& curve, std::size_t k, std::span<const double> place,
                      std::span<JetSeries, 3> kept);

}  // namespace stridor::model
