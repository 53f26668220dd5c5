#include "stridor/classification/contact_rules.hpp"

#include "stridor/classification/interface_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace stridor::classification {

namespace {

using record::Future;

struct Decision {
    Category category = Category::undecided;
    Quiet quiet = Quiet::no;
    std::string reason;
};

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

std::string percent_text(double share) {
    return fmt::format("{:.1f} %", 100.0 * share);
}

std::string seconds(double time) {
    return fmt::format("{:.4g} s", time);
}

Decision none(Quiet quiet, const std::string& reason) {
    return {Category::none, quiet, fmt::format("quiet because it {}: {}", name(quiet), reason)};
}

// what is over before the run ends, whatever it was; nothing if the contact may change its state again
std::optional<Decision> settled(const analysis::Evidence& evidence) {
    const record::Outlook& outlook = evidence.ending.outlook;
    if (outlook.future == Future::sticks)
        return none(Quiet::sticks, fmt::format("from {} on, and never slips again (proven): the joint is carried along",
                                               seconds(evidence.ending.since)));
    if (outlook.future == Future::slides)
        return none(Quiet::slides, fmt::format("never sticks or lifts off after {} (proven)", seconds(outlook.from)));
    return std::nullopt;
}

// a contact that sticks in all of the judged time
Decision stuck(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    const record::Outlook& outlook = evidence.ending.outlook;
    const bool slips_elsewhere = static_cast<double>(evidence.all_releases) >= thresholds.least_releases;
    if (slips_elsewhere && evidence.rates.stick >= thresholds.creak_stick)
        return {Category::creak, Quiet::no,
                fmt::format("sticks throughout the judged time, but slips {} times in the window outside it",
                            evidence.all_releases)};
    if (outlook.future == Future::releases)
        return {Category::undecided, Quiet::no,
                std::isnan(outlook.release)
                    ? "sticks in all of the judged time, yet the drive will make it slip: simulate more periods"
                    : fmt::format("sticks in all of the judged time, but slips at about {}: simulate longer than that",
                                  seconds(outlook.release))};
    return none(Quiet::sticks, "in all of the judged time; the joint is carried along");
}

// a contact that mostly sticks
Decision sticking(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    const std::string predominates =
        fmt::format("stick predominates with {}", percent_text(evidence.judged_rates.stick));
    const bool repeats = static_cast<double>(evidence.releases) >= thresholds.least_releases;
    if (repeats)
        return {Category::creak, Quiet::no, fmt::format("{} and ends {} times", predominates, evidence.releases)};
    if (evidence.ending.outlook.future == Future::repeats)
        return {Category::creak, Quiet::no, fmt::format("{} and repeats itself for ever (proven)", predominates)};
    return {Category::undecided, Quiet::no,
            fmt::format("{}, but ends only {} times: no repetition yet", predominates, evidence.releases)};
}

// a share that lies nearer to its threshold than it changes with the time step
std::optional<Decision> within_step_error(std::string_view what, double share, double threshold,
                                          std::string_view threshold_name, double change) {
    if (!(std::abs(share - threshold) < change)) return std::nullopt;
    return Decision{
        Category::undecided, Quiet::no,
        fmt::format("its {} share of {} changes by {} from twice the time step, and lies nearer than that "
                    "to {} = {}: use a smaller run.step",
                    what, percent_text(share), percent_text(change), threshold_name, percent_text(threshold))};
}

Decision alternating(const analysis::Alternation& alternation, double regularity,
                     const parameters::Thresholds& thresholds) {
    const bool is_thin =
        static_cast<double>(alternation.intervals) < thresholds.least_intervals || std::isnan(regularity);
    if (is_thin)
        return {Category::undecided, Quiet::no,
                fmt::format("only {} intervals between changes of state", alternation.intervals)};
    if (regularity >= thresholds.squeal_regularity)
        return {Category::squeal, Quiet::no, fmt::format("states alternate regularly (regularity {:.3f})", regularity)};
    return {Category::squeak, Quiet::no, fmt::format("states alternate irregularly (regularity {:.3f})", regularity)};
}

}  // namespace

Verdict classify(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds, Creak creak) {
    const analysis::Rates& rates = evidence.judged_rates;
    const analysis::Alternation& alternation = evidence.alternation;
    const double regularity = regularity_within(alternation, thresholds.squeal_beats);
    Verdict verdict;
    verdict.evidence = evidence;
    verdict.margins = {
        margin("quiet_slip", "judged slip rate", rates.slip, thresholds.quiet_slip),
        margin("creak_stick", "judged stick rate", rates.stick, thresholds.creak_stick),
        margin("least_releases", "releases", static_cast<double>(evidence.releases), thresholds.least_releases),
        margin("least_intervals", "intervals", static_cast<double>(alternation.intervals), thresholds.least_intervals),
        margin("squeal_regularity", "regularity", regularity, thresholds.squeal_regularity),
    };
    const auto decide = [&](const Decision& decision) {
        verdict.category = decision.category;
        verdict.quiet = decision.quiet;
        verdict.reasons.push_back(decision.reason);
        return verdict;
    };

    if (!(evidence.judged_time > 0.0))
        return decide({Category::undecided, Quiet::no, "no complete phase lies in the window"});
    if (const std::optional<Decision> over = settled(evidence)) return decide(*over);
    const analysis::Rates change = evidence.judged_step_change.value_or(analysis::Rates{});
    if (const auto doubt = within_step_error("slip", rates.slip, thresholds.quiet_slip, "quiet_slip", change.slip))
        return decide(*doubt);
    if (rates.slip >= thresholds.quiet_slip)
        return decide(none(Quiet::slides,
                           fmt::format("{} of the judged time, and nothing alternates", percent_text(rates.slip))));
    if (rates.stick >= 1.0) return decide(stuck(evidence, thresholds));
    verdict.reasons.push_back(fmt::format("slips only {} of the judged time", percent_text(rates.slip)));
    const bool may_creak = creak == Creak::possible;
    if (const auto doubt = within_step_error("stick", rates.stick, thresholds.creak_stick, "creak_stick", change.stick);
        doubt && may_creak)
        return decide(*doubt);
    if (may_creak && rates.stick >= thresholds.creak_stick) return decide(sticking(evidence, thresholds));
    const Decision decision = alternating(alternation, regularity, thresholds);
    const bool repeats_later = alternation.repetition >= thresholds.squeal_regularity;
    if (decision.category == Category::squeak && repeats_later)
        verdict.reasons.push_back(fmt::format("the pattern repeats, but only after {} unequal beats", alternation.lag));
    return decide(decision);
}

Verdict classify_phase(const record::Tally& phase, const parameters::Thresholds& thresholds) {
    return classify_all(phase, thresholds).whole;
}

std::vector<Verdict> classify_phases(std::span<const record::Tally> phases, const parameters::Thresholds& thresholds) {
    std::vector<Verdict> verdicts;
    for (const record::Tally& phase : phases)
        verdicts.push_back(classify_phase(phase, thresholds));
    return verdicts;
}

}  // namespace stridor::classification
