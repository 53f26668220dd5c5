#pragma once

#include "stridor/sweep/study.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::sweep {

/// Returns Figure 8: categories over preload (2 to 4000 N, log) and kinetic friction (0 to 0.8), going and coming, at a
/// constant velocity of 0.1 m/s, started at rest; 40 by 40 cells. The paper prints no ranges; these show all its areas.
Study figure_8();

/// Returns Figure 6: contact-state rates over velocity (0.01 to 1 m/s, log) and preload (2 to 4000 N, log), going, for
/// an incidence angle of 70 or 150 deg; 30 by 30 cells.
Study figure_6(double incidence_angle);

/// Soft parts of a car that rub. Table 1 of the paper is a stiff joint (10 and 1 kN/mm); a seal's lip is a thousand
/// times softer.
enum class SoftPart { weatherstrip, weatherstrip_shaken, glass_run, clip, wiper, brake_pad };

/// The name of a soft part, and its known behaviour.
struct SoftPartName {
    std::string_view name;      // "glass-run", as `stridor init` has it
    std::string_view sentence;  // its known behaviour in cars
};

/// The soft parts in the order of `SoftPart`.
inline constexpr std::array<SoftPartName, 6> soft_part_names{{
    {"weatherstrip", "A door seal's lip on paint squeaks when it is dry or wet, and hums once its coating is worn."},
    {"weatherstrip-shaken",
     "The same lip, coated, under the small motions of a body that twists: it itches and ticks."},
    {"glass-run", "The lip of a glass run shudders and groans on a slow window, more so when wet or worn."},
    {"clip", "A plastic clip in its hole ticks and creaks under the slow motions of a trim panel."},
    {"wiper", "A wiper's lip chatters where it jumps off the glass, and squeals where it sticks and slips."},
    {"brake-pad", "A brake pad on its disc groans when the brake is let go slowly: stick-slip below 100 Hz."},
}};

/// Returns a case of a soft part with the plane of two quantities that decide whether it is heard; 20 by 14 cells, both
/// directions.
///
/// The drive is constant and the second half is judged, except for `weatherstrip_shaken`: 0.5 mm at 12 Hz, judged by
/// its second second. The second half holds several tens of beats at the slowest mode. Values, ranges, sources, and
/// which of them are estimates: docs/methods/soft-parts.md.
Study soft_part(SoftPart part);

/// The origin of a chart: a user's file, the paper's planes, or the planes of soft parts.
enum class PlaneSet { file, paper, soft };

inline constexpr std::array<std::string_view, 3> plane_set_names{"file", "paper", "soft"};

/// A chart that comes with the program.
struct ReadyChart {
    std::string name;  // "noise-chart", as `stridor init` has it
    PlaneSet set = PlaneSet::paper;
    Study study;
};

/// Returns the paper's planes (Figure 8, and Figure 6 at 70 deg), then those of the soft parts.
std::vector<ReadyChart> ready_charts();

// The chart around a case of which nobody named the axes: that of a report, and the first one of the page.

/// Returns the axis of a quantity over its usual range around a case (`parameters::usual_range`, which it must have).
/// The kinetic friction ends at the static one, the velocity is a magnitude.
Axis usual_axis(const parameters::Case& c, std::string_view key, int points);

/// Returns the usual two axes: preload, or stiffness if a load or gaps press, over kinetic friction, or the temperature
/// on which that depends. If a case has only one of these, the other axis is another quantity that presses or moves it.
std::pair<Axis, Axis> usual_axes(const parameters::Case& c, int points);

}  // namespace stridor::sweep
