#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/recorder.hpp"

#include <optional>
#include <vector>

namespace stridor::pictures {

/// The curves of a time history, a row of panels each.
enum class ShownSignal {
    imposed_velocity,  // V
    displacement,      // of each degree of freedom
    velocity,
    acceleration,
    contact_forces,  // N and T
};

/// The curves of a time history, and their times.
struct TimeHistoryOptions {
    std::vector<ShownSignal> signals{ShownSignal::imposed_velocity, ShownSignal::acceleration};
    drawing::Extent whole{0.0, 0.0};      // [s] of the left column; empty: all of the trace
    std::optional<drawing::Extent> zoom;  // [s] of a second column beside it
};

/// Draws curves over time with the contact states below, and beside them a short stretch in which single slips, sticks
/// and separations can be seen (Elmaian et al. 2012, Figure 5). The caption says how often the contact leaves its
/// states there.
///
/// The record needs a trace and a history; the degrees of freedom are those of the rubbing system (x1, y1, y2).
drawing::Scene time_history(const parameters::Case& c, const record::Record& record,
                            const TimeHistoryOptions& options = {});

/// Returns the stretch of `length` seconds in which the contact changes its state most often, the first of equals:
/// within the judged parts of the run if there are two changes or more in one of them, else anywhere. `std::nullopt` if
/// the contact never changes.
std::optional<drawing::Extent> busiest_stretch(const parameters::Case& c,
                                               std::span<const record::ContactHistory> histories, double length);

/// Returns a stretch of `length` seconds in which several cases can be compared: the middle of a going phase's judged
/// part, or of the window if the drive is constant; cut to the run if that is shorter.
drawing::Extent telling_stretch(const parameters::Case& c, double length);

}  // namespace stridor::pictures
