#include "stridor/classification/interface_rules.hpp"

#include "stridor/classification/contact_rules.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stridor::classification {

namespace {

// some contacts of an interface, by their number within it
using Some = std::vector<std::size_t>;

analysis::Rates weighted(const InterfaceVerdict& verdict, const Some& some,
                         analysis::Rates analysis::Evidence::*rates) {
    analysis::Rates sum;
    double load = 0.0;
    for (const std::size_t k : some) {
        const double share = verdict.figures.loads[k].share;
        const analysis::Rates& own = verdict.contacts[k]->evidence.*rates;
        sum.slip += share * own.slip;
        sum.stick += share * own.stick;
        sum.separation += share * own.separation;
        load += share;
    }
    return {sum.slip / load, sum.stick / load, sum.separation / load};
}

// of those with enough evidence, if there are any, the one that turns most power into heat
std::size_t leader(const InterfaceVerdict& verdict, const Some& some) {
    const auto follows = [&](std::size_t a, std::size_t b) {
        const bool a_is_thin = verdict.contacts[a]->category == Category::undecided;
        const bool b_is_thin = verdict.contacts[b]->category == Category::undecided;
        if (a_is_thin != b_is_thin) return a_is_thin;
        return verdict.figures.loads[a].friction_power < verdict.figures.loads[b].friction_power;
    };
    return *std::max_element(some.begin(), some.end(), follows);
}

analysis::Evidence evidence_of(const InterfaceVerdict& verdict, const Some& some, std::size_t leading) {
    analysis::Evidence evidence = verdict.contacts[leading]->evidence;
    evidence.rates = weighted(verdict, some, &analysis::Evidence::rates);
    evidence.judged_rates = weighted(verdict, some, &analysis::Evidence::judged_rates);
    return evidence;
}

Verdict quiet_verdict(const InterfaceVerdict& verdict, const Some& loaded, const parameters::Thresholds& thresholds) {
    const auto sticks = [&](std::size_t k) { return verdict.contacts[k]->quiet == Quiet::sticks; };
    const auto stuck = std::count_if(loaded.begin(), loaded.end(), sticks);
    const bool all_stick = stuck == static_cast<std::ptrdiff_t>(loaded.size());
    const std::size_t leading = leader(verdict, loaded);
    Verdict whole = classify(evidence_of(verdict, loaded, leading), thresholds);
    whole.category = Category::none;
    whole.quiet = all_stick ? Quiet::sticks : Quiet::slides;
    whole.reasons = {fmt::format("quiet because each of its {} loaded contacts is: {} slide, {} stick", loaded.size(),
                                 static_cast<std::ptrdiff_t>(loaded.size()) - stuck, stuck)};
    return whole;
}

Verdict noisy_verdict(const InterfaceVerdict& verdict, const Some& noisy, const parameters::Thresholds& thresholds) {
    const std::size_t leading = leader(verdict, noisy);
    const analysis::Evidence evidence = evidence_of(verdict, noisy, leading);
    const bool is_micro_slip = verdict.free_together < most_of_the_load;
    Verdict whole = classify(evidence, thresholds, is_micro_slip ? Creak::impossible : Creak::possible);
    if (is_micro_slip && evidence.judged_rates.stick >= thresholds.creak_stick)
        whole.reasons.insert(whole.reasons.begin(),
                             fmt::format("contacts slip one by one, {:.0f} % of their load at once: no creak",
                                         100.0 * verdict.free_together));
    return whole;
}

}  // namespace

InterfaceVerdict classify_interface(const record::Tally& phase, std::size_t interface,
                                    const parameters::Thresholds& thresholds) {
    InterfaceVerdict verdict;
    verdict.figures = analysis::interface_of(phase, interface);
    Some loaded, noisy;
    for (std::size_t k = 0; k < verdict.figures.contacts.size(); ++k) {
        verdict.contacts.emplace_back();
        if (!verdict.figures.loads[k].is_loaded) continue;
        verdict.contacts[k] = classify(analysis::evidence(phase, verdict.figures.contacts[k]), thresholds);
        loaded.push_back(k);
        if (verdict.contacts[k]->category != Category::none) noisy.push_back(k);
        verdict.differs |= verdict.contacts[k]->category != verdict.contacts[loaded.front()]->category;
    }
    verdict.free_together = analysis::free_together(phase.interfaces[interface], verdict.figures, noisy);
    verdict.whole =
        noisy.empty() ? quiet_verdict(verdict, loaded, thresholds) : noisy_verdict(verdict, noisy, thresholds);
    return verdict;
}

PhaseVerdicts classify_all(const record::Tally& phase, const parameters::Thresholds& thresholds) {
    PhaseVerdicts all;
    all.contacts.resize(phase.contacts.size());
    std::vector<bool> is_alone(phase.contacts.size(), true);
    std::vector<Verdict> wholes;
    for (std::size_t interface = 0; interface < phase.interfaces.size(); ++interface) {
        all.interfaces.push_back(classify_interface(phase, interface, thresholds));
        const InterfaceVerdict& verdict = all.interfaces.back();
        wholes.push_back(verdict.whole);
        for (std::size_t k = 0; k < verdict.contacts.size(); ++k) {
            all.contacts[verdict.figures.contacts[k]] = verdict.contacts[k];
            is_alone[verdict.figures.contacts[k]] = false;
        }
    }
    for (std::size_t contact = 0; contact < phase.contacts.size(); ++contact) {
        if (!is_alone[contact]) continue;
        all.contacts[contact] = classify(analysis::evidence(phase, contact), thresholds);
        wholes.push_back(*all.contacts[contact]);
    }
    const auto quieter = [](const Verdict& a, const Verdict& b) { return loudness(a.category) < loudness(b.category); };
    all.whole = *std::max_element(wholes.begin(), wholes.end(), quieter);
    return all;
}

}  // namespace stridor::classification
