#include "stridor/analysis/friction/over_conditions.hpp"

#include "stridor/analysis/friction/regression.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::analysis {

namespace {

constexpr std::array fitted_exponents{1.0, 2.0};  // [1] delta

// the law of this kind; null where it was not fitted
const FittedLaw* law_of_kind(const FrictionFit& fit, std::size_t kind) {
    const auto found =
        std::find_if(fit.laws.begin(), fit.laws.end(), [&](const FittedLaw& law) { return law.kind == kind; });
    return found == fit.laws.end() ? nullptr : &*found;
}

// over all conditions; nothing where one of them has no such law
std::optional<FittedLaw> law_of_all(const std::vector<FrictionFit>& fits, std::size_t kind) {
    FittedLaw all;
    all.kind = kind;
    double squares = 0.0, independent = 0.0;
    for (const FrictionFit& fit : fits) {
        const FittedLaw* law = law_of_kind(fit, kind);
        if (law == nullptr) return std::nullopt;
        all.contact.friction = law->contact.friction;
        all.criterion += law->criterion;
        all.free_numbers += law->free_numbers;
        squares += fit.independent * law->deviation * law->deviation;
        independent += fit.independent;
    }
    all.deviation = std::sqrt(squares / independent);
    return all;
}

std::string why_not(const FrictionOverConditions& over, std::size_t kind) {
    for (std::size_t k = 0; k < over.conditions.size(); ++k)
        for (const UnfittedLaw& each : over.fits[0][k].unfitted)
            if (each.kind == kind) return over.conditions[k] + " " + each.why;
    return "";
}

FrictionPoints joined(const std::vector<FrictionFit>& fits) {
    FrictionPoints all;
    for (const FrictionFit& fit : fits) {
        all.points.insert(all.points.end(), fit.data.points.begin(), fit.data.points.end());
        if (fit.data.static_friction.count > all.static_friction.count) all.static_friction = fit.data.static_friction;
    }
    return all;
}

// both criteria are those of all points, as independent as they are at each condition
double gain_of(const FrictionOverConditions& over) {
    const FittedLaw& own = over.whole.laws[over.whole.best];
    const std::size_t exponent = over.exponents[over.whole.best];
    double independent = 0.0;
    for (const FrictionFit& fit : over.fits[exponent]) {
        if (fit.data.points.empty() || fit.slips > 0) return std::numeric_limits<double>::quiet_NaN();
        independent += fit.independent;
    }
    const FrictionFit common = friction_fit(joined(over.fits[exponent]), {}, fitted_exponents[exponent]);
    const FittedLaw* one = law_of_kind(common, own.kind);
    if (one == nullptr) return std::numeric_limits<double>::quiet_NaN();
    const auto criterion = [&](const FittedLaw& law) {
        return akaike(independent * law.deviation * law.deviation, independent, static_cast<double>(law.free_numbers));
    };
    return criterion(*one) - criterion(own);
}

// an error says at which condition
FrictionFit fit_at(const FrictionAtCondition& runs, const std::optional<MeasuringRig>& rig, double exponent) {
    try {
        return friction_fit(runs.data, rig, exponent);
    } catch (const Error& error) {
        base::Problem problem = error.problem();
        problem.what = runs.condition + " " + problem.what;
        throw Error(error.kind(), problem);
    }
}

}  // namespace

FrictionOverConditions friction_over_conditions(const std::vector<FrictionAtCondition>& runs,
                                                const std::optional<MeasuringRig>& rig) {
    if (runs.empty()) base::refuse("there are no runs", "a law is fitted to some", "");
    FrictionOverConditions over;
    for (const FrictionAtCondition& each : runs) {
        over.conditions.push_back(each.condition);
        for (std::size_t k = 0; k < fitted_exponents.size(); ++k)
            over.fits[k].push_back(fit_at(each, rig, fitted_exponents[k]));
        over.whole.independent += over.fits[0].back().independent;
        over.whole.slips += over.fits[0].back().slips;
    }
    for (std::size_t kind = 0; kind < fitted_kinds.size(); ++kind) {
        std::optional<FittedLaw> best;
        std::size_t exponent = 0;
        for (std::size_t k = 0; k < fitted_exponents.size(); ++k) {
            std::optional<FittedLaw> all = law_of_all(over.fits[k], kind);
            if (!all || (best && !(all->criterion < best->criterion))) continue;
            best = std::move(all);
            exponent = k;
        }
        if (!best) {
            over.whole.unfitted.push_back({kind, why_not(over, kind)});
            continue;
        }
        over.whole.laws.push_back(std::move(*best));
        over.exponents.push_back(exponent);
    }
    if (over.whole.laws.empty())
        base::refuse("no law can be fitted at all conditions", over.whole.unfitted.front().why,
                     "Measure at more speeds there, or leave that one out.");
    choose_law(over.whole);
    over.gain = gain_of(over);
    return over;
}

FrictionOverConditions friction_over_temperature(std::vector<FrictionAtTemperature> runs,
                                                 const std::optional<MeasuringRig>& rig) {
    if (runs.size() < 2)
        base::refuse("all runs are of one temperature", "a law over the temperature needs two at least",
                     "Give --temperature a value for each file, or leave it out.");
    std::sort(runs.begin(), runs.end(), [](const FrictionAtTemperature& a, const FrictionAtTemperature& b) {
        return a.temperature < b.temperature;
    });
    std::vector<FrictionAtCondition> conditions;
    std::vector<double> temperatures;
    for (FrictionAtTemperature& each : runs) {
        conditions.push_back({"at " + base::shortest(each.temperature) + " degC", std::move(each.data)});
        temperatures.push_back(each.temperature);
    }
    FrictionOverConditions over = friction_over_conditions(conditions, rig);
    over.temperatures = std::move(temperatures);
    return over;
}

const FittedLaw& law_at(const FrictionOverConditions& over, std::size_t law, std::size_t condition) {
    return *law_of_kind(over.fits[over.exponents[law]][condition], over.whole.laws[law].kind);
}

std::string words_of(const FrictionOverConditions& over) {
    const std::string words = words_of(over.whole);
    if (over.temperatures.empty() || std::isnan(over.gain)) return words;
    return words + (over.gain < telling_difference ? " Nothing shows that it changes with the temperature."
                                                   : " It changes with the temperature.");
}

}  // namespace stridor::analysis
