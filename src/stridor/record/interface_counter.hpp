#pragma once

#include "stridor/model/contact_state.hpp"
#include "stridor/record/tally.hpp"

#include <cstddef>
#include <vector>

namespace stridor::record {

/// Counts the common states of the contacts of one interface, in the judged part of each phase.
///
/// A change of one of p contacts costs O(p), a run O(p²) numbers, whatever its length.
class InterfaceCounter {
public:
    /// Counts these contacts of the structure, in rising order.
    InterfaceCounter(const Schedule& schedule, std::vector<std::size_t> contacts);

    /// Notes that a contact of the structure enters a state at `time` [s], which never decreases. Contacts of other
    /// interfaces are ignored.
    void enter(std::size_t number, model::ContactState state, double time);

    /// Ends the count at `time` [s] and returns the tallies; shape [phase], in the schedule's order.
    std::vector<InterfaceTally> finish(double time);

private:
    // judged time [s] that has passed in each phase
    using Clock = std::vector<double>;

    struct Contact {
        model::ContactState state = model::ContactState::separation;
        bool has_state = false;
        Clock free_since;  // when it last left stick
    };

    void advance(double time);
    void close_interval();
    void add_free(std::size_t contact);
    InterfaceState state_now() const;

    std::vector<Span> spans_;
    std::vector<std::size_t> phase_of_span_;
    std::size_t span_ = 0;
    double time_ = 0.0;  // [s] that the clock shows
    Clock clock_;
    std::vector<std::size_t> numbers_;  // of its contacts in the structure
    std::vector<Contact> contacts_;
    std::array<std::size_t, model::contact_states> in_state_{};  // how many of them are in each state
    InterfaceState state_ = InterfaceState::open;
    Clock state_since_;
    std::vector<InterfaceTally> tallies_;
};

/// Returns a counter for each interface with several contacts. `interfaces` is the number of each contact's interface;
/// below 0 or empty: the contact is an interface by itself.
std::vector<InterfaceCounter> interface_counters(const Schedule& schedule, const std::vector<int>& interfaces);

}  // namespace stridor::record
