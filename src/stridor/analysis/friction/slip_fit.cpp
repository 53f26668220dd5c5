// Each law is fitted from first guesses of v_s that lie a decade apart, and with delta 1 and 2. The intervals come from
// the influences of the slips (friction_slip_regression.cpp), those of v_s and the rig by their logarithm.

#include "stridor/analysis/friction/slip_fit.hpp"

#include "stridor/analysis/friction/regression.hpp"
#include "stridor/analysis/friction/slip_regression.hpp"
#include "stridor/analysis/friction/stretches.hpp"
#include "stridor/model/laws/friction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace stridor::analysis {

namespace {

using parameters::Contact;
using parameters::FrictionKind;

constexpr std::size_t most_slips = 200;
constexpr int most_slip_steps = 40;
constexpr int first_steps = 10;           // from each first guess
constexpr double exponents_alike = 3.84;  // [1] difference of criteria below which either delta may be: chi^2 of 95 %

struct SlipLaw {
    SlipModel model{};
    SlipFit fit{};
    double independent = 0.0;
    double criterion = open_end;
    std::vector<FittedNumber> numbers;
    std::vector<RigNumber> rig;
    std::vector<double> covariance;  // of mu_s, then mu_d, s_mu and ln v_s, shape [number][number]
};

// by how much the variance of a mean grows because neighbouring samples of a slip are alike
double samples_alike(const std::vector<std::vector<double>>& residuals) {
    double squares = 0.0, sum = 1.0;
    for (const std::vector<double>& slip : residuals)
        for (const double r : slip)
            squares += r * r;
    for (std::size_t lag = 1; lag < 32; ++lag) {
        double products = 0.0;
        for (const std::vector<double>& slip : residuals)
            for (std::size_t k = lag; k < slip.size(); ++k)
                products += slip[k] * slip[k - lag];
        if (!(products > 0.0)) break;
        sum += 2.0 * products / squares;
    }
    return sum;
}

std::pair<double, double> end_values(double value, double half) {
    return {std::max(0.0, value - half), value + half};
}

void set_numbers(SlipLaw& law, const std::vector<RecordedSlip>& slips, const SlipDeviations& found) {
    const auto count = static_cast<double>(slips.size());
    const double freedom = count - 1.0 - static_cast<double>(law.fit.shape.size());
    const double t = student_975(freedom);
    const auto half = [&](const Eigen::VectorXd& pulls) {
        return t * std::sqrt(count / freedom * pulls.squaredNorm());
    };
    const double mu_s = found.ratios.mean();
    law.numbers = {number_called(&Contact::static_friction, mu_s, end_values(mu_s, half(found.limits)))};
    std::vector<Eigen::VectorXd> pulls{found.limits};
    for (std::size_t k = 0; k < law.fit.shape.size(); ++k) {
        const double value = law.fit.shape[k];
        const Eigen::VectorXd own = found.shape.col(static_cast<Eigen::Index>(k));
        const double width = half(own), scaled = half(mu_s * own + value * found.limits);
        const std::pair<double, double> around{std::exp(value - width), std::exp(value + width)};
        switch (law.model.numbers[k]) {
            case ShapeNumber::ratio:
                pulls.push_back(mu_s * own + value * found.limits);
                law.numbers.push_back(
                    number_called(&Contact::kinetic_friction, value * mu_s, end_values(value * mu_s, scaled)));
                break;
            case ShapeNumber::slope:
                pulls.push_back(mu_s * own + value * found.limits);
                law.numbers.push_back(
                    number_called(&Contact::friction_slope, value * mu_s, end_values(value * mu_s, scaled)));
                break;
            case ShapeNumber::velocity:
                pulls.push_back(own);
                law.numbers.push_back(number_called(&Contact::stribeck_velocity, std::exp(value), around));
                law.numbers.push_back(number_called(&Contact::stribeck_exponent, law.model.exponent,
                                                    {law.model.exponent, law.model.exponent}));
                break;
            case ShapeNumber::stiffness:
                law.rig.push_back({"stiffness", "k", "N/m", std::exp(value), around.first, around.second});
                break;
            case ShapeNumber::mass:
                law.rig.push_back({"mass", "m", "kg", std::exp(value), around.first, around.second});
        }
    }
    for (const Eigen::VectorXd& a : pulls)
        for (const Eigen::VectorXd& b : pulls)
            law.covariance.push_back(count / freedom * a.dot(b));
}

// --- each law

double median_of(const std::vector<RecordedSlip>& slips, double (*value)(const RecordedSlip&)) {
    std::vector<double> values;
    for (const RecordedSlip& slip : slips)
        values.push_back(value(slip));
    return quantile(std::move(values), 0.5);
}

// [N]
double drop_of(const RecordedSlip& slip) {
    return slip.limit - *std::min_element(slip.force.begin(), slip.force.end());
}

// what is not known of the rig, by the climb and the time of a slip: half a swing
MeasuringRig first_rig(const std::vector<RecordedSlip>& slips, MeasuringRig rig) {
    if (std::isnan(rig.stiffness))
        rig.stiffness = median_of(slips, [](const RecordedSlip& slip) { return slip.climb / slip.velocity; });
    if (std::isnan(rig.mass)) {
        const double time = median_of(slips, [](const RecordedSlip& slip) {
            return static_cast<double>(slip.force.size() - 1) / slip.rate - slip.onset;
        });
        rig.mass = rig.stiffness * (time / std::numbers::pi) * (time / std::numbers::pi);
    }
    return rig;
}

bool is_stribeck(FrictionKind kind) {
    return kind == FrictionKind::stribeck || kind == FrictionKind::stribeck_rational;
}

SlipModel slip_model(const std::vector<RecordedSlip>& slips, const MeasuringRig& rig, FrictionKind kind,
                     double exponent) {
    SlipModel model{kind, exponent, first_rig(slips, rig), {ShapeNumber::ratio}};
    if (kind == FrictionKind::linear) model.numbers.push_back(ShapeNumber::slope);
    if (is_stribeck(kind)) model.numbers.push_back(ShapeNumber::velocity);
    if (std::isnan(rig.stiffness)) model.numbers.push_back(ShapeNumber::stiffness);
    if (std::isnan(rig.mass)) model.numbers.push_back(ShapeNumber::mass);
    return model;
}

std::vector<double> first_shape(const SlipModel& model, double stribeck_velocity) {
    std::vector<double> shape;
    for (const ShapeNumber number : model.numbers)
        shape.push_back(number == ShapeNumber::ratio       ? 0.7
                        : number == ShapeNumber::slope     ? 0.0
                        : number == ShapeNumber::velocity  ? std::log(stribeck_velocity)
                        : number == ShapeNumber::stiffness ? std::log(model.rig.stiffness)
                                                           : std::log(model.rig.mass));
    return shape;
}

SlipLaw slip_law(const std::vector<RecordedSlip>& slips, const MeasuringRig& rig, FrictionKind kind, double exponent) {
    SlipLaw law;
    law.model = slip_model(slips, rig, kind, exponent);
    // the way from a first guess is found with a few slips
    std::vector<RecordedSlip> some;
    for (std::size_t k = 0; k < slips.size(); k += slips.size() / fewest_slips)
        some.push_back(slips[k]);
    SlipFit near;
    // [m/s] about the fastest slip
    const double fastest = 0.5 * median_of(slips, drop_of) / std::sqrt(law.model.rig.stiffness * law.model.rig.mass);
    for (const double share : {0.04, 0.2, 1.0}) {
        SlipFit tried =
            refined(some, law.model, released(some, law.model, first_shape(law.model, share * fastest)), first_steps);
        if (tried.squares < near.squares) near = std::move(tried);
        if (!is_stribeck(kind)) break;
    }
    if (std::isinf(near.squares)) return law;
    law.fit = refined(slips, law.model, released(slips, law.model, near.shape), most_slip_steps);
    if (std::isinf(law.fit.squares)) return law;
    const SlipDeviations found = deviations_of(slips, law.model, law.fit);
    double samples = 0.0;
    for (const RecordedSlip& slip : slips)
        samples += static_cast<double>(slip.force.size()) - 2.0;
    law.independent = samples / samples_alike(found.residuals);
    set_numbers(law, slips, found);
    return law;
}

// evenly over the runs where there are many
std::vector<RecordedSlip> thinned(std::vector<RecordedSlip> slips) {
    if (slips.size() <= most_slips) return slips;
    std::vector<RecordedSlip> some;
    for (std::size_t k = 0; k < most_slips; ++k)
        some.push_back(std::move(slips[k * slips.size() / most_slips]));
    return some;
}

// what a fitted law is for the user
FittedLaw fitted_law(std::size_t kind, const std::vector<SlipLaw>& siblings, std::size_t best, double samples,
                     double load) {
    const SlipLaw& chosen = siblings[best];
    FittedLaw law;
    law.kind = kind;
    law.numbers = chosen.numbers;
    law.rig = chosen.rig;
    law.covariance = chosen.covariance;
    law.free_numbers = chosen.fit.shape.size() + 1;
    law.criterion = chosen.criterion;
    law.deviation = std::sqrt(chosen.fit.squares / samples) / load;
    for (const SlipLaw& each : siblings) {
        if (each.criterion > chosen.criterion + exponents_alike) continue;
        for (std::size_t k = 0; k < law.numbers.size(); ++k) {
            law.numbers[k].from = std::min(law.numbers[k].from, each.numbers[k].from);
            law.numbers[k].to = std::max(law.numbers[k].to, each.numbers[k].to);
        }
    }
    law.onsets = chosen.fit.onset;
    law.limits = chosen.fit.limit;
    law.moved_by = chosen.model.rig;
    for (std::size_t k = 0; k < chosen.fit.shape.size(); ++k) {
        if (chosen.model.numbers[k] == ShapeNumber::stiffness) law.moved_by.stiffness = std::exp(chosen.fit.shape[k]);
        if (chosen.model.numbers[k] == ShapeNumber::mass) law.moved_by.mass = std::exp(chosen.fit.shape[k]);
    }
    law.contact.friction = fitted_kinds[kind];
    for (const FittedNumber& number : law.numbers)
        law.contact.*number.member = number.value;
    law.contact.static_friction = std::max(law.contact.static_friction, law.contact.kinetic_friction);
    return law;
}

}  // namespace

FrictionFit fit_of_slips(FrictionPoints data, const MeasuringRig& rig, std::optional<double> only) {
    data.slips = thinned(std::move(data.slips));
    FrictionFit fit;
    fit.slips = data.slips.size();
    std::vector<std::vector<SlipLaw>> laws;
    double samples = 0.0, load = 0.0, least = open_end;
    for (const RecordedSlip& slip : data.slips) {
        samples += static_cast<double>(slip.force.size());
        load += slip.normal_force / static_cast<double>(data.slips.size());
    }
    for (std::size_t kind = 0; kind + 1 < fitted_kinds.size(); ++kind) {
        laws.emplace_back();
        for (const double exponent : {1.0, 2.0}) {
            if (exponent > 1.0 && !is_stribeck(fitted_kinds[kind])) continue;
            SlipLaw law = slip_law(data.slips, rig, fitted_kinds[kind], exponent);
            if (std::isinf(law.fit.squares) || law.numbers.empty()) continue;
            if (law.fit.squares < least) {
                least = law.fit.squares;
                fit.independent = law.independent;
            }
            laws.back().push_back(std::move(law));
        }
    }
    for (std::size_t kind = 0; kind < laws.size(); ++kind) {
        // both were fitted: how many samples are independent is the same whichever delta is asked for
        if (only && is_stribeck(fitted_kinds[kind]))
            std::erase_if(laws[kind], [&](const SlipLaw& law) { return law.model.exponent != *only; });
        std::size_t best = 0;
        for (std::size_t k = 0; k < laws[kind].size(); ++k) {
            SlipLaw& law = laws[kind][k];
            law.criterion = akaike(law.fit.squares * fit.independent / samples, fit.independent,
                                   static_cast<double>(law.fit.shape.size()) + 1.0);
            if (law.criterion < laws[kind][best].criterion) best = k;
        }
        if (laws[kind].empty())
            fit.unfitted.push_back({kind, "no motion of the rig with this law comes near the slips"});
        else
            fit.laws.push_back(fitted_law(kind, laws[kind], best, samples, load));
    }
    fit.unfitted.push_back({fitted_kinds.size() - 1, "a table needs runs of steady sliding"});
    fit.data = std::move(data);
    return fit;
}

std::vector<double> slip_force(const FrictionFit& fit, std::size_t law, std::size_t slip,
                               std::span<const double> since_release) {
    const FittedLaw& fitted = fit.laws[law];
    const RecordedSlip& recorded = fit.data.slips[slip];
    // the force at which it lets go has the level: the law's shape is left
    Contact shape = fitted.contact;
    const double mu_s = fitted.contact.static_friction;
    shape.static_friction = 1.0;
    shape.kinetic_friction /= mu_s;
    shape.friction_slope /= mu_s;
    const double swing = 2.0 * std::numbers::pi * std::sqrt(fitted.moved_by.mass / fitted.moved_by.stiffness);
    const SlipStart start{recorded.velocity, fitted.limits[slip], std::min(0.5 / recorded.rate, swing / 80.0)};
    return slip_track(model::friction_law(shape), fitted.moved_by, start, since_release).force;
}

}  // namespace stridor::analysis
