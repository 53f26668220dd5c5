#include "stridor/classification/contact_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::classification {

namespace {

Margin margin(std::string_view threshold_name, std::string_view figure_name, double figure, double threshold) {
    return {threshold_name, figure_name, figure, threshold, figure - threshold};
}

// equal beats at lag 1; with more beats allowed, the best of the lags up to that many
double regularity_within(const analysis::Alternation& alternation, double beats) {
    double least = std::numeric_limits<double>::infinity();
    const auto lags = std::min(static_cast<std::size_t>(beats), analysis::largest_lag);
    for (std::size_t lag = 0; lag < lags; ++lag)
        least = std::min(least, alternation.mismatch[lag]);
    return std::isfinite(least) ? std::max(0.0, 1.0 - least) : std::numeric_limits<double>::quiet_NaN();
}

std::string percent(double share) {
    return fmt::format("{:.1f} %", 100.0 * share);
}

}  // namespace

Verdict classify(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    const analysis::Rates& rates = evidence.judged_rates;
    const analysis::Alternation& alternation = evidence.alternation;
    const double regularity = regularity_within(alternation, thresholds.squeal_beats);
    Verdict verdict;
    verdict.evidence = evidence;
    verdict.margins = {
        margin("quiet_slip", "judged slip rate", rates.slip, thresholds.quiet_slip),
        margin("creak_stick", "judged stick rate", rates.stick, thresholds.creak_stick),
        margin("least_intervals", "intervals", static_cast<double>(alternation.intervals), thresholds.least_intervals),
        margin("squeal_regularity", "regularity", regularity, thresholds.squeal_regularity),
    };
    const auto decide = [&](Category category, std::string reason) {
        verdict.category = category;
        verdict.reasons.push_back(std::move(reason));
        return verdict;
    };

    if (!(evidence.judged_time > 0.0)) return decide(Category::undecided, "no complete phase lies in the window");
    if (rates.slip >= thresholds.quiet_slip)
        return decide(Category::none,
                      fmt::format("slips {} of the judged time: nothing alternates", percent(rates.slip)));
    const bool is_stuck = rates.stick >= 1.0;
    if (is_stuck)
        return decide(Category::none, "sticks throughout: the joint moves with the plate and nothing alternates");
    verdict.reasons.push_back(fmt::format("slips only {} of the judged time", percent(rates.slip)));
    if (rates.stick >= thresholds.creak_stick)
        return decide(Category::creak, fmt::format("stick predominates with {}", percent(rates.stick)));
    const bool is_thin =
        static_cast<double>(alternation.intervals) < thresholds.least_intervals || std::isnan(regularity);
    if (is_thin)
        return decide(Category::undecided,
                      fmt::format("only {} intervals between changes of state", alternation.intervals));
    if (regularity >= thresholds.squeal_regularity)
        return decide(Category::squeal, fmt::format("states alternate regularly (regularity {:.3f})", regularity));
    if (alternation.repetition >= thresholds.squeal_regularity)
        verdict.reasons.push_back(fmt::format("the pattern repeats, but only after {} unequal beats", alternation.lag));
    return decide(Category::squeak, fmt::format("states alternate irregularly (regularity {:.3f})", regularity));
}

std::vector<Verdict> classify_phases(std::span<const record::Tally> phases, const parameters::Thresholds& thresholds) {
    std::vector<Verdict> verdicts;
    for (const record::Tally& phase : phases)
        verdicts.push_back(classify(analysis::evidence(phase), thresholds));
    return verdicts;
}

}  // namespace stridor::classification
