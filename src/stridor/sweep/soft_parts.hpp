#pragma once

#include "stridor/sweep/study.hpp"

#include <array>
#include <string_view>

namespace stridor::sweep {

/// Soft parts of a car that rub. Table 1 of the paper is a stiff joint (10 and 1 kN/mm); a seal's lip is a thousand
/// times softer.
enum class SoftPart { weatherstrip, weatherstrip_shaken, glass_run, clip, wiper, brake_pad };

/// What a soft part is called, and what it is known to do.
struct SoftPartName {
    std::string_view name;      // "glass-run", as `stridor init` has it
    std::string_view sentence;  // what it is known to do in cars
};

/// In the order of `SoftPart`.
inline constexpr std::array<SoftPartName, 6> soft_part_names{{
    {"weatherstrip", "A door seal's lip on paint squeaks when it is dry or wet, and hums once its coating is worn."},
    {"weatherstrip-shaken",
     "The same lip, coated, under the small motions of a body that twists: it itches and ticks."},
    {"glass-run", "The lip of a glass run shudders and groans on a slow window, more so when wet or worn."},
    {"clip", "A plastic clip in its hole ticks and creaks under the slow motions of a trim panel."},
    {"wiper", "A wiper's lip chatters where it jumps off the glass, and squeals where it sticks and slips."},
    {"brake-pad", "A brake pad on its disc groans when the brake is let go slowly: stick-slip below 100 Hz."},
}};

/// A case of a soft part with the plane of two quantities that decide whether it is heard; 20 by 14 cells, both
/// directions.
///
/// The drive is constant and the second half is judged, but for `weatherstrip_shaken`: 0.5 mm at 12 Hz, judged by its
/// second second. The second half holds several tens of beats at the slowest mode. Values, ranges, sources, and what
/// of them is judgement: docs/methods/soft-parts.md.
Study soft_part(SoftPart part);

}  // namespace stridor::sweep
