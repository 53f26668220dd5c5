#include "support/oracles/figure_laws.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/simulate.hpp"
#include "support/patience.hpp"

#include <cmath>
#include <sstream>

namespace stridor::support {

namespace {

using analysis::Level;
using analysis::Rates;

std::string in_words(const std::string& what, double figure) {
    std::ostringstream text;
    text.precision(17);
    text << what << " " << figure;
    return text.str();
}

std::string broken_rates(const Rates& rates, double time, const std::string& of) {
    if (!(time > 0.0)) return {};
    const double sum = rates.slip + rates.stick + rates.separation;
    if (!(std::abs(sum - 1.0) <= 1e-9)) return in_words("rates of " + of + " add up to", sum);
    for (const double rate : {rates.slip, rates.stick, rates.separation})
        if (!(rate >= 0.0)) return in_words("a rate of " + of + " is", rate);
    return {};
}

std::string broken_level(const Level& level, double time, const std::string& of) {
    if (!(time > 0.0)) return {};
    if (!std::isfinite(level.rms)) return in_words(of + " has a root mean square of", level.rms);
    if (!(level.peak >= level.rms))
        return in_words(of + " peaks below its root mean square, by a factor of", level.peak / level.rms);
    if (std::isnan(level.decibels) || std::isnan(level.peak_decibels)) return of + " has no level";
    return {};
}

}  // namespace

std::string broken_figure(const parameters::Case& c, const integration::Motion& motion) {
    if (!integration::has_result(motion.outcome)) return {};
    if (motion.record.phases.empty()) return "there is no phase";
    const double residual = motion.energy.relative_residual();
    const bool is_exact = c.run.engine == parameters::Engine::exact;
    const double most = is_exact ? 1e-9 : c.run.beta_2 > 0.5 ? 1.0 : 1e-6;
    if (!(std::abs(residual) <= most)) return in_words("balance off by", residual);
    for (const record::Tally& tally : motion.record.phases) {
        const classification::Verdict verdict = classification::classify(analysis::evidence(tally, 0), c.verdict);
        const analysis::Evidence& e = verdict.evidence;
        const std::string name(record::phase_names[static_cast<std::size_t>(tally.phase)]);
        double time = 0.0, judged = 0.0;
        for (std::size_t state = 0; state < tally.contacts.front().time.size(); ++state) {
            time += tally.contacts.front().time[state];
            judged += tally.contacts.front().judged_time[state];
        }
        const bool is_judged = verdict.category != classification::Category::undecided;
        if (is_judged && !(judged > 0.0)) return "a verdict from no time";
        if (verdict.reasons.empty()) return "a verdict without a reason";
        for (const std::string& broken :
             {broken_rates(e.rates, time, name), broken_rates(e.judged_rates, judged, "what is judged of " + name),
              broken_level(e.levels.joint, judged, "the joint"), broken_level(e.levels.plate, judged, "the plate")})
            if (!broken.empty()) return broken;
    }
    return {};
}

std::string complaint_of_run(const parameters::Case& c, double patience_in_seconds) {
    Patience patience(patience_in_seconds);
    std::string text;
    try {
        text = broken_figure(c, integration::simulate(c, {}, patience.token()));
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::numerical) text = error.what();
    }
    return patience.is_worn_out() ? "goes on a second after Ctrl-C" : text;
}

}  // namespace stridor::support
