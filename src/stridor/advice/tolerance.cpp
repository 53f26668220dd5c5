#include "stridor/advice/tolerance.hpp"

#include "stridor/advice/sobol.hpp"
#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/usual_range.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace stridor::advice {

namespace {

using base::shortest;
using parameters::Case;

// quantile 0.975 of Student's t with 15 degrees of freedom, and of the normal distribution
constexpr double student_15 = 2.131449545559776;
constexpr double normal_975 = 1.959963984540054;

// up to so many samples with a property the binomial distribution is summed
constexpr std::size_t few = 30;

// the probability of at most k of n when each has probability 0 < p < 1; terms by recurrence, k small
double at_most(std::size_t k, std::size_t n, double p) {
    const double log_none = static_cast<double>(n) * base::logarithm_2(1.0 - p);
    if (log_none < -900.0) return 0.0;
    double term = base::power_of_2(log_none);
    double sum = term;
    for (std::size_t j = 1; j <= k; ++j) {
        term *= static_cast<double>(n - j + 1) / static_cast<double>(j) * (p / (1.0 - p));
        sum += term;
    }
    return sum;
}

// the p at which P(X <= k) falls to `probability`
double falls_to(std::size_t k, std::size_t n, double probability) {
    double low = 0.0;
    double high = 1.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (at_most(k, n, middle) > probability ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// Clopper and Pearson, for few hits
Estimate clopper_pearson(std::size_t hits, std::size_t samples) {
    constexpr double tail = 0.5 * (1.0 - confidence);
    Estimate result{static_cast<double>(hits) / static_cast<double>(samples), 0.0, 1.0};
    if (hits > 0) result.low = falls_to(hits - 1, samples, 1.0 - tail);
    if (hits < samples) result.high = falls_to(hits, samples, tail);
    return result;
}

Estimate wilson(double share, double samples) {
    constexpr double square = normal_975 * normal_975;
    const double centre = (share + 0.5 * square / samples) / (1.0 + square / samples);
    const double half =
        normal_975 / (1.0 + square / samples) * std::sqrt((share * (1.0 - share) + 0.25 * square / samples) / samples);
    return {share, centre - half, centre + half};
}

Estimate mirrored(const Estimate& estimate) {
    return {1.0 - estimate.share, 1.0 - estimate.high, 1.0 - estimate.low};
}

double polynomial(std::span<const double> coefficients, double x) {
    double sum = 0.0;
    for (auto each = coefficients.rbegin(); each != coefficients.rend(); ++each)
        sum = sum * x + *each;
    return sum;
}

// quantile of the normal distribution for 1e-10 < p < 1 - 1e-10, relative error below 1e-15: AS 241 (Wichura 1988)
double normal_quantile(double p) {
    constexpr std::array a{3.3871328727963666080e0,  1.3314166789178437745e+2, 1.9715909503065514427e+3,
                           1.3731693765509461125e+4, 4.5921953931549871457e+4, 6.7265770927008700853e+4,
                           3.3430575583588128105e+4, 2.5090809287301226727e+3};
    constexpr std::array b{1.0,
                           4.2313330701600911252e+1,
                           6.8718700749205790830e+2,
                           5.3941960214247511077e+3,
                           2.1213794301586595867e+4,
                           3.9307895800092710610e+4,
                           2.8729085735721942674e+4,
                           5.2264952788528545610e+3};
    constexpr std::array c{1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                           3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                           2.27238449892691845833e-2, 7.74545014278341407640e-4};
    constexpr std::array d{1.0,
                           2.05319162663775882187e0,
                           1.67638483018380384940e0,
                           6.89767334985100004550e-1,
                           1.48103976427480074590e-1,
                           1.51986665636164571966e-2,
                           5.47593808499534494600e-4,
                           1.05075007164441684324e-9};
    const double q = p - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * polynomial(a, r) / polynomial(b, r);
    }
    constexpr double natural = 0.6931471805599453;
    const double r = std::sqrt(-natural * base::logarithm_2(q < 0.0 ? p : 1.0 - p)) - 1.6;
    const double quantile = polynomial(c, r) / polynomial(d, r);
    return q < 0.0 ? -quantile : quantile;
}

Tolerance tolerance_for(const Case& c, const AskedTolerance& asked) {
    const std::string key = quantity_key_called(c, asked.name);
    expect_one_value(c, key);
    const double value = parameters::get_quantity(c, key);
    STRIDOR_EXPECT(asked.relative.has_value() != asked.absolute.has_value());
    const double amount = asked.relative ? *asked.relative * std::abs(value) : *asked.absolute;
    if (!(amount > 0.0) || !std::isfinite(amount))
        base::refuse("the tolerance of " + key + " is " + shortest(amount),
                     value == 0.0 ? "a share of zero is zero" : "it has to be above zero",
                     value == 0.0 ? "Give it in the quantity's unit." : "");
    for (const double end : {value - amount, value + amount}) {
        Case probe = c;
        try {
            parameters::set_quantity(probe, key, end);
        } catch (const Error& error) {
            base::refuse("the tolerance of " + key + " reaches " + shortest(end), error.problem().why,
                         "Make it smaller.");
        }
    }
    return {key, value, amount, asked.spread};
}

// the spread of series production [1, share of the value; angles in deg]
constexpr double force_spread = 0.2;
constexpr double friction_spread = 0.1;
constexpr double damping_spread = 0.3;
constexpr double stiffness_spread = 0.1;
constexpr double mass_spread = 0.05;
constexpr double angle_spread = 2.0;  // [deg]

double default_spread(const parameters::Field& field, double value) {
    const double size = std::abs(value);
    const std::string_view unit = parameters::unit_of(field);
    if (field.section == "drive") return 0.0;
    if (unit == "deg") return angle_spread;
    if (unit == "N") return force_spread * size;
    if (unit == "N*s/m" || field.name == "damping_scale") return damping_spread * size;
    if (unit == "N/m" || field.name == "stiffness_scale" || field.name == "spring_scale")
        return stiffness_spread * size;
    if (unit == "kg") return mass_spread * size;
    return friction_spread * size;
}

// half of what lies between mu_d and mu_s of the same way; of other quantities no limit
double room_of(const Case& c, const std::string& key) {
    constexpr std::string_view kinetic = "kinetic_friction", held = "static_friction";
    std::string other = key;
    const std::size_t at = key.find(kinetic), of_static = key.find(held);
    if (at != std::string::npos)
        other.replace(at, kinetic.size(), held);
    else if (of_static != std::string::npos)
        other.replace(of_static, held.size(), kinetic);
    else
        return std::numeric_limits<double>::infinity();
    return 0.5 * std::abs(parameters::get_quantity(c, key) - parameters::get_quantity(c, other));
}

Design sampled(std::span<const Tolerance> tolerances, const std::vector<double>& point) {
    Design design;
    for (std::size_t k = 0; k < tolerances.size(); ++k)
        design.settings.push_back({tolerances[k].key, value_at(tolerances[k], point[k])});
    return design;
}

// a bound on memory, in which replicates of few samples are judged together: nobody waits for the last of each
constexpr std::size_t most_designs_at_once = 65536;

// how often each thing was seen, by replicate
using Hits = std::array<std::size_t, replicates>;
struct Seen {
    Hits noise{};
    Hits not_quiet{};
    std::array<Hits, sweep::verdict_words.size()> by_verdict{};
};

void see(Seen& seen, std::size_t replicate, const DesignVerdict& verdict) {
    if (is_noisy(verdict)) ++seen.noise[replicate];
    if (!is_quiet(verdict)) ++seen.not_quiet[replicate];
    ++seen.by_verdict[sweep::number_of(overall(verdict))][replicate];
}

}  // namespace

std::vector<Tolerance> tolerances(const Case& c, std::span<const AskedTolerance> asked) {
    std::vector<Tolerance> all;
    for (const AskedTolerance& each : asked) {
        Tolerance tolerance = tolerance_for(c, each);
        for (const Tolerance& other : all)
            if (parameters::overlap(c, other.key, tolerance.key))
                base::refuse(tolerance.key + " has two tolerances", "each parameter has one", "");
        all.push_back(std::move(tolerance));
    }
    if (all.size() > most_sobol_dimensions)
        base::refuse(std::to_string(all.size()) + " tolerances are too many",
                     "there are at most " + std::to_string(most_sobol_dimensions),
                     "Leave out those that matter least.");
    return all;
}

std::vector<Tolerance> default_tolerances(const Case& c) {
    std::vector<Tolerance> all;
    for (const std::string& key : parameters::design_keys(c)) {
        const double value = parameters::get_quantity(c, key);
        const parameters::Range range = parameters::range_of(c, key);
        const double spread = std::min(default_spread(*parameters::field_of(key), value), room_of(c, key));
        const bool fits = value - spread >= range.low && value + spread <= range.high;
        if (spread > 0.0 && fits && all.size() < most_sobol_dimensions) all.push_back({key, value, spread});
    }
    return all;
}

std::vector<std::string> narrowed_frictions(const Case& c) {
    std::vector<std::string> all = parameters::design_keys(c);
    std::erase_if(all, [&](const std::string& key) {
        const double value = parameters::get_quantity(c, key);
        return !(room_of(c, key) < default_spread(*parameters::field_of(key), value));
    });
    return all;
}

double value_at(const Tolerance& tolerance, double probability) {
    constexpr double sigmas = 3.0;
    constexpr double cut = 0.0013498980316300945;  // below -3 standard deviations
    const double place = tolerance.spread == Spread::uniform
                             ? 2.0 * probability - 1.0
                             : normal_quantile(cut + probability * (1.0 - 2.0 * cut)) / sigmas;
    const double value = tolerance.value + std::clamp(place, -1.0, 1.0) * tolerance.tolerance;
    return std::clamp(value, tolerance.value - tolerance.tolerance, tolerance.value + tolerance.tolerance);
}

Estimate estimate(std::span<const std::size_t> hits, std::size_t samples) {
    STRIDOR_EXPECT(hits.size() == replicates && samples > 0);
    std::size_t total = 0;
    for (const std::size_t each : hits)
        total += each;
    const std::size_t all = replicates * samples;
    if (total <= few) return clopper_pearson(total, all);
    if (all - total <= few) return mirrored(clopper_pearson(all - total, all));
    const double mean = static_cast<double>(total) / static_cast<double>(all);
    double square = 0.0;
    for (const std::size_t each : hits) {
        const double deviation = static_cast<double>(each) / static_cast<double>(samples) - mean;
        square += deviation * deviation;
    }
    if (square == 0.0) return wilson(mean, static_cast<double>(all));
    const double half = student_15 * std::sqrt(square / (replicates * (replicates - 1)));
    return {mean, std::max(0.0, mean - half), std::min(1.0, mean + half)};
}

Chance chance(std::span<const Tolerance> tolerances, const ChanceOptions& options, DesignRunner& runner) {
    STRIDOR_EXPECT(!tolerances.empty() && options.samples > 0 && options.samples <= most_samples);
    const std::size_t samples = std::bit_ceil((options.samples + replicates - 1) / replicates);
    const std::size_t at_once = std::clamp<std::size_t>(most_designs_at_once / samples, 1, replicates);
    Seen seen;
    for (std::size_t first = 0; first < replicates; first += at_once) {
        std::vector<Design> designs;
        for (std::size_t replicate = first; replicate < std::min(first + at_once, replicates); ++replicate)
            for (const std::vector<double>& point : sobol_points(tolerances.size(), samples, {options.seed, replicate}))
                designs.push_back(sampled(tolerances, point));
        const std::vector<DesignVerdict> verdicts = runner.judge(designs);
        for (std::size_t k = 0; k < verdicts.size(); ++k)
            see(seen, first + k / samples, verdicts[k]);
    }
    Chance result{{tolerances.begin(), tolerances.end()}, options, replicates * samples};
    result.noise = estimate(seen.noise, samples);
    result.not_quiet = estimate(seen.not_quiet, samples);
    for (std::size_t k = 0; k < sweep::verdict_words.size(); ++k)
        result.by_verdict[k] = estimate(seen.by_verdict[k], samples);
    return result;
}

}  // namespace stridor::advice
