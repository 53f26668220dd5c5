#include "stridor/record/recorder.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"

#include <algorithm>
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

Recorder::Recorder(Schedule schedule, Request request, int dofs)
    : schedule_(std::move(schedule)),
      request_(std::move(request)) {
    const auto size = static_cast<std::size_t>(dofs);
    for (const Phase phase : schedule_.phases) {
        Tally tally;
        tally.phase = phase;
        tally.vibration.resize(size);
        tally.closing_vibration.resize(size);
        record_.phases.push_back(std::move(tally));
    }
    record_.trace.displacement.resize(size);
    record_.trace.velocity.resize(size);
    record_.trace.acceleration.resize(size);
}

Tally* Recorder::tally_of(Phase phase) {
    const auto found = std::find_if(record_.phases.begin(), record_.phases.end(),
                                    [&](const Tally& tally) { return tally.phase == phase; });
    return found == record_.phases.end() ? nullptr : &*found;
}

// shares out the time from counted_to_ to `to` among the spans it crosses
void Recorder::count(double to) {
    const std::size_t state = model::index_of(current_.state);
    while (span_ < schedule_.spans.size() && counted_to_ < to) {
        const Span& span = schedule_.spans[span_];
        const double end = std::min(span.to, to);
        const double length = std::max(0.0, end - std::max(span.from, counted_to_));
        Tally* tally = span.use == Use::unused ? nullptr : tally_of(span.phase);
        if (tally != nullptr) tally->time[state] += length;
        if (tally != nullptr && is_judged(span.use)) tally->judged_time[state] += length;
        counted_to_ = std::max(counted_to_, end);
        if (end < span.to) break;
        // the next judged span of this phase is another stretch of time, unless it closes this one: no interval
        // reaches across
        const bool goes_on = span_ + 1 < schedule_.spans.size() && schedule_.spans[span_ + 1].use == Use::closing;
        if (tally != nullptr && is_judged(span.use) && !goes_on)
            for (Instants& instants : tally->changes)
                if (!instants.times.empty()) append(instants, parting);
        ++span_;
    }
}

void Recorder::note_change(model::ContactState from, model::ContactState to, double time) {
    if (span_ >= schedule_.spans.size()) return;
    const Span& span = schedule_.spans[span_];
    if (span.use == Use::unused || time < span.from) return;
    Tally& tally = *tally_of(span.phase);
    if (from == model::ContactState::stick) ++tally.releases;
    if (!is_judged(span.use)) return;
    Instants& instants = tally.changes[change_kind(from, to)];
    append(instants, time);
    ++instants.count;
}

void Recorder::keep_current(double to) {
    current_.to = to;
    if (request_.history == KeepHistory::yes && record_.history.size() <= most_history)
        record_.history.push_back(current_);
}

void Recorder::enter(const ContactInterval& interval) {
    STRIDOR_EXPECT(!has_state_ || interval.from >= current_.from);
    if (has_state_) {
        count(interval.from);
        note_change(current_.state, interval.state, interval.from);
        keep_current(interval.from);
    }
    current_ = interval;
    has_state_ = true;
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

Trace& Recorder::trace() {
    if (request_.trace.taker && record_.trace.time.size() >= trace_block) hand_over();
    return record_.trace;
}

// the taker has the samples then, and the trace is empty
void Recorder::hand_over() {
    Trace& trace = record_.trace;
    request_.trace.taker(trace);
    for (auto* vectors : {&trace.displacement, &trace.velocity, &trace.acceleration})
        for (std::vector<double>& samples : *vectors)
            samples.clear();
    for (auto* samples : {&trace.time, &trace.surface_velocity, &trace.normal_force, &trace.friction_force, &trace.gap})
        samples->clear();
    trace.state.clear();
}

Record Recorder::finish(double time, const Outlook& outlook) {
    if (request_.trace.taker && !record_.trace.time.empty()) hand_over();
    if (has_state_) {
        count(time);
        keep_current(time);
    }
    has_state_ = false;
    for (Tally& tally : record_.phases)
        tally.ending = {current_.state, current_.from, outlook};
    if (record_.history.size() > most_history)
        throw Error(ErrorKind::input, {"the run has more than " + std::to_string(most_history) + " contact states",
                                       "a history is kept in memory", "Shorten run.duration."});
    return std::move(record_);
}

}  // namespace stridor::record
