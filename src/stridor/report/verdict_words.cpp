#include "stridor/report/verdict_words.hpp"

#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/sweep/starts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stridor::report {

namespace {

using classification::Category;
using classification::Verdict;

std::string_view phase_words(record::Phase phase) {
    switch (phase) {
        case record::Phase::going:
            return "While the surface is going (V > 0)";
        case record::Phase::coming:
            return "While the surface is coming (V < 0)";
        case record::Phase::all:
            break;
    }
    return "While the surface moves";
}

std::string share(double rate) {
    return fmt::format("{:.0f}\u00A0%", 100.0 * rate);
}

// ", about 428 times a second"
std::string often(const analysis::Evidence& e) {
    if (!std::isfinite(e.alternation.frequency)) return "";
    const double frequency = e.alternation.frequency;
    return ", about " + fmt::format(fmt::runtime(frequency < 1000.0 ? "{:.3g}" : "{:.0f}"), frequency) +
           " times a second";
}

std::string what_happens(const Verdict& verdict) {
    const analysis::Evidence& e = verdict.evidence;
    switch (verdict.category) {
        case Category::none:
            if (verdict.quiet == classification::Quiet::locks)
                return "the contact makes no noise, and is no quiet design: it digs in. It " + verdict.reasons.back();
            return verdict.quiet == classification::Quiet::sticks
                       ? "the contact stays quiet: it sticks, and is carried along"
                       : "the contact stays quiet: it slides steadily";
        case Category::squeal:
            return "the contact squeals: it changes between slip, stick and separation with great regularity" +
                   often(e);
        case Category::squeak:
            return "the contact squeaks: it changes between slip, stick and separation without a steady beat" +
                   often(e);
        case Category::creak:
            return "the contact creaks: it sticks most of the time and lets go in short slips" + often(e);
        case Category::undecided:
            break;
    }
    return "there is no verdict: " +
           (verdict.reasons.empty() ? std::string("the evidence is too thin") : verdict.reasons.back());
}

}  // namespace

std::string plain_words(const Verdict& verdict) {
    const analysis::Evidence& e = verdict.evidence;
    std::string text = fmt::format("{} {}.", phase_words(e.phase), what_happens(verdict));
    if (verdict.category != Category::undecided)
        text += fmt::format(" Of the judged time it slips {}, sticks {} and is separated {}.",
                            share(e.judged_rates.slip), share(e.judged_rates.stick), share(e.judged_rates.separation));
    return text;
}

std::string phase_name(const Verdict& verdict) {
    return std::string(record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)]);
}

std::string start_words(const std::vector<parameters::Initial>& starts) {
    std::vector<std::string> names;
    for (const parameters::Initial start : starts)
        names.emplace_back(sweep::start_names()[static_cast<std::size_t>(start)]);
    return base::listed(names);
}

std::string judged_words(const advice::DesignSpace& space) {
    std::vector<std::string> ways;
    for (const record::Phase phase : space.phases)
        ways.emplace_back(record::phase_names[static_cast<std::size_t>(phase)]);
    return base::listed(ways) + ", from " + start_words(advice::starts_of(space));
}

std::string measured(std::string_view key, double value) {
    const std::string_view unit = parameters::unit_of(key);
    return fmt::format("{:.4g}{}", value, unit == "1" ? "" : " " + std::string(unit));
}

}  // namespace stridor::report
