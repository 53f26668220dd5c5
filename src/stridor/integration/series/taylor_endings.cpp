// A run over a surface of constant velocity ends before its time once it is proven that all contacts slip for ever, or
// once it has repeated itself. The rest of its record is filled by what is known then.

#include "stridor/integration/series/taylor_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::integration {

namespace {

// a proof costs about as much as so many blocks for each mode; the next is tried after twice as long
constexpr long blocks_before_proof = 16;

}  // namespace

// is the motion linear as long as no contact changes? Else a set is not proven to last
bool TaylorRun::is_linear() const {
    if (!structure_.springs.empty()) return false;
    for (std::size_t k = 0; k < state_.set.size(); ++k)
        if (is_slip(state_.set[k]) && !is_state_wise(structure_.contacts[k].friction)) return false;
    return true;
}

bool TaylorRun::watch_for_silence() {
    if (!may_end_early_ || structure_.modes() > most_proven_modes) return false;
    const long wait = blocks_before_proof * static_cast<long>(structure_.modes());
    const long rounds = ++blocks_since_event_ / wait;
    if (blocks_since_event_ % wait != 0 || (rounds & (rounds - 1)) != 0) return false;
    if (!std::all_of(state_.set.begin(), state_.set.end(), is_slip) || !is_linear()) return false;
    LastingSet set(structure_, state_.set, surface(time_)[0]);
    silence_ = set.silence(state_.q, state_.v, time_);
    if (!silence_) return false;
    final_balance_ = energy();
    fill_with_silence(set);
    return true;
}

void TaylorRun::fill_with_silence(LastingSet& set) {
    surface_ = surface(time_);
    while (span_ < spans().size()) {
        const record::Span span = spans()[span_];
        const bool is_kept = record::is_judged(span.use);
        for (long block = 0; is_kept && block < steps_sampled_for_peaks && time_ < span.to; ++block) {
            if (!block_.choose(state_.set)) break;
            block_.expand(state_.q, state_.v, state_.friction_states, surface_);
            const double left = (span.to - time_) / step_;
            const double theta = std::min({1.0, block_.reach(), left});
            account(theta);
            move(theta);
            time_ = theta < left ? time_ + theta * step_ : span.to;
        }
        if (time_ < span.to) {
            const LastingSet::Passed passed = set.pass(state_.q, state_.v, span.to - time_);
            state_.q.assign(passed.q.data(), passed.q.data() + passed.q.size());
            state_.v.assign(passed.v.data(), passed.v.data() + passed.v.size());
            for (std::size_t channel = 0; is_kept && channel < sums_.vibration.size(); ++channel)
                sums_.vibration[channel].square_time += passed.square_time(static_cast<Eigen::Index>(channel));
            for (std::size_t k = 0; is_kept && k < passed.loads.size(); ++k)
                sums_.load[structure_.number[k]] += passed.loads[k];
            time_ = span.to;
        }
        end_span();
    }
}

// a share of the velocities
double TaylorRun::distance(const Event& a, const Event& b) const {
    double difference = 0.0, scale = std::abs(drive_.profile().velocity);
    for (std::size_t j = 0; j < a.q.size(); ++j) {
        difference +=
            std::sqrt(std::abs(structure_.square_frequency[j])) * std::abs(a.q[j] - b.q[j]) + std::abs(a.v[j] - b.v[j]);
        scale += std::abs(a.v[j]);
    }
    for (const ModalSpring& spring : structure_.springs) {
        const double from = elongation(spring, a.q), to = elongation(spring, b.q);
        const double slope = std::max(std::abs(stiffness_of(spring.law, from)), std::abs(stiffness_of(spring.law, to)));
        difference += std::sqrt(slope) * std::abs(from - to);
    }
    // a limit that still grows is no return: it only rises, but what it ends may come later
    for (std::size_t k = 0; k < a.grown.size(); ++k)
        difference += std::abs(a.grown[k] - b.grown[k]) * scale;
    return difference / scale;
}

bool TaylorRun::watch_for_cycle(const std::stop_token& stop) {
    if (!may_end_early_) return false;
    using Finding = ReturnWatch<Event>::Finding;
    std::vector<double> grown;
    for (std::size_t k = 0; k < state_.rested.size(); ++k)
        grown.push_back(model::grown(structure_.contacts[k].rest, state_.rested[k]));
    const Finding finding = watch_.note({time_, state_.set, state_.q, state_.v, std::move(grown)},
                                        [this](const Event& a, const Event& b) { return distance(a, b); });
    is_measuring_ = watch_.is_returning();
    if (finding == Finding::first_return) {
        period_ = {std::vector<record::Vibration>(sums_.vibration.size()),
                   std::vector<record::Load>(sums_.load.size())};
        period_changes_.clear();
    }
    if (finding != Finding::cycle) return false;
    const Return<Event>& found = watch_.found();
    cycle_ = LimitCycle{time_, time_ - found.first.time, found.distance, found.length};
    final_balance_ = energy();
    fill_with_cycle(cycle_->period, stop);
    return true;
}

void TaylorRun::fill_with_cycle(double duration, const std::stop_token& stop) {
    repeat_period(period_changes_, duration, spans().back().to, recorder_, stop);
    for (; span_ < spans().size(); end_span()) {
        const double count = (spans()[span_].to - time_) / duration;
        if (record::is_judged(spans()[span_].use)) {
            for (std::size_t channel = 0; channel < sums_.vibration.size(); ++channel) {
                record::Vibration& sum = sums_.vibration[channel];
                sum.square_time += count * period_.vibration[channel].square_time;
                sum.peak_square = std::max(sum.peak_square, period_.vibration[channel].peak_square);
            }
            for (std::size_t k = 0; k < sums_.load.size(); ++k) {
                sums_.load[k].normal_impulse += count * period_.load[k].normal_impulse;
                sums_.load[k].friction_loss += count * period_.load[k].friction_loss;
                sums_.load[k].largest_force = std::max(sums_.load[k].largest_force, period_.load[k].largest_force);
            }
        }
        time_ = spans()[span_].to;
    }
}

std::vector<record::Outlook> TaylorRun::outlooks(const Outcome& outcome) const {
    std::vector<record::Outlook> known(structure_.number.size(), proven_outlook(silence_, cycle_));
    if (has_friction_states()) {
        for (std::size_t k = 0; k < known.size(); ++k) {
            const ModalContact& contact = structure_.contacts[k];
            const bool is_told = contact.creep_speed > 0.0 && !is_creeping(k);
            if (has_friction_state(contact.friction) && !is_told)
                known[structure_.number[k]].future = record::Future::creeps;
        }
        return known;
    }
    const bool may_know =
        outcome.reason == Reason::completed && is_steady_ && structure_.modes() <= most_proven_modes && is_linear();
    if (!may_know) return known;
    const LastingSet set(structure_, state_.set, surface(outcome.time)[0]);
    std::vector<double> since;
    for (const std::size_t contact : structure_.number)
        since.push_back(recorder_.since(contact));
    const std::vector<record::Outlook> found = set.outlooks(state_.q, state_.v, outcome.time, since);
    for (std::size_t k = 0; k < found.size(); ++k)
        known[structure_.number[k]] = found[k];
    return known;
}

}  // namespace stridor::integration
