#include "stridor/integration/run/event_loop.hpp"

namespace stridor::integration {

void repeat_period(std::span<const ContactChange> period, double duration, double end, record::Recorder& recorder,
                   const std::stop_token& stop) {
    if (period.empty()) return;
    for (double number = 1.0; !stop.stop_requested(); ++number)
        for (ContactChange change : period) {
            change.interval.from += number * duration;
            if (change.interval.from >= end) return;
            recorder.enter(change.contact, change.interval);
        }
}

record::Outlook proven_outlook(const std::optional<Silence>& silence, const std::optional<LimitCycle>& cycle) {
    if (silence) return {record::Future::slides, silence->time};
    if (cycle) return {.future = record::Future::repeats, .from = cycle->time, .period = cycle->period};
    return {};
}

}  // namespace stridor::integration
