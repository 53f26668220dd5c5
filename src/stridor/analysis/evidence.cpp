#include "stridor/analysis/evidence.hpp"

#include "stridor/analysis/share_errors.hpp"
#include "stridor/base/check.hpp"

#include <cmath>

namespace stridor::analysis {

namespace {

Rates change(const Rates& from, const Rates& to) {
    return {std::abs(to.slip - from.slip), std::abs(to.stick - from.stick), std::abs(to.separation - from.separation)};
}

}  // namespace

Evidence evidence(const record::Tally& tally, std::size_t contact) {
    STRIDOR_EXPECT(contact < tally.contacts.size());
    const record::ContactTally& one = tally.contacts[contact];
    Evidence figures;
    figures.phase = tally.phase;
    figures.contact = contact;
    figures.window_time = one.time[0] + one.time[1] + one.time[2];
    figures.judged_time = one.judged_time[0] + one.judged_time[1] + one.judged_time[2];
    figures.rates = rates(one.time);
    figures.judged_rates = rates(one.judged_time);
    figures.judged_errors = share_errors(one);
    figures.alternation = alternation(one.changes);
    for (std::size_t to = 0; to < model::contact_states; ++to)
        figures.releases +=
            one.changes[record::change_kind(model::ContactState::stick, static_cast<model::ContactState>(to))].count;
    figures.all_releases = one.releases;
    figures.ending = one.ending;
    figures.preload = one.preload;
    figures.largest_force = one.load.largest_force;
    if (one.coarser) {
        figures.step_change = change(rates(one.coarser->time), figures.rates);
        figures.judged_step_change = change(rates(one.coarser->judged_time), figures.judged_rates);
        figures.coarser = alternation(one.coarser->changes);
    }
    const bool is_over = slides_for_good(figures) || sticks_for_good(figures);
    const Along along = sticks_for_good(figures) ? Along::carried : Along::counted;
    figures.levels = levels(tally, contact, is_over && tally.closing_time > 0.0 ? Part::closing : Part::judged, along);
    return figures;
}

bool sticks_for_good(const Evidence& evidence) {
    const record::Future future = evidence.ending.outlook.future;
    const bool sticks_throughout = evidence.judged_rates.stick >= 1.0 && future != record::Future::releases;
    return future == record::Future::sticks || sticks_throughout;
}

bool slides_for_good(const Evidence& evidence) {
    const record::Outlook& outlook = evidence.ending.outlook;
    const bool slides_throughout = evidence.judged_rates.slip >= 1.0 && std::isnan(outlook.growth);
    return outlook.future == record::Future::slides || slides_throughout;
}

bool stays_off(const Evidence& evidence) {
    return evidence.judged_rates.separation > 0.0 && evidence.alternation.intervals == 0 &&
           evidence.ending.state == model::ContactState::separation;
}

}  // namespace stridor::analysis
