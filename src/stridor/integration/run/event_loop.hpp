#pragma once

#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/record/recorder.hpp"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

/// What engines that go from event to event share: samples, events that pile up, and what follows from a proof.
namespace stridor::integration {

/// [1] of the turnover. The balance of such an engine closes to rounding, 1.4e-10 in the wildest of 20000 cases; a
/// motion whose residual is far above that has no meaning.
inline constexpr double most_unexplained = 1e-9;

/// So many steps are sampled for peaks where a span begins after a proof of silence, a third of a second of Table 1:
/// friction makes the modes lean on each other, and a sum of decaying vibrations may first grow.
inline constexpr long steps_sampled_for_peaks = 1024;

/// The samples of a trace, by number.
struct SampleTimes {
    double interval = 0.0;  // [s]
    long next = 0;
    long last = -1;

    bool has_next() const { return next <= last; }
    double next_time() const { return static_cast<double>(next) * interval; }  // [s]
};

/// Returns the samples that are asked for, those within rounding of the trace's ends included.
inline SampleTimes sample_times(const record::TraceRequest& trace) {
    if (!(trace.interval > 0.0)) return {};
    return {trace.interval, static_cast<long>(std::ceil(trace.from / trace.interval - 1e-6)),
            static_cast<long>(std::floor(trace.to / trace.interval + 1e-6))};
}

/// Counts events that double precision cannot tell apart.
class PileUp {
public:
    /// Notes an event at `now` [s]; returns whether more than a thousand came within a thousandth of a step [s].
    bool note(double now, double step) {
        if (now - begin_ > window * step) {
            begin_ = now;
            events_ = 0;
        }
        return ++events_ > most_events;
    }

    void pass(Memory& pass) { pass(begin_), pass(events_); }

private:
    static constexpr double window = 1e-3;  // [1] of a step
    static constexpr int most_events = 1000;

    double begin_ = 0.0;  // [s]
    int events_ = 0;
};

/// A contact enters a state.
struct ContactChange {
    std::size_t contact = 0;
    record::ContactInterval interval;
};

/// Repeats the changes of one period, of some duration [s], until the run's end or until it is to stop: a long run
/// repeats a short period a thousand million times. Changes stand in the order of time.
void repeat_period(std::span<const ContactChange> period, double duration, double end, record::Recorder& recorder,
                   const std::stop_token& stop);

/// Returns what a proof says of the time after it; without a proof, that nothing is known.
record::Outlook proven_outlook(const std::optional<Silence>& silence, const std::optional<LimitCycle>& cycle);

}  // namespace stridor::integration
