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

// a figure and what is unknown of it
struct JudgedFigure {
    double value = 0.0;        // [1]
    double scatter = 0.0;      // [1] standard error, from pieces of the judged time
    double step_change = 0.0;  // [1] from twice the time step
};

double error_of(const JudgedFigure& figure) {
    return figure.scatter > figure.step_change ? figure.scatter : figure.step_change;  // no scatter is known: NaN
}

// on which side of its threshold a figure lies, if its error does not leave that open
enum class Side { below, above, open };

Side side_of(const JudgedFigure& figure, double threshold, const parameters::Thresholds& thresholds) {
    const double distance = figure.value - threshold;
    if (std::abs(distance) < thresholds.least_distance * error_of(figure)) return Side::open;
    return distance >= 0.0 ? Side::above : Side::below;
}

// what the rules look at
struct JudgedFigures {
    JudgedFigure slip, stick;
    JudgedFigure regularity;         // of equal beats, or of as many unlike ones as are allowed
    JudgedFigure repetition;         // of the pattern
    JudgedFigure pattern_frequency;  // [Hz] how often that comes again
};

bool is_proven_cycle(const analysis::Evidence& evidence) {
    return evidence.ending.outlook.future == Future::repeats;
}

double likeness(double mismatch) {
    return std::isfinite(mismatch) ? std::max(0.0, 1.0 - mismatch) : std::numeric_limits<double>::quiet_NaN();
}

// 1 - the least mismatch of so many lags
JudgedFigure likeness_within(const analysis::Evidence& evidence, std::size_t lags) {
    const analysis::Mismatch least = analysis::least_mismatch(evidence.alternation, lags);
    JudgedFigure figure{likeness(least.mean), is_proven_cycle(evidence) ? 0.0 : least.error};
    if (evidence.coarser) {
        const double coarser = likeness(analysis::least_mismatch(*evidence.coarser, lags).mean);
        if (!std::isnan(coarser)) figure.step_change = std::abs(coarser - figure.value);
    }
    return figure;
}

// How often the pattern comes again: its duration scatters as its beats do from one time to the next, and the mean of n
// of them by 1/sqrt(n) of that.
JudgedFigure pattern_frequency(const analysis::Evidence& evidence) {
    const analysis::Alternation& found = evidence.alternation;
    JudgedFigure figure{1.0 / found.period};
    const double mismatch = found.mismatch.at(static_cast<std::size_t>(found.lag - 1)).mean;
    const double patterns = static_cast<double>(found.intervals) / found.lag;
    if (std::isfinite(mismatch) && patterns > 0.0) figure.scatter = figure.value * mismatch / std::sqrt(patterns);
    if (evidence.coarser) {
        const double coarser = 1.0 / evidence.coarser->period;
        if (std::isfinite(coarser)) figure.step_change = std::abs(coarser - figure.value);
    }
    return figure;
}

JudgedFigures figures_of(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    const analysis::Rates change = evidence.judged_step_change.value_or(analysis::Rates{});
    JudgedFigures figures{{evidence.judged_rates.slip, evidence.judged_errors.slip, change.slip},
                          {evidence.judged_rates.stick, evidence.judged_errors.stick, change.stick},
                          likeness_within(evidence, static_cast<std::size_t>(thresholds.squeal_beats)),
                          likeness_within(evidence, analysis::largest_lag),
                          pattern_frequency(evidence)};
    if (is_proven_cycle(evidence)) {
        figures.repetition = {1.0};
        figures.pattern_frequency = {1.0 / evidence.ending.outlook.period};
    }
    return figures;
}

Margin margin(std::string_view threshold_name, std::string_view figure_name, double figure, double threshold) {
    return {threshold_name, figure_name, figure, threshold, figure - threshold};
}

Margin margin(std::string_view threshold_name, std::string_view figure_name, const JudgedFigure& figure,
              double threshold) {
    Margin result = margin(threshold_name, figure_name, figure.value, threshold);
    result.error = error_of(figure);
    return result;
}

std::vector<Margin> margins_of(const analysis::Evidence& evidence, const JudgedFigures& figures,
                               const parameters::Thresholds& t) {
    return {
        margin("quiet_slip", "judged slip rate", figures.slip, t.quiet_slip),
        margin("creak_stick", "judged stick rate", figures.stick, t.creak_stick),
        margin("least_releases", "releases", static_cast<double>(evidence.releases), t.least_releases),
        margin("least_intervals", "intervals", static_cast<double>(evidence.alternation.intervals), t.least_intervals),
        margin("squeal_regularity", "regularity", figures.regularity, t.squeal_regularity),
        margin("squeal_repetition", "repetition", figures.repetition, t.squeal_repetition),
        margin("squeal_frequency", "patterns per second", figures.pattern_frequency, t.squeal_frequency),
    };
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
std::optional<Decision> settled(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    const record::Outlook& outlook = evidence.ending.outlook;
    if (outlook.future == Future::sticks)
        if (const auto lock = locking(evidence, thresholds)) return Decision{Category::none, Quiet::locks, *lock};
    if (outlook.future == Future::sticks)
        return none(Quiet::sticks, fmt::format("from {} on, and never slips again (proven): the joint is carried along",
                                               seconds(evidence.ending.since)));
    if (outlook.future == Future::slides)
        return none(Quiet::slides, fmt::format("never sticks or lifts off after {} (proven)", seconds(outlook.from)));
    return std::nullopt;
}

// a contact whose friction has a state, of which nothing is proven
std::optional<Decision> creeping(const analysis::Evidence& evidence) {
    if (evidence.ending.outlook.future != Future::creeps) return std::nullopt;
    if (!(evidence.rates.stick > 0.0))
        return Decision{Category::undecided, Quiet::no,
                        "its friction has a state: it creeps where others stick, so contact states tell no noise; "
                        "verdict.creep_speed says below which slip velocity it counts as stuck"};
    if (evidence.judged_rates.stick >= 1.0)
        return Decision{Category::undecided, Quiet::no,
                        "creeps in all of the judged time, and nothing is proven of that: simulate longer"};
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
    if (const auto lock = locking(evidence, thresholds)) return {Category::none, Quiet::locks, *lock};
    return none(Quiet::sticks, "in all of the judged time; the joint is carried along");
}

// how a disturbance of its sliding goes on
std::string growth_text(const record::Outlook& outlook) {
    if (outlook.growth == 0.0) return "its sliding position would need a normal force of zero or less";
    return fmt::format("its sliding is unstable: a small disturbance grows with {:.3g} 1/s", outlook.growth);
}

// a contact that slides in all of the judged time, and whose sliding does not last
Decision growing(const record::Outlook& outlook) {
    const std::string slides = "slides in all of the judged time, but " + growth_text(outlook);
    return {Category::undecided, Quiet::no,
            std::isnan(outlook.grown)
                ? slides + ": simulate longer"
                : fmt::format("{}, and ends that at about {}: simulate longer", slides, seconds(outlook.grown))};
}

// a contact that mostly sticks
Decision sticking(const analysis::Evidence& evidence, const JudgedFigures& figures,
                  const parameters::Thresholds& thresholds) {
    const std::string predominates =
        fmt::format("stick predominates with {}", percent_text(evidence.judged_rates.stick));
    const bool repeats = static_cast<double>(evidence.releases) >= thresholds.least_releases;
    const double frequency = evidence.alternation.frequency;
    const bool has_pitch =
        figures.regularity.value >= thresholds.squeal_regularity && frequency >= thresholds.squeal_frequency;
    const std::string pitch =
        has_pitch ? fmt::format(", regularly, {:.3g} times a second: such a creak has a pitch", frequency) : "";
    if (repeats)
        return {Category::creak, Quiet::no,
                fmt::format("{} and ends {} times{}", predominates, evidence.releases, pitch)};
    if (is_proven_cycle(evidence))
        return {Category::creak, Quiet::no,
                fmt::format("{} and repeats itself for ever (proven){}", predominates, pitch)};
    return {Category::undecided, Quiet::no,
            fmt::format("{}, but ends only {} times: no repetition yet", predominates, evidence.releases)};
}

// a figure that lies nearer to its threshold than is known of it
Decision doubted(std::string_view what, const JudgedFigure& figure, double threshold, std::string_view threshold_name) {
    const bool is_by_step = !(figure.scatter > figure.step_change);
    return {Category::undecided, Quiet::no,
            fmt::format(
                "its {} of {:.3f} {} by {:.2g}, and lies too near to {} = {:.4g} for that: use a {}", what,
                figure.value, is_by_step ? "changes from twice the time step" : "scatters within the judged time",
                error_of(figure), threshold_name, threshold, is_by_step ? "smaller run.step" : "longer run.window")};
}

// why what repeats itself is no squeal yet
std::optional<std::string> shortcoming(const analysis::Evidence& evidence, const JudgedFigures& figures,
                                       const parameters::Thresholds& thresholds) {
    const bool repeats = figures.repetition.value >= thresholds.squeal_regularity;
    if (!repeats) return std::nullopt;
    const double often = figures.pattern_frequency.value;
    if (often < thresholds.squeal_frequency)
        return fmt::format("the pattern repeats, but only {:.3g} times a second", often);
    return fmt::format("the pattern repeats after {} unequal beats, but only to {:.3f}", evidence.alternation.lag,
                       figures.repetition.value);
}

std::string pattern_text(const analysis::Evidence& evidence, const JudgedFigures& figures) {
    const std::string often = fmt::format("{:.4g} times a second", figures.pattern_frequency.value);
    if (is_proven_cycle(evidence))
        return fmt::format("states alternate in a cycle that repeats itself {} (proven)", often);
    return fmt::format("states alternate in a pattern of {} unequal beats that comes again {} (repetition {:.3f})",
                       evidence.alternation.lag, often, figures.repetition.value);
}

// Does a contact that nearly always slips end that again and again? Its beats fill half of the judged time then; what
// dies away fills less.
bool keeps_alternating(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    constexpr double least_filled = 0.5;
    const auto intervals = static_cast<double>(evidence.alternation.intervals);
    return intervals >= thresholds.least_intervals &&
           intervals >= least_filled * evidence.judged_time * evidence.alternation.frequency;
}

Decision alternating(const analysis::Evidence& evidence, const JudgedFigures& figures,
                     const parameters::Thresholds& thresholds) {
    const Side often = side_of(figures.pattern_frequency, thresholds.squeal_frequency, thresholds);
    const JudgedFigure& regularity = figures.regularity;
    const bool is_thin = static_cast<double>(evidence.alternation.intervals) < thresholds.least_intervals ||
                         std::isnan(regularity.value);
    if (is_thin && !(often == Side::above && is_proven_cycle(evidence)))
        return {Category::undecided, Quiet::no,
                fmt::format("only {} intervals between changes of state", evidence.alternation.intervals)};
    const Side regular = side_of(regularity, thresholds.squeal_regularity, thresholds);
    const Side repeats =
        often == Side::below ? Side::below : side_of(figures.repetition, thresholds.squeal_repetition, thresholds);
    if (regular == Side::above)
        return {Category::squeal, Quiet::no,
                fmt::format("states alternate regularly (regularity {:.3f})", regularity.value)};
    if (repeats == Side::above && often == Side::above)
        return {Category::squeal, Quiet::no, pattern_text(evidence, figures)};
    if (regular == Side::open)
        return doubted("regularity", regularity, thresholds.squeal_regularity, "squeal_regularity");
    if (repeats == Side::open)
        return doubted("repetition", figures.repetition, thresholds.squeal_repetition, "squeal_repetition");
    if (repeats == Side::above)
        return doubted("number of patterns per second", figures.pattern_frequency, thresholds.squeal_frequency,
                       "squeal_frequency");
    return {Category::squeak, Quiet::no,
            fmt::format("states alternate irregularly (regularity {:.3f})", regularity.value)};
}

}  // namespace

Verdict classify(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds, Creak creak) {
    const analysis::Rates& rates = evidence.judged_rates;
    const JudgedFigures figures = figures_of(evidence, thresholds);
    Verdict verdict;
    verdict.evidence = evidence;
    verdict.margins = margins_of(evidence, figures, thresholds);
    const auto decide = [&](const Decision& decision) {
        verdict.category = decision.category;
        verdict.quiet = decision.quiet;
        verdict.reasons.push_back(decision.reason);
        if (decision.quiet == Quiet::locks) return verdict;
        if (const auto warning = pressing_warning(evidence, thresholds)) verdict.warnings.push_back(*warning);
        return verdict;
    };

    if (!(evidence.judged_time > 0.0))
        return decide({Category::undecided, Quiet::no, "no complete phase lies in the window"});
    if (evidence.creeps && thresholds.creeping == parameters::Creeping::undecided)
        return decide({Category::undecided, Quiet::no,
                       "its friction is regularised: it creeps where it should stick, so its states say nothing of a "
                       "rubbing contact; verdict.creeping = \"judged\" judges them all the same"});
    if (const std::optional<Decision> creep = creeping(evidence)) return decide(*creep);
    if (const std::optional<Decision> over = settled(evidence, thresholds)) return decide(*over);
    const bool grows = !std::isnan(evidence.ending.outlook.growth);
    if (grows && rates.slip >= 1.0) return decide(growing(evidence.ending.outlook));
    const Side slides = side_of(figures.slip, thresholds.quiet_slip, thresholds);
    if (slides == Side::open) return decide(doubted("slip share", figures.slip, thresholds.quiet_slip, "quiet_slip"));
    const bool alternates = keeps_alternating(evidence, thresholds);
    if (slides == Side::above && !grows && !alternates)
        return decide(none(Quiet::slides,
                           fmt::format("{} of the judged time, and nothing alternates", percent_text(rates.slip))));
    if (rates.stick >= 1.0) return decide(stuck(evidence, thresholds));
    verdict.reasons.push_back(
        slides != Side::above ? fmt::format("slips only {} of the judged time", percent_text(rates.slip))
        : grows               ? growth_text(evidence.ending.outlook)
                : fmt::format("slips {} of the judged time, but ends that again and again", percent_text(rates.slip)));
    const Side sticks = side_of(figures.stick, thresholds.creak_stick, thresholds);
    const bool may_creak = creak == Creak::possible;
    if (may_creak && sticks == Side::open)
        return decide(doubted("stick share", figures.stick, thresholds.creak_stick, "creak_stick"));
    if (may_creak && sticks == Side::above) return decide(sticking(evidence, figures, thresholds));
    if (analysis::stays_off(evidence))
        return decide(
            {Category::undecided, Quiet::no,
             fmt::format("lifts off at {} and stays off to the end of the run", seconds(evidence.ending.since))});
    const Decision decision = alternating(evidence, figures, thresholds);
    if (decision.category == Category::squeak)
        if (const std::optional<std::string> reason = shortcoming(evidence, figures, thresholds))
            verdict.reasons.push_back(*reason);
    return decide(decision);
}

Verdict classify_phase(const record::Tally& phase, const parameters::Thresholds& thresholds,
                       const ContactNames& names) {
    return classify_all(phase, thresholds, names).whole;
}

std::vector<Verdict> classify_phases(std::span<const record::Tally> phases, const parameters::Thresholds& thresholds,
                                     const ContactNames& names) {
    std::vector<Verdict> verdicts;
    for (const record::Tally& phase : phases)
        verdicts.push_back(classify_phase(phase, thresholds, names));
    return verdicts;
}

}  // namespace stridor::classification
