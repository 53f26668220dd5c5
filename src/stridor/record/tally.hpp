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

/// A kind of change of state, (from, to), as one number in [0, contact_states^2).
inline constexpr std::size_t change_kinds = static_cast<std::size_t>(model::contact_states) * model::contact_states;

/// The number of the change from one state to another.
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
};

inline constexpr std::array<std::string_view, 5> future_names{"unknown", "slides", "sticks", "releases", "repeats"};

/// What an engine knows of the time after its run.
struct Outlook {
    Future future = Future::unknown;
    double from = std::numeric_limits<double>::quiet_NaN();     // [s] Future::slides: since when; else unknown
    double release = std::numeric_limits<double>::quiet_NaN();  // [s] Future::releases: about when; else unknown
};

/// How a run ends for a contact, and how it would go on.
struct Ending {
    model::ContactState state = model::ContactState::separation;  // the last one
    double since = 0.0;                                           // [s] when it entered that
    Outlook outlook;
};

/// What a contact carried over some time.
struct Load {
    double normal_impulse = 0.0;  // [N*s] integral of N
    double friction_loss = 0.0;   // [J] turned into heat: integral of |T w|
};

/// What the closed contacts of a structure do together. Open ones do not count as long as one is closed.
enum class InterfaceState { sticks, partly, slides, open };  // all stick; some do; none does; none is closed

inline constexpr std::array<std::string_view, 4> interface_state_names{"sticks", "partly", "slides", "open"};

/// What one phase leaves behind of the contacts of one interface together, judged part.
struct InterfaceTally {
    std::vector<std::size_t> contacts{};                            // their numbers, at least two, rising
    std::array<double, interface_state_names.size()> state_time{};  // [s] in each state
    std::vector<double> free_together{};                            // [s] two of them not stuck, shape [its][its]
};

/// Times of a contact in each state over a phase [s], as `ContactTally`, of the same run at twice the time step.
struct CoarserTimes {
    std::array<double, model::contact_states> time{};
    std::array<double, model::contact_states> judged_time{};
};

/// What one phase of a run leaves behind of one contact: of bounded size (1.2 MB at most), whatever the simulated time.
struct ContactTally {
    std::array<double, model::contact_states> time{};         // [s] in each state, whole phase
    std::array<double, model::contact_states> judged_time{};  // [s] in each state, judged part
    std::array<Instants, change_kinds> changes;               // judged part, by kind
    long releases = 0;                                        // [1] sticks that ended, whole phase
    Load load;                                                // judged part, of structures with several contacts
    Ending ending;                                            // of the run: the same for all its phases
    std::optional<CoarserTimes> coarser{};                    // of an engine that compares two steps
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
