#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/schedule.hpp"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace stridor::record {

/// One stay of a contact in one state, and how it was entered.
struct ContactInterval {
    model::ContactState state = model::ContactState::slip;
    double from = 0.0;           // [s]
    double to = 0.0;             // [s]
    double slip_velocity = 0.0;  // [m/s] w when the state began
    double gap_velocity = 0.0;   // [m/s] g' when the state began; negative: the surfaces met (an impact)
};

/// The whole life of one contact: states one after the other, without gaps, neighbours different.
using ContactHistory = std::vector<ContactInterval>;

/// A kind of change of state, (from, to), as one number in [0, contact_states^2).
inline constexpr std::size_t change_kinds = static_cast<std::size_t>(model::contact_states) * model::contact_states;

/// Returns the number of the change from one state to another.
constexpr std::size_t change_kind(model::ContactState from, model::ContactState to) {
    return model::index_of(from) * model::contact_states + model::index_of(to);
}

/// Most recent instants of one kind of change. A NaN parts instants that lie in different judged spans.
///
/// Bounded, so that a tally's size does not grow with the simulated time; `count` counts all of them.
struct Instants {
    static constexpr std::size_t kept = 4096;  // at least this many are kept, at most twice as many
    std::vector<double> times;                 // [s]
    long count = 0;                            // [1]
};

/// The latest instants of every kind of change, by its number.
using Changes = std::array<Instants, change_kinds>;

/// Vibration of one degree of freedom, or of one direction of a contact's point, over the judged time.
struct Vibration {
    double square_time = 0.0;  // [m^2/s] integral of v^2
    double peak_square = 0.0;  // [m^2/s^2] largest |v|^2 of the body it belongs to: the rubbing one has the first two
};

/// What is known of a contact beyond the end of its run, if the drive goes on as it did.
enum class Future {
    unknown,
    slides,    // proven: it slides for ever
    sticks,    // proven: it sticks for ever
    releases,  // it sticks, and proven: not for ever
    repeats,   // it repeats itself: a limit cycle
    creeps,    // its law of friction has a state: while it is closed it slips, however slowly
};

inline constexpr std::array<std::string_view, 6> future_names{"unknown",  "slides",  "sticks",
                                                              "releases", "repeats", "creeps"};

/// How the normal force of a stuck contact follows the way it is dragged: what the drive makes of it, without
/// vibration.
struct Drag {
    double from = std::numeric_limits<double>::quiet_NaN();   // [N] N where the stick began; sinusoidal: the least
    double to = std::numeric_limits<double>::quiet_NaN();     // [N] N at the end of the run; sinusoidal: the largest
    double way = std::numeric_limits<double>::quiet_NaN();    // [m] in between; sinusoidal: the stroke
    double slope = std::numeric_limits<double>::quiet_NaN();  // [N/m] how it goes on; sinusoidal: it does not
};

/// What an engine knows of the time after its run.
struct Outlook {
    Future future = Future::unknown;
    double from = std::numeric_limits<double>::quiet_NaN();     // [s] Future::slides: since when; else unknown
    double release = std::numeric_limits<double>::quiet_NaN();  // [s] Future::releases: about when; else unknown
    Drag drag{};                                                // of a contact that sticks; NaN where unknown
    // [1/s] of a small disturbance, where it slides and that grows; 0: nothing presses where it would slide to; else
    // unknown, or stable
    double growth = std::numeric_limits<double>::quiet_NaN();
    double grown = std::numeric_limits<double>::quiet_NaN();   // [s] about when that ends the sliding
    double period = std::numeric_limits<double>::quiet_NaN();  // [s] Future::repeats: of the cycle; else unknown
};

/// How a run ends for a contact, and how it would go on.
struct Ending {
    model::ContactState state = model::ContactState::separation;  // the last one
    double since = 0.0;                                           // [s] when it entered that
    Outlook outlook;
};

/// What a contact carried over some time, impacts included.
struct Load {
    double normal_impulse = 0.0;  // [N*s] integral of N, and the impulses of impacts
    double friction_loss = 0.0;   // [J] turned into heat: integral of |T w|
    double largest_force = 0.0;   // [N] largest N where a contact changes its state and at ends of spans, no impacts
};

constexpr Load& operator+=(Load& sum, const Load& more) {
    sum.normal_impulse += more.normal_impulse;
    sum.friction_loss += more.friction_loss;
    sum.largest_force = sum.largest_force > more.largest_force ? sum.largest_force : more.largest_force;
    return sum;
}

/// What the closed contacts of a structure do together. Open ones do not count as long as one is closed.
enum class InterfaceState { sticks, partly, slides, open };  // all stick; some do; none does; none is closed

inline constexpr std::array<std::string_view, 4> interface_state_names{"sticks", "partly", "slides", "open"};

/// What one phase leaves behind of the contacts of one interface together, judged part.
struct InterfaceTally {
    std::vector<std::size_t> contacts{};                            // their numbers, at least two, rising
    std::array<double, interface_state_names.size()> state_time{};  // [s] in each state
    std::vector<double> free_together{};                            // [s] two of them not stuck, shape [its][its]
};

/// What a phase leaves behind of one contact, as `ContactTally`, of the same run at twice the time step.
struct CoarserTally {
    std::array<double, model::contact_states> time{};         // [s]
    std::array<double, model::contact_states> judged_time{};  // [s]
    Changes changes;
};

/// The number of equal parts into which a stretch of judged time is cut, so that they can be compared.
inline constexpr std::size_t stretch_parts = 8;

/// Times of a contact in each state, for each part of one judged stretch [s]: of a phase without its ends.
using StretchTimes = std::array<std::array<double, model::contact_states>, stretch_parts>;

/// The number of latest stretches that are kept.
inline constexpr std::size_t kept_stretches = 8;

/// What one phase of a run leaves behind of one contact: of bounded size (1.2 MB at most, 2.4 MB of two steps),
/// whatever the simulated time.
struct ContactTally {
    std::array<double, model::contact_states> time{};         // [s] in each state, whole phase
    std::array<double, model::contact_states> judged_time{};  // [s] in each state, judged part
    Changes changes;                                          // judged part, by kind
    long releases = 0;                                        // [1] sticks that ended, whole phase
    Load load;                                                // judged part; of one contact alone only the largest N
    double preload = 0.0;                                     // [N] N at rest; 0: not known, or open there
    Ending ending;                                            // of the run: one for all its phases
    std::optional<CoarserTally> coarser{};                    // of an engine that compares two steps
    std::vector<StretchTimes> stretches{};                    // the latest complete ones, in time
    long judged_stretches = 0;                                // [1] complete ones, kept or not
    bool creeps = false;  // its friction is regularised: it creeps where it should stick
};

/// What one phase of a run leaves behind.
struct Tally {
    Phase phase = Phase::all;
    std::vector<ContactTally> contacts = std::vector<ContactTally>(1);  // shape [contact]
    std::vector<InterfaceTally> interfaces{};                           // those of several contacts
    std::vector<Vibration> vibration;                                   // judged part, shape [channel]
    double vibration_time = 0.0;                                        // [s] time the vibration was integrated over
    std::vector<Vibration> closing_vibration;  // closing part, shape [channel]; zero without one
    double closing_time = 0.0;                 // [s] length of the closing part
};

}  // namespace stridor::record
