#include "stridor/classification/interface_rules.hpp"

#include "stridor/classification/contact_rules.hpp"
#include "stridor/parameters/system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace stridor::classification {

namespace {

std::string force_text(double force) {
    return std::abs(force) < 1e3 ? fmt::format("{:.3g} N", force) : fmt::format("{:.3g} kN", 1e-3 * force);
}

std::string way_text(double way) {
    return way < 1.0 ? fmt::format("{:.3g} mm", 1e3 * way) : fmt::format("{:.3g} m", way);
}

// ", 62 times the preload of 8 N"
std::string multiple_text(double force, double preload) {
    return fmt::format(", {:.3g} times the preload of {}", force / preload, force_text(preload));
}

bool exceeds(double force, const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    return evidence.preload > 0.0 && force > thresholds.lock_force * evidence.preload;
}

// some contacts of an interface, by their number within it
using Some = std::vector<std::size_t>;

analysis::Rates weighted(const InterfaceVerdict& verdict, const Some& some,
                         const std::function<analysis::Rates(const analysis::Evidence&)>& rates) {
    analysis::Rates sum;
    double load = 0.0;
    for (const std::size_t k : some) {
        const double share = verdict.figures.loads[k].share;
        const analysis::Rates own = rates(verdict.contacts[k]->evidence);
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
    // the errors of contacts of one interface are not independent: at worst they add up
    evidence.judged_errors = weighted(verdict, some, &analysis::Evidence::judged_errors);
    if (evidence.judged_step_change)
        evidence.judged_step_change = weighted(verdict, some, [](const analysis::Evidence& e) {
            return e.judged_step_change.value_or(analysis::Rates{});
        });
    return evidence;
}

bool does_lock(const Verdict& verdict) {
    return verdict.quiet == Quiet::locks;
}

// "left lip", or "contact 2" where it has no name
std::string called(const Verdict& verdict, const ContactNames& names) {
    const std::size_t contact = verdict.evidence.contact;
    return names.empty() ? fmt::format("contact {}", contact + 1) : names.at(contact);
}

// "contact 2 locks: ..."
std::string lock_words(const Verdict& verdict, const ContactNames& names) {
    return called(verdict, names) + " " + verdict.reasons.back();
}

Verdict quiet_verdict(const InterfaceVerdict& verdict, const Some& loaded, const parameters::Thresholds& thresholds,
                      const ContactNames& names) {
    const auto sticks = [&](std::size_t k) { return verdict.contacts[k]->quiet == Quiet::sticks; };
    const auto stuck = std::count_if(loaded.begin(), loaded.end(), sticks);
    const bool all_stick = stuck == static_cast<std::ptrdiff_t>(loaded.size());
    const std::size_t leading = leader(verdict, loaded);
    Verdict whole = classify(evidence_of(verdict, loaded, leading), thresholds);
    whole.category = Category::none;
    whole.quiet = all_stick ? Quiet::sticks : Quiet::slides;
    const auto locked =
        std::find_if(loaded.begin(), loaded.end(), [&](std::size_t k) { return does_lock(*verdict.contacts[k]); });
    if (locked != loaded.end()) {
        whole.quiet = Quiet::locks;
        whole.reasons = {lock_words(*verdict.contacts[*locked], names)};
        return whole;
    }
    whole.reasons = {fmt::format("quiet because each of its {} loaded contacts is: {} slide, {} stick", loaded.size(),
                                 static_cast<std::ptrdiff_t>(loaded.size()) - stuck, stuck)};
    return whole;
}

// the largest standard error that a mean of shares between 0 and 1 can have over so many times of being free [1]
double largest_scatter(double share, long times) {
    return std::sqrt(share * (1.0 - share) / static_cast<double>(std::max(times, 1L)));
}

Verdict noisy_verdict(const InterfaceVerdict& verdict, const Some& noisy, const parameters::Thresholds& thresholds) {
    const std::size_t leading = leader(verdict, noisy);
    const analysis::Evidence evidence = evidence_of(verdict, noisy, leading);
    const double together = verdict.free_together;
    const bool is_micro_slip = together < most_of_the_load;
    Verdict whole = classify(evidence, thresholds, is_micro_slip ? Creak::impossible : Creak::possible);
    const bool repeats = evidence.ending.outlook.future == record::Future::repeats;
    const double error = repeats ? 0.0 : largest_scatter(together, evidence.releases);
    if (std::abs(together - most_of_the_load) < thresholds.least_distance * error) {
        const Verdict other = classify(evidence, thresholds, is_micro_slip ? Creak::possible : Creak::impossible);
        if (other.category != whole.category) {
            whole.category = Category::undecided;
            whole.reasons = {
                fmt::format("{:.0f} % of the load of its contacts is free at once, give or take {:.0f} %: "
                            "too near to {:.0f} % to tell a release from slip one by one; use a longer "
                            "run.window",
                            100.0 * together, 100.0 * error, 100.0 * most_of_the_load)};
            return whole;
        }
    }
    if (is_micro_slip && evidence.judged_rates.stick >= thresholds.creak_stick)
        whole.reasons.insert(
            whole.reasons.begin(),
            fmt::format("contacts slip one by one, {:.0f} % of their load at once: no creak", 100.0 * together));
    return whole;
}

// what has left the surface, and is silent so
bool is_off(const Verdict& verdict) {
    return verdict.category == Category::undecided && analysis::stays_off(verdict.evidence);
}

// the contact whose normal force exceeds its preload most, if one does by too much
const Verdict* most_pressed(const PhaseVerdicts& all) {
    const auto multiple = [](const Verdict& verdict) {
        return verdict.evidence.largest_force / verdict.evidence.preload;
    };
    const Verdict* most = nullptr;
    for (const std::optional<Verdict>& verdict : all.contacts)
        if (verdict && !verdict->warnings.empty() && (most == nullptr || multiple(*verdict) > multiple(*most)))
            most = &*verdict;
    return most;
}

// a contact that locks is what the phase comes to, unless others are noisy: then it is a warning
void heed_contacts(PhaseVerdicts& all, const std::vector<Verdict>& wholes, const ContactNames& names) {
    const auto locked =
        std::find_if(all.contacts.begin(), all.contacts.end(),
                     [](const std::optional<Verdict>& verdict) { return verdict && does_lock(*verdict); });
    all.whole.warnings.clear();
    if (locked == all.contacts.end()) {
        if (const Verdict* pressed = most_pressed(all))
            all.whole.warnings = {called(*pressed, names) + ": " + pressed->warnings.back()};
        return;
    }
    const bool is_silent = std::all_of(wholes.begin(), wholes.end(), [](const Verdict& whole) {
        return whole.category == Category::none || is_off(whole);
    });
    const std::string words = lock_words(**locked, names);
    if (!is_silent) {
        all.whole.warnings = {words};
        return;
    }
    const auto off = std::count_if(all.contacts.begin(), all.contacts.end(),
                                   [](const std::optional<Verdict>& verdict) { return verdict && is_off(*verdict); });
    all.whole = **locked;
    all.whole.reasons = {words};
    if (off > 0)
        all.whole.reasons.push_back(fmt::format(
            "{} lifted off and stay{} off",
            off == 1 ? std::string("1 contact has") : fmt::format("{} contacts have", off), off == 1 ? "s" : ""));
}

// undecided, with a figure whose error reaches its threshold: it may be of any category
bool is_doubted(const Verdict& verdict, const parameters::Thresholds& thresholds) {
    const auto is_open = [&](const Margin& margin) {
        return margin.error && std::abs(margin.distance) < thresholds.least_distance * *margin.error;
    };
    return verdict.category == Category::undecided &&
           std::any_of(verdict.margins.begin(), verdict.margins.end(), is_open);
}

}  // namespace

std::optional<std::string> locking(const analysis::Evidence& evidence, const parameters::Thresholds& thresholds) {
    if (!analysis::sticks_for_good(evidence)) return std::nullopt;
    const record::Drag& drag = evidence.ending.outlook.drag;
    const std::string proven = evidence.ending.outlook.future == record::Future::sticks ? " (proven)" : "";
    if (drag.slope > 0.0)
        return fmt::format("locks: N rises from {} to {} over {} and goes on by {}/mm{}", force_text(drag.from),
                           force_text(drag.to), way_text(drag.way), force_text(1e-3 * drag.slope), proven);
    if (exceeds(drag.to, evidence, thresholds))
        return fmt::format("locks: N goes from {} to {} over each stroke of {}{}{}", force_text(drag.from),
                           force_text(drag.to), way_text(drag.way), multiple_text(drag.to, evidence.preload), proven);
    if (exceeds(evidence.largest_force, evidence, thresholds))
        return fmt::format("locks: N reaches {}{}", force_text(evidence.largest_force),
                           multiple_text(evidence.largest_force, evidence.preload));
    return std::nullopt;
}

std::optional<std::string> pressing_warning(const analysis::Evidence& evidence,
                                            const parameters::Thresholds& thresholds) {
    const analysis::Rates& rates = evidence.judged_rates;
    const bool follows_the_way = rates.stick >= thresholds.creak_stick || rates.slip >= thresholds.quiet_slip;
    if (!follows_the_way || !exceeds(evidence.largest_force, evidence, thresholds)) return std::nullopt;
    return fmt::format("N reaches {}{}: the contact digs in (sprag-slip)", force_text(evidence.largest_force),
                       multiple_text(evidence.largest_force, evidence.preload));
}

ContactNames contact_names(const parameters::Case& c) {
    ContactNames names;
    for (std::size_t contact = 0; contact < parameters::contact_count(c); ++contact)
        names.push_back(parameters::contact_name(c, contact));
    return names;
}

InterfaceVerdict classify_interface(const record::Tally& phase, std::size_t interface,
                                    const parameters::Thresholds& thresholds, const ContactNames& names) {
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
        noisy.empty() ? quiet_verdict(verdict, loaded, thresholds, names) : noisy_verdict(verdict, noisy, thresholds);
    return verdict;
}

PhaseVerdicts classify_all(const record::Tally& phase, const parameters::Thresholds& thresholds,
                           const ContactNames& names) {
    PhaseVerdicts all;
    all.contacts.resize(phase.contacts.size());
    std::vector<bool> is_alone(phase.contacts.size(), true);
    std::vector<Verdict> wholes;
    for (std::size_t interface = 0; interface < phase.interfaces.size(); ++interface) {
        all.interfaces.push_back(classify_interface(phase, interface, thresholds, names));
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
    // what a doubted contact may be is as loud as any but a squeal
    const auto rank = [&](const Verdict& verdict) {
        return is_doubted(verdict, thresholds) ? 2 * loudness(Category::squeal) - 1 : 2 * loudness(verdict.category);
    };
    const auto quieter = [&](const Verdict& a, const Verdict& b) { return rank(a) < rank(b); };
    all.whole = *std::max_element(wholes.begin(), wholes.end(), quieter);
    if (phase.contacts.size() > 1) heed_contacts(all, wholes, names);
    return all;
}

}  // namespace stridor::classification
