#pragma once

#include <array>
#include <string_view>

namespace stridor::integration {

/// How a run ended. Only a completed or settled run has a verdict.
enum class Reason {
    completed,   // ran to its end
    settled,     // ended early with a proof that nothing changes any more
    diverged,    // a number left double precision
    step_limit,  // the time step lies beyond the scheme's stability limit: not run
    cancelled,   // stopped on request
    chattering,  // events pile up without time going on
    unbalanced,  // its energy balance does not close: what it moved by was rounding
    no_forces,   // no contact states and forces were found that obey all laws of contact at once
    painleve,    // there are none: friction presses contacts together without end
};

inline constexpr std::array<std::string_view, 9> reason_names{
    "completed", "settled", "diverged", "step_limit", "cancelled", "chattering", "unbalanced", "no_forces", "painleve"};

/// How a run ended, and when.
struct Outcome {
    Reason reason = Reason::completed;
    double time = 0.0;  // [s] up to which the motion is known
};

/// Did it end with a verdict: completed or settled?
constexpr bool has_result(const Outcome& outcome) {
    return outcome.reason == Reason::completed || outcome.reason == Reason::settled;
}

}  // namespace stridor::integration
