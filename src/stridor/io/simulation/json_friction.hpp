#pragma once

#include "stridor/analysis/friction_trace.hpp"

#include <string>

namespace stridor::io {

/// What a friction trace was measured with, as far as it is known.
struct FrictionTest {
    std::string file;
    std::string channel;           // of the friction force
    std::string velocity_channel;  // empty: none
    std::string normal_channel;    // empty: none
    double rate = 0.0;             // [Hz]
    double duration = 0.0;         // [s]
    double preload = 0.0;          // [N]
    double velocity = 0.0;         // [m/s] nominal or the 95th percentile of the measured one; NaN where unknown
    std::string condition;         // of a standard test, in words; may be empty
};

/// "stridor.friction/1": coefficients and drops of a friction trace.
std::string friction_json(const FrictionTest& test, const analysis::FrictionTrace& trace);

}  // namespace stridor::io
