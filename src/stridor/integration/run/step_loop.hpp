#pragma once

#include "stridor/integration/run/motion.hpp"
#include "stridor/model/structure.hpp"
#include "stridor/record/recorder.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// What engines with constant steps share: spans, samples, and the comparison with twice the step.
namespace stridor::integration {

/// Returns the first step that does not begin before a time [s], rounding aside.
inline long step_at(double time, double step) {
    return static_cast<long>(std::ceil(time / step - 1e-6));
}

/// At which steps an engine of constant steps samples a trace.
struct StepSamples {
    long every = 0;  // steps; 0: none is asked for
    long next = -1;
    long last = -1;

    bool is_within(long step) const { return next >= step && next <= last; }

    /// Returns whether this step is sampled, and goes on to the next sample if so.
    bool take(long step) {
        if (step != next || next > last) return false;
        next += every;
        return true;
    }
};

/// Returns the steps nearest to the samples that are asked for.
inline StepSamples step_samples(const record::TraceRequest& trace, double step) {
    if (!(trace.interval > 0.0)) return {};
    return {std::max(1L, std::lround(std::min(trace.interval / step, 1e15))), step_at(trace.from, step),
            step_at(trace.to, step)};
}

/// Takes a run through the spans of its schedule. `go_to` takes it to a step within a span of this use, and returns an
/// outcome where it ends early. The run has
///
///     long steps() const                                           the number of the next step
///     void begin_span()
///     void end_span(std::size_t span, long steps, double length)   after so many steps and so long [s]
///
/// A span between two steps has none of its own.
template <typename Run, typename GoTo>
std::optional<Outcome> run_spans(Run& run, const record::Recorder& recorder, double step, GoTo go_to) {
    const std::vector<record::Span>& spans = recorder.schedule().spans;
    StepSamples samples = step_samples(recorder.request().trace, step);
    for (std::size_t k = 0; k < spans.size(); ++k) {
        const long begin = run.steps();
        run.begin_span();
        if (const std::optional<Outcome> ended = go_to(step_at(spans[k].to, step), spans[k].use, samples)) return ended;
        const long steps = run.steps() - begin;
        run.end_span(k, steps, steps > 0 ? static_cast<double>(steps) * step : spans[k].to - spans[k].from);
    }
    return std::nullopt;
}

/// Makes a run by time steps of so many seconds [s], into a recorder.
using StepRun = std::function<Motion(double step, record::Recorder recorder)>;

/// Returns a recorder of the same run that keeps tallies alone.
record::Recorder tallies_of(const record::Recorder& recorder, const model::Structure& structure);

/// Returns the run at the step h, with the tallies of the same at 2 h beside its own (`ContactTally::coarser`): by how
/// much figures change with the step is about their error at h.
///
/// A run at 2 h without a result takes that of h away, too.
Motion run_twice(const StepRun& run, double step, const model::Structure& structure, record::Recorder recorder);

}  // namespace stridor::integration
