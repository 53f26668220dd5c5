#include "stridor/io/simulation/trace_texts.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stridor::io {

namespace {

constexpr double most_trace_samples = 2e6;  // 0.9 GB with the text of their file
constexpr double countable = 1e15;          // [1] intervals that a double counts

}  // namespace

record::TraceRequest trace_request(const TraceTexts& texts, const parameters::Case& c) {
    record::TraceRequest trace;
    trace.from = texts.from.empty() ? 0.0 : base::parse_quantity(texts.from, "s");
    trace.to = texts.to.empty() ? c.run.duration : base::parse_quantity(texts.to, "s");
    trace.interval = base::parse_quantity(texts.interval, "s");
    const bool is_ordered = trace.interval > 0.0 && trace.from <= trace.to;
    if (!is_ordered)
        throw Error(ErrorKind::input, {"the trace has no samples",
                                       "its interval must be positive and --trace-from before --trace-to", ""});
    const double samples = (trace.to - trace.from) / trace.interval;
    if (samples > most_trace_samples || !(std::abs(trace.to / trace.interval) <= countable))
        throw Error(ErrorKind::input,
                    {fmt::format("the trace has {:.3g} samples", samples),
                     fmt::format("a trace is kept in memory, {:.0f} samples at most", most_trace_samples),
                     "Lengthen --trace-interval, or shorten the time from --trace-from to --trace-to."});
    return trace;
}

}  // namespace stridor::io
