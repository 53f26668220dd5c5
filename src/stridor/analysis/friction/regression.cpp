// For a given v_s a law is a sum of columns, one per number beta >= 0:
//
//     mu_d + (mu_s - mu_d) g(w/v_s) + k_v w        beta = (mu_d, mu_s - mu_d, k_v)
//     mu_d - s w                                   beta = (mu_d, s)
//
// The bounds of the laws are beta >= 0. With at most four columns all sets of free numbers are tried; the least sum of
// squares among those without a negative number is the answer.

#include "stridor/analysis/friction/regression.hpp"

#include "stridor/analysis/friction/stretches.hpp"
#include "stridor/base/decompositions.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::analysis {

namespace {

using parameters::FrictionKind;

constexpr std::size_t velocities_tried = 61;

// points, and the columns of a law at them
struct LinearProblem {
    std::vector<std::vector<double>> columns;  // shape [number][point]
    std::vector<double> wanted;                // [1] shape [point]
};

// nothing if the columns depend on each other
std::optional<LinearFit> fit_of(const LinearProblem& problem, const std::vector<std::size_t>& free) {
    const auto size = static_cast<Eigen::Index>(free.size());
    const std::size_t points = problem.wanted.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
    std::vector<double> scale(free.size());
    for (std::size_t j = 0; j < free.size(); ++j) {
        double squares = 0.0;
        for (std::size_t k = 0; k < points; ++k)
            squares += problem.columns[free[j]][k] * problem.columns[free[j]][k];
        if (!(squares > 0.0)) return std::nullopt;
        scale[j] = 1.0 / std::sqrt(squares);
    }
    for (std::size_t k = 0; k < points; ++k) {
        for (std::size_t i = 0; i < free.size(); ++i) {
            const double a = problem.columns[free[i]][k] * scale[i];
            right(static_cast<Eigen::Index>(i)) += a * problem.wanted[k];
            for (std::size_t j = 0; j <= i; ++j)
                normal(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) +=
                    a * problem.columns[free[j]][k] * scale[j];
        }
    }
    normal = Eigen::MatrixXd(normal.selfadjointView<Eigen::Lower>());
    LinearFit fit;
    fit.free = free;
    fit.numbers.assign(problem.columns.size(), 0.0);
    if (size > 0) {
        const Eigen::LDLT<Eigen::MatrixXd> solver(normal);
        if (!(solver.vectorD().minCoeff() > 1e-11)) return std::nullopt;
        const Eigen::VectorXd solved = solver.solve(right);
        fit.inverse = solver.solve(Eigen::MatrixXd(Eigen::MatrixXd::Identity(size, size)));
        for (std::size_t i = 0; i < free.size(); ++i) {
            fit.numbers[free[i]] = solved(static_cast<Eigen::Index>(i)) * scale[i];
            for (std::size_t j = 0; j < free.size(); ++j)
                fit.inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) *= scale[i] * scale[j];
        }
    }
    fit.squares = 0.0;
    for (std::size_t k = 0; k < points; ++k) {
        double left = problem.wanted[k];
        for (const std::size_t j : free)
            left -= fit.numbers[j] * problem.columns[j][k];
        fit.squares += left * left;
    }
    return fit;
}

std::vector<std::size_t> chosen_numbers(std::size_t set, std::size_t count) {
    std::vector<std::size_t> free;
    for (std::size_t j = 0; j < count; ++j)
        if ((set >> j & 1U) != 0) free.push_back(j);
    return free;
}

// the least sum of squares whose numbers are all at least zero
LinearFit bounded_fit(const LinearProblem& problem) {
    LinearFit best;
    const std::size_t count = problem.columns.size();
    for (std::size_t set = 1; set < (std::size_t{1} << count); ++set) {
        const std::optional<LinearFit> fit = fit_of(problem, chosen_numbers(set, count));
        if (!fit || fit->squares >= best.squares) continue;
        if (std::all_of(fit->numbers.begin(), fit->numbers.end(), [](double x) { return x >= 0.0; })) best = *fit;
    }
    return best;
}

double falling_share(const LawForm& form, double speed, double velocity) {
    const double x = form.exponent == 1.0 ? speed / velocity : (speed / velocity) * (speed / velocity);
    return fitted_kinds[form.kind] == FrictionKind::stribeck ? std::exp(-x) : 1.0 / (1.0 + x);
}

double hat(const std::vector<double>& knots, std::size_t at, double speed) {
    if (at > 0 && speed < knots[at])
        return speed <= knots[at - 1] ? 0.0 : (speed - knots[at - 1]) / (knots[at] - knots[at - 1]);
    if (at + 1 < knots.size() && speed > knots[at])
        return speed >= knots[at + 1] ? 0.0 : (knots[at + 1] - speed) / (knots[at + 1] - knots[at]);
    return 1.0;
}

template <typename Value>
std::vector<double> column(const std::vector<FrictionPoint>& points, Value value) {
    std::vector<double> result;
    for (const FrictionPoint& point : points) {
        double sum = 0.0;
        for (const double speed : point.speeds)
            sum += value(speed);
        result.push_back(0.25 * sum);
    }
    return result;
}

LinearProblem problem_of(const LawForm& form, const PointSet& set, double velocity) {
    LinearProblem problem;
    for (const FrictionPoint& point : set.points)
        problem.wanted.push_back(point.friction);
    const auto add = [&](auto value) { problem.columns.push_back(column(set.points, value)); };
    for (std::size_t k = 0; k < form.knots.size(); ++k)
        add([&](double w) { return hat(form.knots, k, w); });
    if (!form.knots.empty()) return problem;
    add([](double) { return 1.0; });
    if (form.has_velocity) add([&](double w) { return falling_share(form, w, velocity); });
    if (form.has_viscous) add([](double w) { return w; });
    if (fitted_kinds[form.kind] == FrictionKind::linear) add([](double w) { return -w; });
    return problem;
}

LinearFit fit_at(const LawForm& form, const PointSet& set, double velocity) {
    const LinearProblem problem = problem_of(form, set, velocity);
    if (form.knots.empty()) return bounded_fit(problem);
    std::vector<std::size_t> all =
        chosen_numbers((std::size_t{1} << problem.columns.size()) - 1, problem.columns.size());
    return fit_of(problem, all).value_or(LinearFit{});
}

// [m/s] from far below the slowest speed to far beyond the fastest, evenly in its logarithm
double tried_velocity(const PointSet& set, std::size_t k) {
    const double from = 0.1 * set.slowest, to = 10.0 * set.fastest;
    return from * std::pow(to / from, static_cast<double>(k) / static_cast<double>(velocities_tried - 1));
}

// [m/s] where the sum of squares crosses the limit, away from the best v_s; 0 or infinite where it never does
double velocity_end(const FittedForm& fitted, const PointSet& set, double squares, bool upwards) {
    const auto is_inside = [&](double velocity) { return fit_at(fitted.form, set, velocity).squares <= squares; };
    double inside = fitted.velocity, outside = 0.0;
    for (std::size_t k = 0; k < velocities_tried; ++k) {
        const double v = tried_velocity(set, upwards ? velocities_tried - 1 - k : k);
        if (upwards ? v <= inside : v >= inside) break;
        if (is_inside(v)) {
            inside = v;
            break;
        }
        outside = v;
    }
    if (outside == 0.0) return upwards ? open_end : 0.0;
    for (int turn = 0; turn < 40; ++turn) {
        const double middle = std::sqrt(inside * outside);
        (is_inside(middle) ? inside : outside) = middle;
    }
    return inside;
}

// the numbers of the laws, and their fields
constexpr std::array<std::pair<double parameters::Contact::*, std::string_view>, 6> number_fields{
    {{&parameters::Contact::static_friction, "contact.static_friction"},
     {&parameters::Contact::kinetic_friction, "contact.kinetic_friction"},
     {&parameters::Contact::friction_slope, "contact.friction_slope"},
     {&parameters::Contact::stribeck_velocity, "contact.stribeck_velocity"},
     {&parameters::Contact::stribeck_exponent, "contact.stribeck_exponent"},
     {&parameters::Contact::viscous_friction, "contact.viscous_friction"}}};

}  // namespace

FittedNumber number_called(double parameters::Contact::*member, double value, std::pair<double, double> interval) {
    const auto* const found = std::find_if(number_fields.begin(), number_fields.end(),
                                           [&](const auto& each) { return each.first == member; });
    return {member, parameters::find_field(found->second), value, std::min(interval.first, value),
            std::max(interval.second, value)};
}

double akaike(double squares, double points, double numbers) {
    const double k = numbers + 1.0;  // the deviation is one, too
    if (points - k - 1.0 <= 0.0) return open_end;
    return points * std::log(squares / points) + 2.0 * k + 2.0 * k * (k + 1.0) / (points - k - 1.0);
}

FittedForm best_form(const LawForm& form, const PointSet& set) {
    FittedForm best;
    best.form = form;
    if (!form.has_velocity) {
        best.fit = fit_at(form, set, 1.0);
        return best;
    }
    std::size_t place = 0;
    for (std::size_t k = 0; k < velocities_tried; ++k) {
        LinearFit fit = fit_at(form, set, tried_velocity(set, k));
        if (fit.squares >= best.fit.squares) continue;
        best.fit = std::move(fit);
        best.velocity = tried_velocity(set, k);
        place = k;
    }
    // golden section in the logarithm, between the neighbours
    double from = std::log(tried_velocity(set, place == 0 ? 0 : place - 1));
    double to = std::log(tried_velocity(set, std::min(place + 1, velocities_tried - 1)));
    constexpr double golden = 0.6180339887498949;
    double left = to - golden * (to - from), right = from + golden * (to - from);
    LinearFit at_left = fit_at(form, set, std::exp(left)), at_right = fit_at(form, set, std::exp(right));
    for (int turn = 0; turn < 40; ++turn) {
        const bool goes_left = at_left.squares < at_right.squares;
        const LinearFit& better = goes_left ? at_left : at_right;
        if (better.squares < best.fit.squares) {
            best.fit = better;
            best.velocity = std::exp(goes_left ? left : right);
        }
        if (goes_left) {
            to = std::exchange(right, left);
            at_right = at_left;
            left = to - golden * (to - from);
            at_left = fit_at(form, set, std::exp(left));
        } else {
            from = std::exchange(left, right);
            at_left = at_right;
            right = from + golden * (to - from);
            at_right = fit_at(form, set, std::exp(right));
        }
    }
    return best;
}

std::vector<double> residuals_of(const FittedForm& fitted, const PointSet& set) {
    const LinearProblem problem = problem_of(fitted.form, set, fitted.velocity);
    std::vector<double> residuals = problem.wanted;
    for (std::size_t j = 0; j < problem.columns.size(); ++j)
        for (std::size_t k = 0; k < residuals.size(); ++k)
            residuals[k] -= fitted.fit.numbers[j] * problem.columns[j][k];
    return residuals;
}

// quantile 0.975 of Student's t: Hill 1970 as an expansion, better than 1e-3 from three degrees of freedom on
double student_975(double degrees) {
    constexpr double z = 1.959963984540054;
    const double n = std::max(degrees, 1.0), z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z, z9 = z7 * z * z;
    if (n < 1.5) return 12.706;
    if (n < 2.5) return 4.303;
    return z + (z3 + z) / (4.0 * n) + (5.0 * z5 + 16.0 * z3 + 3.0 * z) / (96.0 * n * n) +
           (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / (384.0 * n * n * n) +
           (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z) / (92160.0 * n * n * n * n);
}

std::pair<double, double> velocities_within(const FittedForm& fitted, const PointSet& set, double squares) {
    if (!fitted.form.has_velocity) return {0.0, open_end};
    return {velocity_end(fitted, set, squares, false), velocity_end(fitted, set, squares, true)};
}

std::pair<double, double> values_within(const FittedForm& fitted, const PointSet& set, double squares,
                                        const std::vector<std::size_t>& sum) {
    const std::pair<double, double> velocities = velocities_within(fitted, set, squares);
    std::pair<double, double> interval{open_end, 0.0};
    const std::size_t steps = fitted.form.has_velocity ? velocities_tried : 1;
    const double from = std::max(velocities.first, 0.1 * set.slowest),
                 to = std::min(velocities.second, 10.0 * set.fastest);
    for (std::size_t step = 0; step <= steps; ++step) {
        const double velocity =
            !fitted.form.has_velocity || step == steps || !(from < to)
                ? fitted.velocity
                : from * std::pow(to / from, static_cast<double>(step) / static_cast<double>(steps - 1));
        const LinearProblem problem = problem_of(fitted.form, set, velocity);
        std::vector<std::size_t> free = fit_at(fitted.form, set, velocity).free;
        free.insert(free.end(), sum.begin(), sum.end());
        std::sort(free.begin(), free.end());
        free.erase(std::unique(free.begin(), free.end()), free.end());
        const std::optional<LinearFit> fit = fit_of(problem, free);
        if (!fit || fit->squares > squares) continue;
        double centre = 0.0, variance = 0.0;
        for (const std::size_t i : sum) {
            centre += fit->numbers[i];
            for (const std::size_t j : sum) {
                const auto place = [&](std::size_t number) {
                    return std::find(free.begin(), free.end(), number) - free.begin();
                };
                variance += fit->inverse(place(i), place(j));
            }
        }
        const double half = std::sqrt(std::max(0.0, (squares - fit->squares) * variance));
        interval.first = std::min(interval.first, std::max(0.0, centre - half));
        interval.second = std::max(interval.second, centre + half);
    }
    // beyond any friction: the data do not bound it
    if (interval.second > most_friction) interval.second = open_end;
    return interval;
}

}  // namespace stridor::analysis
