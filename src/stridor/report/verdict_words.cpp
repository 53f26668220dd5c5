#include "stridor/report/verdict_words.hpp"

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
    return fmt::format(", about {:.3g} times a second", e.alternation.frequency);
}

std::string what_happens(const Verdict& verdict) {
    const analysis::Evidence& e = verdict.evidence;
    switch (verdict.category) {
        case Category::none:
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
        text += fmt::format(" Of the judged time it slips {}, sticks {} and is apart {}.", share(e.judged_rates.slip),
                            share(e.judged_rates.stick), share(e.judged_rates.separation));
    return text;
}

std::string summary(const std::vector<Verdict>& verdicts) {
    std::string noisy;
    std::string quiet;
    for (const Verdict& verdict : verdicts) {
        if (verdict.category == Category::undecided) return "Not every direction of motion could be judged.";
        std::string& list = verdict.category == Category::none ? quiet : noisy;
        list += (list.empty() ? "" : " and ") +
                std::string(record::phase_names[static_cast<std::size_t>(verdict.evidence.phase)]);
    }
    if (noisy.empty()) return "The model predicts no noise of this design.";
    if (quiet.empty()) return "The model predicts noise of this design.";
    return "The model predicts noise of this design while " + noisy + ", and none while " + quiet + ".";
}

}  // namespace stridor::report
