#pragma once

#include "stridor/parameters/case.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace stridor::record {

/// The direction of the plate: `all` for a constant drive (its direction is in the velocity's sign).
enum class Phase { all, going, coming };

inline constexpr std::array<std::string_view, 3> phase_names{"all", "going", "coming"};

/// The use of a stretch of time.
enum class Use {
    unused,   // before the window: counted nowhere
    counted,  // in the window, but near a reversal or the run's start: counts for the whole phase's rates only
    judged,   // the steady part, from which the verdict is made
    closing,  // judged, too: its last part under a constant drive, when a motion that dies away is weakest
};

/// Says whether the verdict is made from it. The closing part counts too.
constexpr bool is_judged(Use use) {
    return use >= Use::judged;
}

/// A stretch of time with one use.
struct Span {
    double from = 0.0;  // [s]
    double to = 0.0;    // [s]
    Phase phase = Phase::all;
    Use use = Use::unused;
};

/// Time cut into spans, from 0 to the end of the run, without gaps, in order.
///
/// With a constant drive the window is judged, without its part in the share `start` of the run. Otherwise each
/// complete going or coming phase loses the share `settling` at its start and `reversal` at its end; phases cut short
/// by the window are counted but not judged.
struct Schedule {
    std::vector<Span> spans;
    std::vector<Phase> phases;  // those that occur, going before coming
};

/// Returns when a run ends [s]; 0 without spans.
double end_of(const Schedule& schedule);

/// Returns the schedule of a case's run, from t = 0 to its duration.
///
/// A constant drive has one phase, `all`. Any other is cut at its reversals into going and coming phases.
Schedule schedule(const parameters::Case& c);

}  // namespace stridor::record
