#pragma once

#include "stridor/record/trace.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

/// The first step that does not begin before a time [s], rounding aside.
inline long step_at(double time, double step) {
    return static_cast<long>(std::ceil(time / step - 1e-6));
}

/// At which steps an engine of constant steps samples a trace.
struct StepSamples {
    long every = 0;  // steps; 0: none is asked for
    long next = -1;
    long last = -1;
};

inline StepSamples step_samples(const record::TraceRequest& trace, double step) {
    if (!(trace.interval > 0.0)) return {};
    return {std::max(1L, std::lround(std::min(trace.interval / step, 1e15))), step_at(trace.from, step),
            step_at(trace.to, step)};
}

}  // namespace stridor::integration
