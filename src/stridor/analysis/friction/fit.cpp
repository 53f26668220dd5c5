#include "stridor/analysis/friction/fit.hpp"

#include "stridor/analysis/friction/joint_fit.hpp"
#include "stridor/analysis/friction/regression.hpp"
#include "stridor/analysis/friction/slip_fit.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/model/laws/friction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::analysis {

namespace {

using parameters::Contact;
using parameters::FrictionKind;

constexpr std::size_t most_table_rows = 8;
constexpr std::size_t fewest_joint_points = 4;
constexpr double likelier_difference = 2.0;  // [1] of Akaike's criterion: below it no law is the likelier one
constexpr double same_speed = 0.02;          // [1] speeds that differ less are one
constexpr double least_relative = 1e-9;      // [1] of the level: deviations below are rounding

// [1] by how much the variance of a mean grows because the means of neighbouring blocks are alike. What the
// line of hats takes out lowers it by one over the points per row.
double neighbour_effect(const PointSet& set, const std::vector<double>& residuals, std::size_t knots) {
    double products = 0.0, squares = 0.0, pairs = 0.0, runs = 0.0;
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        squares += residuals[k] * residuals[k];
        if (k == 0 || set.points[k - 1].run != set.points[k].run) {
            runs += 1.0;
            continue;
        }
        products += residuals[k] * residuals[k - 1];
        pairs += 1.0;
    }
    if (!(pairs > 0.0) || !(squares > 0.0)) return 1.0;
    const double taken_out = std::max(runs, static_cast<double>(knots)) / (pairs + runs);
    const double alike = products / pairs / (squares / (pairs + runs)) + taken_out;
    return 1.0 + 2.0 * std::clamp(alike, 0.0, 1.0);
}

// --- a law of its form

// of laws whose mu_s is no part of the curve: that of the peaks, or of what a slip begins with
void add_static(std::vector<FittedNumber>& numbers, const FrictionPoints& data, const FittedNumber& kinetic) {
    const MeasuredCoefficient& seen = data.static_friction;
    FittedNumber number = number_called(&Contact::static_friction, kinetic.value, {kinetic.from, kinetic.to});
    if (seen.count > 0 && seen.value > kinetic.value) {
        const double half =
            std::isfinite(seen.uncertainty) ? student_975(static_cast<double>(seen.count) - 1.0) * seen.uncertainty : 0;
        number =
            number_called(&Contact::static_friction, seen.value, {std::max(0.0, seen.value - half), seen.value + half});
    }
    numbers.insert(numbers.begin(), number);
}

Contact contact_of(const FittedForm& fitted, const std::vector<FittedNumber>& numbers) {
    Contact contact;
    contact.static_friction = contact.kinetic_friction = 0.0;
    contact.friction = fitted_kinds[fitted.form.kind];
    for (const FittedNumber& number : numbers)
        contact.*number.member = number.value;
    contact.static_friction = std::max(contact.static_friction, contact.kinetic_friction);
    if (contact.friction != FrictionKind::table) return contact;
    contact.interpolation = parameters::Interpolation::linear;
    for (std::size_t k = 0; k < fitted.form.knots.size(); ++k) {
        const double friction = std::max(0.0, fitted.fit.numbers[k]);
        if (k == 0 && fitted.form.knots[0] > 0.0) {
            contact.friction_table.speeds.push_back(0.0);
            contact.friction_table.coefficients.push_back(friction);
        }
        contact.friction_table.speeds.push_back(fitted.form.knots[k]);
        contact.friction_table.coefficients.push_back(friction);
        contact.static_friction = std::max(contact.static_friction, friction);
    }
    contact.kinetic_friction = contact.friction_table.coefficients.back();
    return contact;
}

// delta is a number of the law as the others are: an interval holds the values that either delta allows
using Siblings = std::vector<FittedForm>;

FittedLaw law_of(const FittedForm& fitted, const Siblings& siblings, const PointSet& set, const FrictionPoints& data,
                 double effect) {
    FittedLaw law;
    law.kind = fitted.form.kind;
    law.free_numbers = fitted.free_numbers;
    law.criterion = fitted.criterion;
    law.residuals = residuals_of(fitted, set);
    const auto points = static_cast<double>(set.points.size());
    double squares = 0.0;
    for (const double residual : law.residuals)
        squares += residual * residual;
    law.deviation = std::sqrt(squares / points);
    const double numbers = static_cast<double>(fitted.free_numbers);
    const double variance = fitted.fit.squares / std::max(1.0, points - numbers);
    const double t = student_975(points / effect - numbers);
    const double limit = fitted.fit.squares + variance * effect * t * t;
    const std::vector<double>& beta = fitted.fit.numbers;
    const auto over_siblings = [&](auto range) {
        std::pair<double, double> all{open_end, 0.0};
        for (const FittedForm& sibling : siblings) {
            if (sibling.form.has_viscous != fitted.form.has_viscous || sibling.fit.squares > limit) continue;
            const std::pair<double, double> own = range(sibling);
            all = {std::min(all.first, own.first), std::max(all.second, own.second)};
        }
        return all;
    };
    const auto interval = [&](const std::vector<std::size_t>& sum) {
        return over_siblings([&](const FittedForm& form) { return values_within(form, set, limit, sum); });
    };
    switch (fitted_kinds[law.kind]) {
        case FrictionKind::stribeck:
        case FrictionKind::stribeck_rational:
            law.numbers = {
                number_called(&Contact::static_friction, beta[0] + beta[1], interval({0, 1})),
                number_called(&Contact::kinetic_friction, beta[0], interval({0})),
                number_called(&Contact::stribeck_velocity, fitted.velocity, over_siblings([&](const FittedForm& form) {
                    return velocities_within(form, set, limit);
                })),
                number_called(&Contact::stribeck_exponent, fitted.form.exponent,
                              over_siblings([](const FittedForm& form) {
                                  return std::pair{form.form.exponent, form.form.exponent};
                              }))};
            if (fitted.form.has_viscous)
                law.numbers.push_back(number_called(&Contact::viscous_friction, beta[2], interval({2})));
            break;
        case FrictionKind::table: {
            const FittedNumber first = number_called(&Contact::kinetic_friction, beta[0], {beta[0], beta[0]});
            add_static(law.numbers, data, first);
            break;
        }
        default:
            law.numbers = {number_called(&Contact::kinetic_friction, beta[0], interval({0}))};
            if (fitted_kinds[law.kind] == FrictionKind::linear)
                law.numbers.push_back(number_called(&Contact::friction_slope, beta[1], interval({1})));
            add_static(law.numbers, data, law.numbers.front());
    }
    law.contact = contact_of(fitted, law.numbers);
    return law;
}

// --- which can be fitted

std::vector<double> different_speeds(const std::vector<FrictionPoint>& points) {
    std::vector<double> speeds;
    for (const FrictionPoint& point : points)
        for (const double speed : point.speeds)
            speeds.push_back(speed);
    std::sort(speeds.begin(), speeds.end());
    std::vector<double> different;
    for (const double speed : speeds)
        if (different.empty() ||
            speed > different.back() + same_speed * speeds.back() * 0.1 + same_speed * different.back())
            different.push_back(speed);
    return different;
}

// [m/s] the speeds themselves if they are few, else quantiles of the points' speeds
std::vector<double> knots_of(const std::vector<FrictionPoint>& points, const std::vector<double>& different) {
    std::vector<double> speeds;
    for (const FrictionPoint& point : points)
        speeds.push_back(mean_speed(point));
    std::sort(speeds.begin(), speeds.end());
    std::vector<double> knots;
    if (different.size() <= most_table_rows) {
        // the mean of the points near each
        for (std::size_t from = 0; from < speeds.size();) {
            std::size_t to = from;
            double sum = 0.0;
            for (; to < speeds.size() &&
                   speeds[to] <= speeds[from] * (1.0 + 2.0 * same_speed) + same_speed * 0.1 * speeds.back();
                 ++to)
                sum += speeds[to];
            knots.push_back(sum / static_cast<double>(to - from));
            from = to;
        }
        return knots;
    }
    const std::size_t rows = std::min(most_table_rows, std::max<std::size_t>(2, speeds.size() / 4));
    for (std::size_t k = 0; k < rows; ++k) {
        const double speed = speeds[k * (speeds.size() - 1) / (rows - 1)];
        if (knots.empty() || speed > knots.back()) knots.push_back(speed);
    }
    return knots;
}

std::size_t numbers_of(const LawForm& form) {
    if (form.has_velocity) return form.has_viscous ? 4 : 3;
    if (!form.knots.empty()) return form.knots.size();
    return fitted_kinds[form.kind] == FrictionKind::linear ? 2 : 1;
}

std::vector<LawForm> forms_of(std::size_t kind, const std::vector<double>& knots, std::optional<double> exponent) {
    switch (fitted_kinds[kind]) {
        case FrictionKind::stribeck:
        case FrictionKind::stribeck_rational:
            if (exponent) return {{kind, *exponent, true, false}, {kind, *exponent, true, true}};
            return {
                {kind, 1.0, true, false}, {kind, 2.0, true, false}, {kind, 1.0, true, true}, {kind, 2.0, true, true}};
        case FrictionKind::table:
            return {{kind, 1.0, false, false, knots}};
        default:
            return {{kind}};
    }
}

PointSet point_set(const std::vector<FrictionPoint>& points) {
    PointSet set{points, 0.0, open_end, 0.0};
    for (const FrictionPoint& point : points) {
        set.level = std::max(set.level, std::abs(point.friction));
        for (const double speed : point.speeds) {
            set.fastest = std::max(set.fastest, speed);
            if (speed > 0.0) set.slowest = std::min(set.slowest, speed);
        }
    }
    // slips pass through all speeds down to zero
    set.slowest = std::max(set.slowest, 1e-3 * set.fastest);
    return set;
}

// a run with stick-slip whose rig is not known has Coulomb's numbers
FrictionFit coulomb_of_slips(FrictionPoints data) {
    FrictionFit fit;
    const MeasuredCoefficient kinetic = data.kinetic_friction;
    const double half = student_975(static_cast<double>(kinetic.count) - 1.0) * kinetic.uncertainty;
    FittedLaw law;
    law.numbers = {number_called(&Contact::kinetic_friction, kinetic.value,
                                 {std::max(0.0, kinetic.value - half), kinetic.value + half})};
    add_static(law.numbers, data, law.numbers.front());
    law.contact.static_friction = law.numbers[0].value;
    law.contact.kinetic_friction = law.numbers[1].value;
    law.free_numbers = 2;
    law.deviation = kinetic.uncertainty * std::sqrt(static_cast<double>(kinetic.count));
    fit.independent = static_cast<double>(kinetic.count);
    fit.laws.push_back(std::move(law));
    for (std::size_t kind = 1; kind < fitted_kinds.size(); ++kind)
        fit.unfitted.push_back({kind, "the runs have stick-slip, and the rig is not known (--mass, --stiffness)"});
    fit.data = std::move(data);
    return fit;
}

std::string name_of(const FrictionFit& fit, std::size_t law) {
    return std::string(fitted_names[fit.laws[law].kind]);
}

std::string names_of(const FrictionFit& fit, const std::vector<std::size_t>& laws) {
    std::string text;
    for (std::size_t k = 0; k < laws.size(); ++k)
        text += (k == 0 ? "" : k + 1 == laws.size() ? " and " : ", ") + name_of(fit, laws[k]);
    return text;
}

// [1] the number of points over that of independent ones, by what a table leaves of them
double dependence_of(const PointSet& set, const std::vector<double>& knots) {
    if (knots.size() >= set.points.size()) return 1.0;
    const FittedForm table = best_form({fitted_kinds.size() - 1, 1.0, false, false, knots}, set);
    return table.fit.numbers.empty() ? 1.0 : neighbour_effect(set, residuals_of(table, set), knots.size());
}

// all forms of a law that the points can bear; `why` is told where there are too few speeds
Siblings forms_fitted(const std::vector<LawForm>& forms, const PointSet& set, const FrictionFit& fit,
                      std::string& why) {
    Siblings fitted_forms;
    const auto points = static_cast<double>(set.points.size());
    for (const LawForm& form : forms) {
        const std::size_t numbers = numbers_of(form);
        const bool is_table = form.kind + 1 == fitted_kinds.size();
        if (numbers > fit.speeds || (is_table && form.knots.size() < 2)) {
            if (why.empty())
                why = "its " + std::to_string(std::max<std::size_t>(numbers, 2)) +
                      " numbers need as many speeds of slip; the runs have " + std::to_string(fit.speeds);
            continue;
        }
        FittedForm fitted = best_form(form, set);
        if (!std::isfinite(fitted.fit.squares)) continue;
        fitted.fit.squares =
            std::max(fitted.fit.squares, points * least_relative * least_relative * set.level * set.level);
        fitted.free_numbers = numbers;
        fitted.criterion =
            akaike(fitted.fit.squares * fit.independent / points, fit.independent, static_cast<double>(numbers));
        fitted_forms.push_back(std::move(fitted));
    }
    return fitted_forms;
}

// of forms that are not told apart the one with the fewest numbers: k_v is taken where the data show it
const FittedForm* simplest_of(const Siblings& forms) {
    double least = open_end;
    for (const FittedForm& form : forms)
        least = std::min(least, form.criterion);
    const FittedForm* best = nullptr;
    for (const FittedForm& form : forms)
        if (form.criterion < least + telling_difference &&
            (best == nullptr ||
             std::pair(form.free_numbers, form.criterion) < std::pair(best->free_numbers, best->criterion)))
            best = &form;
    return best;
}

}  // namespace

void choose_law(FrictionFit& fit) {
    double least = open_end;
    for (const FittedLaw& law : fit.laws)
        least = std::min(least, law.criterion);
    const auto is_simpler = [&](std::size_t a, std::size_t b) {
        const FittedLaw &one = fit.laws[a], &other = fit.laws[b];
        return one.free_numbers != other.free_numbers ? one.free_numbers < other.free_numbers
                                                      : one.criterion < other.criterion;
    };
    std::vector<std::size_t> good;
    for (std::size_t k = 0; k < fit.laws.size(); ++k) {
        fit.laws[k].difference = fit.laws[k].criterion - least;
        if (fit.laws[k].difference < telling_difference) good.push_back(k);
    }
    fit.best = *std::min_element(good.begin(), good.end(), is_simpler);
    for (const std::size_t k : good)
        if (k != fit.best)
            (fit.laws[k].free_numbers > fit.laws[fit.best].free_numbers ? fit.richer : fit.rivals).push_back(k);
}

FrictionFit friction_fit(FrictionPoints data, const std::optional<MeasuringRig>& rig, std::optional<double> exponent) {
    if (rig && data.slips.size() >= fewest_slips) {
        const bool has_both = data.points.size() >= fewest_joint_points;
        if (!has_both) data.points.clear();
        FrictionFit fit =
            has_both ? fit_of_both(std::move(data), *rig, exponent) : fit_of_slips(std::move(data), *rig, exponent);
        choose_law(fit);
        return fit;
    }
    if (data.points.empty() && data.kinetic_friction.count > 0) return coulomb_of_slips(std::move(data));
    if (data.points.size() < 4)
        base::refuse("the runs give " + std::to_string(data.points.size()) + " independent means of friction",
                     "a fit needs 4 at least", "Measure for a longer time, or at more speeds.");
    FrictionFit fit;
    fit.data = std::move(data);
    const PointSet set = point_set(fit.data.points);
    const std::vector<double> different = different_speeds(fit.data.points);
    const std::vector<double> knots = knots_of(fit.data.points, different);
    fit.speeds = different.size();
    const double effect = dependence_of(set, knots);
    fit.independent = static_cast<double>(set.points.size()) / effect;
    for (std::size_t kind = 0; kind < fitted_kinds.size(); ++kind) {
        std::string why;
        const Siblings forms = forms_fitted(forms_of(kind, knots, exponent), set, fit, why);
        if (const FittedForm* best = simplest_of(forms))
            fit.laws.push_back(law_of(*best, forms, set, fit.data, effect));
        else
            fit.unfitted.push_back({kind, why.empty() ? "too few independent points for its numbers" : why});
    }
    if (fit.laws.empty())
        base::refuse("no law can be fitted to " + std::to_string(set.points.size()) + " points",
                     fit.unfitted.front().why, "Measure for a longer time, or at more speeds.");
    choose_law(fit);
    return fit;
}

std::size_t law_called(const FrictionFit& fit, std::string_view name) {
    for (std::size_t k = 0; k < fit.laws.size(); ++k)
        if (fitted_names[fit.laws[k].kind] == name) return k;
    for (const UnfittedLaw& law : fit.unfitted)
        if (fitted_names[law.kind] == name)
            base::refuse("the law " + std::string(name) + " cannot be fitted", law.why,
                         "Add runs at other speeds, or ask for --fit best.");
    base::refuse("there is no law " + std::string(name), "", "");
}

std::string words_of(const FrictionFit& fit) {
    const std::string best = name_of(fit, fit.best);
    std::string text = fit.rivals.empty() ? "The data bear " + best + "."
                                          : "The data do not tell " + best + " from " + names_of(fit, fit.rivals) + ".";
    const bool is_likelier = std::all_of(fit.rivals.begin(), fit.rivals.end(), [&](std::size_t rival) {
        return fit.laws[rival].criterion > fit.laws[fit.best].criterion + likelier_difference;
    });
    if (!fit.rivals.empty() && is_likelier) text += " They speak rather for " + best + ".";
    if (!fit.richer.empty())
        text += " " + names_of(fit, fit.richer) + (fit.richer.size() == 1 ? " fits" : " fit") +
                " them no better with more numbers.";
    if (fitted_kinds[fit.laws[fit.best].kind] == FrictionKind::table) text += " No formula describes them as well.";
    return text;
}

double friction_at(const FittedLaw& law, const FrictionPoint& point) {
    const model::FrictionLaw friction = model::friction_law(law.contact);
    double sum = 0.0;
    for (const double speed : point.speeds)
        sum += model::slip_ratio(friction, model::Slip::backward, -speed);
    return 0.25 * sum;
}

}  // namespace stridor::analysis
