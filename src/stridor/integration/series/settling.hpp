#pragma once

#include "stridor/integration/rules/contact_mode_of.hpp"
#include "stridor/integration/run/end_state.hpp"
#include "stridor/integration/run/motion.hpp"
#include "stridor/integration/series/taylor_block.hpp"
#include "stridor/record/tally.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::integration {

inline constexpr std::size_t most_functions = 3;
inline constexpr int most_dropped = 4;  // an event looks at no higher coefficients

/// Functions of a contact that stay positive as long as its state lasts: open, g; slip, N and sigma w; stick, N and the
/// friction that is left each way, mu N - T backward and mu N + T forward.
constexpr std::size_t event_functions(ContactMode mode) {
    return mode == ContactMode::open ? 1 : mode == ContactMode::stick ? 3 : 2;
}

/// Where a motion is, at an instant and after all that happens there.
struct TaylorState {
    std::vector<double> q;  // shape [mode]
    std::vector<double> v;  // [1/s] of q, shape [mode]
    ContactSet set;         // shape [contact]
    // of each event function the number of first coefficients that are zero: the event it began with
    std::vector<std::array<int, most_functions>> dropped;  // shape [contact]
    // [s] for which each contact has stuck, 0 for others; shape [contact]; empty: rest changes nothing
    std::vector<double> rested{};
    std::vector<double> friction_states{};  // shape [contact]; 0 of an open one: it closes with that
};

/// What counts as zero of the coefficients of an event function: those that the state itself gives (gap and its rate,
/// slip velocity), and those that come from forces and accelerations.
struct FunctionZero {
    int of_state = 0;  // coefficients
    double first = 0.0;
    double later = 0.0;
};

/// How an event ended.
enum class Settled {
    done,
    pressed,       // no set of states obeys all laws, since friction presses contacts together without end: Painleve
    inconsistent,  // none was found
};

/// What happens at an event, the same rules for any number of contacts:
///
/// 1. Gaps that close: impulses of all touching contacts at once (`contact_impulses`).
/// 2. Forces and accelerations: each event function must begin positive, that is its first coefficient which is not
///    zero. The worst violated contact, of the lowest order, changes. A contact that broke its limit of friction is
///    held against the limit of the slip until the others have changed, too; then it sticks again if it can. From 1
///    again if a gap closes. Single changes run in a circle where a contact that stuck would be pulled open and one
///    that was open would fall: then all sets are tried, those with the fewest changes first.
///    A contact with a friction state never sticks: it slips the way in which it begins to move.
/// 3. Flights that begin and slips which would end within a millionth of a block are ended at once: pile-ups of impacts
///    have a limit, and this is it. Where no forces belong to it they go on.
class Settling {
public:
    Settling(const ModalStructure& structure, double step);

    /// Returns the contact's function has become zero.
    Settled fire(TaylorState& state, const SurfaceSeries& surface, std::size_t contact, std::size_t function);

    /// Finds what the contacts do from their gaps and velocities: at a start, and where the drive has a corner.
    Settled settle(TaylorState& state, const SurfaceSeries& surface);

    /// Takes rounding out of closed gaps, their rates, and the slip of stuck contacts, at right angles under the mass.
    /// Returns the normal impulses [N*s] that change the velocities so, shape [contact].
    std::vector<double> project(TaylorState& state, const SurfaceSeries& surface) const;

    /// Returns what is zero of the coefficients c of an event function, of a block that was expanded from the state.
    FunctionZero zero_of(const TaylorBlock& block, const TaylorState& state, std::size_t contact, std::size_t function,
                         const BlockSeries& c) const;

    /// Ends at once, from now on, flights and slips that would end within this share of a block are ended at once.
    void end_within(double share) { soon_ = share; }

    /// Returns what impacts have taken and brought so far [J].
    const EnergyBalance& losses() const { return losses_; }

    /// Returns what impacts have done to the contacts since this was called before, shape [contact].
    std::vector<record::Load> take_impacts();

    /// Passes what an event leaves to the next one.
    void pass(Memory& pass) { pass(begins_), pass(soon_), pass(losses_), pass(completed_); }

    /// Returns contacts that pile-ups have closed so far.
    long completed() const { return completed_; }

    /// Returns the pressed contacts after an event that ended as `pressed`.
    const std::vector<std::size_t>& pressed() const { return pressed_; }

private:
    enum class Forces { found, closing, inconsistent };
    struct Violation;
    struct Lawful;

    bool meet(TaylorState& state, const SurfaceSeries& surface, std::size_t fired);
    bool collide(TaylorState& state, const SurfaceSeries& surface, std::size_t fired);
    Forces find_forces(TaylorState& state, const SurfaceSeries& surface);
    Forces change_one_by_one(TaylorState& state, const SurfaceSeries& surface);
    bool could_stick(TaylorState& state, const SurfaceSeries& surface, std::size_t contact);
    bool stick_again(TaylorState& state, const SurfaceSeries& surface, std::vector<bool>& has_tried);
    bool find_any(TaylorState& state, const SurfaceSeries& surface);
    bool complete(TaylorState& state, const SurfaceSeries& surface);
    void hold_ended(TaylorState& state, const SurfaceSeries& surface);
    void correct_modes(TaylorState& state, const SurfaceSeries& surface);
    void look(const TaylorState& state, std::size_t contact, Violation& worst);
    std::vector<ModalContact> rubbing_as_now(const TaylorState& state, const SurfaceSeries& surface) const;
    Settled failed(const TaylorState& state, const SurfaceSeries& surface);
    Settled go_on(TaylorState& state, const SurfaceSeries& surface);

    const ModalStructure& structure_;
    TaylorBlock block_;
    std::vector<bool> broken_;  // limits that fell during this event
    std::vector<bool> begins_;  // slips that this event has begun: w = 0
    std::size_t closing_ = 0;   // the contact whose gap closes, where `Forces` says so
    std::vector<std::array<int, most_functions>> orders_;
    std::vector<std::vector<ContactMode>> possible_;  // where no set was found: those looked at, shape [contact][mode]
    std::vector<std::size_t> pressed_;
    double soon_ = 1e-6;  // [1] of a block
    EnergyBalance losses_;
    std::vector<record::Load> impacts_;  // shape [contact]
    long completed_ = 0;
};

/// Returns coefficients of an event function over a block that was expanded for the set. `has_broken`: the limit of
/// friction is that of the slip.
BlockSeries event_series(const ModalStructure& structure, const TaylorBlock& block, std::size_t contact,
                         ContactMode mode, std::size_t function, bool has_broken = false);

/// A stretch of a block.
struct BlockStretch {
    double from = 0.0;  // [1]
    double to = 1.0;    // [1] above it
};

/// Adds to an event function of a stick what rest has added to its limit, times N: by the chord over that stretch of
/// the block. The limit lies above its chords and below what they are beyond: so a zero of the sum comes no later than
/// that of the function, and from where the function stays positive not before it.
void add_growth(const ModalContact& contact, const TaylorBlock& block, const BlockSeries& normal_force, double rested,
                const BlockStretch& stretch, BlockSeries& function);

inline constexpr int settling_order = 6;            // of the series that decide at an event
inline constexpr double function_rounding = 1e-11;  // [1] of the largest coefficient: what is zero
inline constexpr double term_rounding = 1e-14;      // [1] of the sum of the terms' sizes, likewise
inline constexpr double gap_rounding = 1e-12;       // [1] likewise, of gaps
// what counts as zero of a friction beyond its limit must count as zero of the slip that it leaves: c_m theta^m there
// is h W_tt c_m theta^(m+1)/(m+1) here, with m up to the order of the series
inline constexpr double slip_per_friction = settling_order + 1;  // [1] of the roundings above

/// Returns the size below which a gap is zero [m]: of rounding, and of what its rate changes in a step of time [s].
inline double gap_zero(const ModalContact& c, const TaylorState& state, double step) {
    return gap_rounding * (dot_of_sizes(c.normal, state.q) + std::abs(c.initial_gap)) +
           term_rounding * step * dot_of_sizes(c.normal, state.v);
}

/// Returns the size below which a slip velocity is zero [m/s].
inline double slip_zero(const ModalContact& c, const TaylorState& state, const SurfaceSeries& surface) {
    return function_rounding * (dot_of_sizes(c.tangent, state.v) + std::abs(c.drive_share * surface[0]));
}

/// Returns what a contact does that is closed and has no slip velocity, if it does not slip already: it sticks, or may
/// creep.
inline ContactMode resting_mode(const ModalContact& contact) {
    return has_friction_state(contact.friction) ? ContactMode::slip_forward : ContactMode::stick;
}

/// Returns what a contact does that closes: it slips the way it moves, or rests.
inline ContactMode closed_mode(const ModalContact& contact, const TaylorState& state, const SurfaceSeries& surface) {
    const double w = slip_velocity(contact, state.v, surface[0]);
    return std::abs(w) > slip_zero(contact, state, surface) ? slip_mode(model::slip_of(w)) : resting_mode(contact);
}

}  // namespace stridor::integration
