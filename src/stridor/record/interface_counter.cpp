#include "stridor/record/interface_counter.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace stridor::record {

using model::ContactState;

namespace {

bool is_free(ContactState state) {
    return state != ContactState::stick;
}

}  // namespace

InterfaceCounter::InterfaceCounter(const Schedule& schedule, std::vector<std::size_t> contacts)
    : spans_(schedule.spans),
      clock_(schedule.phases.size(), 0.0),
      numbers_(std::move(contacts)),
      contacts_(numbers_.size(), {ContactState::separation, false, clock_}),
      state_since_(clock_),
      tallies_(schedule.phases.size()) {
    for (const Span& span : spans_) {
        const auto phase = std::find(schedule.phases.begin(), schedule.phases.end(), span.phase);
        phase_of_span_.push_back(static_cast<std::size_t>(phase - schedule.phases.begin()));
    }
    for (InterfaceTally& tally : tallies_) {
        tally.contacts = numbers_;
        tally.free_together.assign(numbers_.size() * numbers_.size(), 0.0);
    }
}

void InterfaceCounter::advance(double time) {
    while (span_ < spans_.size() && time_ < time) {
        const Span& span = spans_[span_];
        const double end = std::min(span.to, time);
        if (is_judged(span.use) && phase_of_span_[span_] < clock_.size())
            clock_[phase_of_span_[span_]] += std::max(0.0, end - time_);
        time_ = std::max(time_, end);
        if (end < span.to) return;
        ++span_;
    }
}

InterfaceState InterfaceCounter::state_now() const {
    const std::size_t stuck = in_state_[model::index_of(ContactState::stick)];
    const std::size_t sliding = in_state_[model::index_of(ContactState::slip)];
    if (stuck == 0) return sliding == 0 ? InterfaceState::open : InterfaceState::slides;
    return sliding == 0 ? InterfaceState::sticks : InterfaceState::partly;
}

void InterfaceCounter::close_interval() {
    for (std::size_t phase = 0; phase < clock_.size(); ++phase)
        tallies_[phase].state_time[static_cast<std::size_t>(state_)] += clock_[phase] - state_since_[phase];
    state_since_ = clock_;
}

// the time that a contact was free, with each other that is: of a pair the one that sticks first counts it
void InterfaceCounter::add_free(std::size_t contact) {
    const std::size_t n = contacts_.size();
    for (std::size_t other = 0; other < n; ++other) {
        const Contact& with = contacts_[other];
        if (!with.has_state || !is_free(with.state)) continue;
        for (std::size_t phase = 0; phase < clock_.size(); ++phase) {
            const double since = std::max(contacts_[contact].free_since[phase], with.free_since[phase]);
            std::vector<double>& together = tallies_[phase].free_together;
            together[contact * n + other] += clock_[phase] - since;
            if (other != contact) together[other * n + contact] = together[contact * n + other];
        }
    }
}

void InterfaceCounter::enter(std::size_t number, ContactState state, double time) {
    const auto found = std::lower_bound(numbers_.begin(), numbers_.end(), number);
    if (found == numbers_.end() || *found != number) return;
    const auto contact = static_cast<std::size_t>(found - numbers_.begin());
    advance(time);
    Contact& here = contacts_[contact];
    if (here.has_state && is_free(here.state) && !is_free(state)) add_free(contact);
    if (is_free(state) && !(here.has_state && is_free(here.state))) here.free_since = clock_;
    if (here.has_state) --in_state_[model::index_of(here.state)];
    ++in_state_[model::index_of(state)];
    here.state = state;
    here.has_state = true;
    if (state_now() == state_) return;
    close_interval();
    state_ = state_now();
}

std::vector<InterfaceTally> InterfaceCounter::finish(double time) {
    advance(time);
    close_interval();
    for (std::size_t contact = 0; contact < contacts_.size(); ++contact) {
        Contact& here = contacts_[contact];
        if (!here.has_state || !is_free(here.state)) continue;
        add_free(contact);
        here.has_state = false;  // of a pair the first counts it
    }
    return std::move(tallies_);
}

std::vector<InterfaceCounter> interface_counters(const Schedule& schedule, const std::vector<int>& interfaces) {
    std::map<int, std::vector<std::size_t>> members;
    for (std::size_t contact = 0; contact < interfaces.size(); ++contact)
        if (interfaces[contact] >= 0) members[interfaces[contact]].push_back(contact);
    std::vector<InterfaceCounter> counters;
    for (auto& [interface, contacts] : members)
        if (contacts.size() > 1) counters.emplace_back(schedule, std::move(contacts));
    return counters;
}

}  // namespace stridor::record
