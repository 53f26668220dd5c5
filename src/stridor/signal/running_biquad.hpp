#pragma once

#include "stridor/signal/filter.hpp"

namespace stridor::signal {

/// One section of a filter at work, from rest.
struct RunningBiquad {
    Biquad biquad{};
    double first = 0.0;   // what the next sample gets
    double second = 0.0;  // and the one after it

    /// Returns the next sample behind the section.
    double next(double x) {
        const double y = biquad.b0 * x + first;
        first = biquad.b1 * x - biquad.a1 * y + second;
        second = biquad.b2 * x - biquad.a2 * y;
        return y;
    }
};

}  // namespace stridor::signal
