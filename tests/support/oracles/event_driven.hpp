#pragma once

#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <vector>

namespace stridor::support {

/// A motion of the rubbing system computed by code of its own: classic Runge-Kutta steps within a contact state,
/// changes of state found by bisection. It shares no line with src/stridor/model or src/stridor/integration.
struct IndependentMotion {
    record::ContactHistory history;               // [s] states one after the other
    std::vector<double> time;                     // [s] shape [sample]
    std::vector<std::array<double, 3>> position;  // [m] (x1, y1, y2), shape [sample]
};

/// Runs a case (constant or sinusoidal drive, started at rest or stuck) with steps [s] and samples every so many steps.
IndependentMotion event_driven(const parameters::Case& c, double step, int sample_every);

}  // namespace stridor::support
