#pragma once

#include "stridor/chart/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <optional>
#include <vector>

namespace stridor::chart {

/// What a time history shows, a row of panels per curve.
enum class Signal {
    imposed_velocity,  // V
    displacement,      // of each degree of freedom
    velocity,
    acceleration,
    contact_forces,  // N and T
};

struct TimeHistoryOptions {
    std::vector<Signal> signals{Signal::imposed_velocity, Signal::acceleration};
    Range whole{0.0, 0.0};      // [s] of the left column; empty: all of the trace
    std::optional<Range> zoom;  // [s] of a second column beside it
};

/// Curves over time with the contact states below, and beside them a short stretch of the same, in which single slips,
/// sticks and separations can be seen (Elmaian et al. 2012, Figure 5).
///
/// The record needs a trace and a history; the degrees of freedom are those of the rubbing system (x1, y1, y2).
Scene time_history(const parameters::Case& c, const record::Record& record, const TimeHistoryOptions& options = {});

/// A stretch of `length` seconds worth a zoom: the middle of a going phase's judged part, or of the window where the drive
/// is constant; cut to the run where that is shorter.
Range telling_stretch(const parameters::Case& c, double length);

}  // namespace stridor::chart
