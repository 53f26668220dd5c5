#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/recorder.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

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

/// Says whether it ended with a verdict: completed or settled.
constexpr bool has_result(const Outcome& outcome) {
    return outcome.reason == Reason::completed || outcome.reason == Reason::settled;
}

/// Where the energy of a run came from and went [J].
///
///     stored = preload_work + drive_work - dashpot_loss - friction_loss - impact_loss + residual
///
/// The residual is what the numbers created (positive) or lost (negative): rounding for the central difference,
/// numerical damping for beta_2 > 0.5. It is a monitor of the computation, not of the model.
struct EnergyBalance {
    double stored = 0.0;         // change of kinetic and elastic energy
    double preload_work = 0.0;   // work of the constant load f0
    double drive_work = 0.0;     // work of the imposed motion, T V, or of an imposed force
    double dashpot_loss = 0.0;   // v.C v
    double friction_loss = 0.0;  // -T w
    double impact_loss = 0.0;    // -N g', spent when surfaces meet
    double residual = 0.0;       // what is left over
    double held = 0.0;           // the largest that springs, masses and the preload held at a time, a bound
    double carried = 0.0;        // what the load would do while the fastest mode turns by a radian, were it not carried

    /// Returns the residual as a share of all energy that went in or out [1], the turnover.
    ///
    /// Rounding makes 1e-16 of the energy held, whether any of it is turned over or not: a turnover below a thousandth
    /// of it counts as that thousandth, so that a motion in which nothing happens has a residual of 1e-13 and not of 1.
    /// Contacts that carry a load cancel it but for rounding, too. That is in the energy held where springs give way,
    /// and is not where nothing does.
    double relative_residual() const;
};

/// Returns `unbalanced` instead of a result whose relative residual is above `most_unexplained`, `diverged` instead of
/// one whose balance is no number: velocities may still be numbers where their squares no longer are.
Outcome weighed(const Outcome& outcome, const EnergyBalance& balance, double most_unexplained);

/// Returns what the other terms of a balance leave over [J]: its residual.
double unexplained(const EnergyBalance& balance);

/// A proof that a motion slips for ever: bounds that hold from `time` on.
struct Silence {
    double time = 0.0;           // [s]
    double normal_force = 0.0;   // [N] N never falls below this
    double slip_velocity = 0.0;  // [m/s] |w| never falls below this
};

/// A motion that repeats itself: from `time` on it is continued by whole periods.
struct LimitCycle {
    double time = 0.0;      // [s] when the second of two equal periods ended
    double period = 0.0;    // [s]
    double residual = 0.0;  // [1] distance of the states one period apart, as a share of the velocities
    int events = 0;         // [1] changes of contact state or of the slip's direction, and impacts, per period
};

/// The run of the same case with contacts that have no inertia, to compare.
struct MasslessTwin {
    Outcome outcome;
    std::vector<record::Tally> phases;
};

/// A run: how it ended, its energy balance and what was kept of it.
struct Motion {
    Outcome outcome;
    EnergyBalance energy;
    record::Record record;
    std::optional<Silence> silence = std::nullopt;   // why it ended early, if it settled
    std::optional<LimitCycle> cycle = std::nullopt;  // likewise
    // of a run of the Taylor engine without a result: what each contact did where it ended, shape [contact]
    std::vector<model::ContactState> last_set{};
    std::vector<std::size_t> pressed{};  // of one that ended as `painleve`: contacts that friction presses without end
    std::optional<MasslessTwin> massless = std::nullopt;  // where both formulations were asked for
};

}  // namespace stridor::integration
