#include "stridor/record/recorder.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace stridor::record {

namespace {

constexpr double parting = std::numeric_limits<double>::quiet_NaN();

void append(Instants& instants, double time) {
    const std::size_t most = 2 * Instants::kept;
    if (instants.times.size() >= most)
        instants.times.erase(instants.times.begin(),
                             instants.times.begin() + static_cast<std::ptrdiff_t>(Instants::kept));
    instants.times.push_back(time);
}

void add(std::vector<Vibration>& sum, std::span<const Vibration> more) {
    for (std::size_t dof = 0; dof < more.size(); ++dof) {
        sum[dof].square_time += more[dof].square_time;
        sum[dof].peak_square = std::max(sum[dof].peak_square, more[dof].peak_square);
    }
}

}  // namespace

Recorder::Recorder(Schedule schedule, Request request, int dofs, int contacts, int channels,
                   const std::vector<int>& interfaces)
    : schedule_(std::move(schedule)),
      request_(std::move(request)),
      places_(static_cast<std::size_t>(contacts)),
      interfaces_(interface_counters(schedule_, interfaces)) {
    for (const Phase phase : schedule_.phases) {
        Tally tally;
        tally.phase = phase;
        tally.contacts.resize(places_.size());
        tally.vibration.resize(static_cast<std::size_t>(channels > 0 ? channels : dofs));
        tally.closing_vibration.resize(tally.vibration.size());
        record_.phases.push_back(std::move(tally));
    }
    record_.histories.resize(places_.size());
    record_.trace = empty_trace(dofs, contacts);
}

Tally* Recorder::tally_of(Phase phase) {
    const auto found = std::find_if(record_.phases.begin(), record_.phases.end(),
                                    [&](const Tally& tally) { return tally.phase == phase; });
    return found == record_.phases.end() ? nullptr : &*found;
}

// the judged stretch that a span belongs to: with what closes it, and what it closes
Span Recorder::stretch_of(std::size_t span) const {
    const std::vector<Span>& spans = schedule_.spans;
    Span stretch = spans[span];
    if (stretch.use == Use::closing && span > 0 && spans[span - 1].use == Use::judged)
        stretch.from = spans[span - 1].from;
    if (stretch.use == Use::judged && is_closed_by_next(span)) stretch.to = spans[span + 1].to;
    return stretch;
}

bool Recorder::is_closed_by_next(std::size_t span) const {
    return span + 1 < schedule_.spans.size() && schedule_.spans[span + 1].use == Use::closing;
}

// shares out judged time among the parts of its stretch
void Recorder::count_judged(std::size_t contact, double from, double to) {
    Place& place = places_[contact];
    const std::size_t state = model::index_of(place.current.state);
    const Span stretch = stretch_of(place.span);
    const double length = (stretch.to - stretch.from) / static_cast<double>(stretch_parts);
    auto part = static_cast<std::size_t>(std::max(0.0, (from - stretch.from) / length));
    for (; part + 1 < stretch_parts && from < to; ++part) {
        const double end = std::clamp(stretch.from + static_cast<double>(part + 1) * length, from, to);
        place.stretch[part][state] += end - from;
        from = end;
    }
    place.stretch[stretch_parts - 1][state] += to - from;
}

// the next judged span is another stretch of time: no interval reaches across
void Recorder::end_stretch(std::size_t contact, ContactTally& tally) {
    for (Instants& instants : tally.changes)
        if (!instants.times.empty()) append(instants, parting);
    if (tally.stretches.size() == kept_stretches) tally.stretches.erase(tally.stretches.begin());
    tally.stretches.push_back(std::exchange(places_[contact].stretch, {}));
    ++tally.judged_stretches;
}

// shares out the time of a contact from where it was counted to, until `to`, among the spans it crosses
void Recorder::count(std::size_t contact, double to) {
    Place& place = places_[contact];
    const std::size_t state = model::index_of(place.current.state);
    while (place.span < schedule_.spans.size() && place.counted_to < to) {
        const Span& span = schedule_.spans[place.span];
        const double end = std::min(span.to, to);
        const double begin = std::max(span.from, place.counted_to);
        const double length = std::max(0.0, end - begin);
        Tally* phase = span.use == Use::unused ? nullptr : tally_of(span.phase);
        ContactTally* tally = phase == nullptr ? nullptr : &phase->contacts[contact];
        if (tally != nullptr) tally->time[state] += length;
        if (tally != nullptr && is_judged(span.use)) {
            tally->judged_time[state] += length;
            if (length > 0.0) count_judged(contact, begin, end);
        }
        place.counted_to = std::max(place.counted_to, end);
        if (end < span.to) break;
        if (tally != nullptr && is_judged(span.use) && !is_closed_by_next(place.span)) end_stretch(contact, *tally);
        ++place.span;
    }
}

void Recorder::note_change(std::size_t contact, model::ContactState to, double time) {
    const Place& place = places_[contact];
    if (place.span >= schedule_.spans.size()) return;
    const Span& span = schedule_.spans[place.span];
    if (span.use == Use::unused || time < span.from) return;
    ContactTally& tally = tally_of(span.phase)->contacts[contact];
    const model::ContactState from = place.current.state;
    if (from == model::ContactState::stick) ++tally.releases;
    if (!is_judged(span.use)) return;
    Instants& instants = tally.changes[change_kind(from, to)];
    append(instants, time);
    ++instants.count;
}

void Recorder::keep_current(std::size_t contact, double to) {
    ContactInterval& current = places_[contact].current;
    current.to = to;
    if (request_.history == KeepHistory::no || kept_ > most_history) return;
    record_.histories[contact].push_back(current);
    ++kept_;
}

void Recorder::enter(std::size_t contact, const ContactInterval& interval) {
    STRIDOR_EXPECT(contact < places_.size());
    Place& place = places_[contact];
    STRIDOR_EXPECT(!place.has_state || interval.from >= place.current.from);
    if (place.has_state) {
        count(contact, interval.from);
        note_change(contact, interval.state, interval.from);
        keep_current(contact, interval.from);
    }
    place.current = interval;
    place.has_state = true;
    for (InterfaceCounter& counter : interfaces_)
        counter.enter(contact, interval.state, interval.from);
}

void Recorder::vibrate(std::size_t span, double duration, std::span<const Vibration> vibration) {
    if (span >= schedule_.spans.size() || !is_judged(schedule_.spans[span].use)) return;
    Tally& tally = *tally_of(schedule_.spans[span].phase);
    tally.vibration_time += duration;
    add(tally.vibration, vibration);
    if (schedule_.spans[span].use != Use::closing) return;
    tally.closing_time += duration;
    add(tally.closing_vibration, vibration);
}

void Recorder::load(std::size_t span, std::span<const Load> loads) {
    if (span >= schedule_.spans.size() || !is_judged(schedule_.spans[span].use)) return;
    Tally& tally = *tally_of(schedule_.spans[span].phase);
    for (std::size_t contact = 0; contact < loads.size(); ++contact)
        tally.contacts[contact].load += loads[contact];
}

void Recorder::sample(const Sample& sample) {
    if (request_.trace.taker && record_.trace.time.size() >= trace_block) hand_over();
    record::append(record_.trace, sample);
}

// the taker has the samples then, and the trace is empty
void Recorder::hand_over() {
    request_.trace.taker(record_.trace);
    clear(record_.trace);
}

Record Recorder::finish(double time, const std::vector<Outlook>& outlooks) {
    STRIDOR_EXPECT(outlooks.empty() || outlooks.size() == places_.size());
    if (request_.trace.taker && !record_.trace.time.empty()) hand_over();
    for (std::size_t contact = 0; contact < places_.size(); ++contact) {
        Place& place = places_[contact];
        if (place.has_state) {
            // steps add up to the run's end but for rounding
            const double end = end_of(schedule_);
            count(contact, std::abs(end - time) <= 1e-9 * end ? end : time);
            keep_current(contact, time);
        }
        place.has_state = false;
        const Outlook outlook = outlooks.empty() ? Outlook{} : outlooks[contact];
        for (Tally& tally : record_.phases)
            tally.contacts[contact].ending = {place.current.state, place.current.from, outlook};
    }
    for (InterfaceCounter& counter : interfaces_) {
        std::vector<InterfaceTally> tallies = counter.finish(time);
        for (std::size_t phase = 0; phase < record_.phases.size(); ++phase)
            record_.phases[phase].interfaces.push_back(std::move(tallies[phase]));
    }
    if (kept_ > most_history)
        throw Error(ErrorKind::input, {"the run has more than " + std::to_string(most_history) + " contact states",
                                       "a history is kept in memory", "Shorten run.duration."});
    return std::move(record_);
}

}  // namespace stridor::record
