#pragma once

#include "stridor/analysis/friction/fit.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// The least squares behind `friction_fit`.
namespace stridor::analysis {

/// The end of an interval that the data leave open.
inline constexpr double open_end = std::numeric_limits<double>::infinity();

/// The least sum of squares over the numbers of a law that is linear in them.
struct LinearFit {
    double squares = open_end;
    std::vector<double> numbers;
    std::vector<std::size_t> free;  // the numbers above zero
    Eigen::MatrixXd inverse;        // of the normal equations of the free numbers
};

/// A form of a law: its columns at the points, for a v_s if it has one.
struct LawForm {
    std::size_t kind = 0;
    double exponent = 1.0;  // [1] delta
    bool has_velocity = false;
    bool has_viscous = false;
    std::vector<double> knots{};  // [m/s] of a table
};

/// What all forms are fitted to.
struct PointSet {
    const std::vector<FrictionPoint>& points;
    double fastest = 1.0;  // [m/s]
    double slowest = 1.0;  // [m/s] above zero
    double level = 1.0;    // [1]
};

/// A form at its best v_s.
struct FittedForm {
    LawForm form;
    double velocity = 0.0;  // [m/s]
    LinearFit fit;
    std::size_t free_numbers = 0;
    double criterion = open_end;
};

/// Returns the number of a law that a contact keeps in this place. Fitted values lie within their interval, but for
/// rounding.
FittedNumber number_called(double parameters::Contact::*member, double value, std::pair<double, double> interval);

/// Returns Akaike's criterion, corrected for few points, of a sum of squares over so many points, of a law of so many
/// numbers.
double akaike(double squares, double points, double numbers);

/// Returns the form with the least sum of squares.
FittedForm best_form(const LawForm& form, const PointSet& set);

/// Returns what a form leaves of the points [1], shape [point].
std::vector<double> residuals_of(const FittedForm& fitted, const PointSet& set);

/// Returns the quantile 0.975 of Student's t, better than 1e-3 (Hill 1970, as an expansion).
double student_975(double degrees);

/// Returns the v_s [m/s] at which the sum of squares, the other numbers fitted anew, does not exceed the limit; 0 or
/// infinite where an end is not to be seen.
std::pair<double, double> velocities_within(const FittedForm& fitted, const PointSet& set, double squares);

/// Returns the values of a sum of numbers at which the sum of squares, the others fitted anew, does not exceed the
/// limit, over the v_s of `velocities_within`.
std::pair<double, double> values_within(const FittedForm& fitted, const PointSet& set, double squares,
                                        const std::vector<std::size_t>& sum);

}  // namespace stridor::analysis
