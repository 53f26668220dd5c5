#pragma once

#include "stridor/record/interface_counter.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/record/trace.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::record {

/// Whether all changes of contact state are kept.
enum class KeepHistory { no, yes };

/// The parts of a run to keep besides the tallies, which are always kept.
struct Request {
    KeepHistory history = KeepHistory::no;
    TraceRequest trace;
};

/// Most contact states that all histories hold together: 160 MB.
inline constexpr std::size_t most_history = 4'000'000;

/// All kept data of a run.
struct Record {
    std::vector<Tally> phases;              // in the schedule's order
    std::vector<ContactHistory> histories;  // shape [contact]; each empty unless requested
    Trace trace;                            // without samples unless requested
};

/// Records what an engine tells, as far as it was requested.
///
/// The engine calls `enter` at each change of state of a contact, `vibrate` and `load` for each stretch between two
/// span boundaries, `sample` for each sample of a trace and `finish` once. The times of a contact never decrease.
class Recorder {
public:
    /// Begins a record. `request` may ask for a trace; `dofs` and `contacts` are those of the structure, `channels`
    /// those of its vibration; 0: one per degree of freedom. `interfaces` gives the interface of each contact
    /// (`model::ContactPoint::interface`); empty: one each.
    Recorder(Schedule schedule, Request request, int dofs, int contacts = 1, int channels = 0,
             const std::vector<int>& interfaces = {});

    /// Returns the schedule of the run.
    const Schedule& schedule() const { return schedule_; }
    /// Returns the request.
    const Request& request() const { return request_; }

    /// Notes that a contact enters a state at its `from`; `to` is ignored.
    void enter(std::size_t contact, const ContactInterval& interval);

    /// Adds the vibration of a stretch of time that lies within span number `span`; shape [channel].
    void vibrate(std::size_t span, double duration, std::span<const Vibration> vibration);

    /// Adds the load of the contacts in a stretch of time that lies within span number `span`; shape [contact]. In
    /// structures with one contact it is only the largest normal force.
    void load(std::size_t span, std::span<const Load> loads);

    /// Returns when the contact entered its present state [s].
    double since(std::size_t contact) const { return places_[contact].current.from; }

    /// Takes a sample of the trace.
    void sample(const Sample& sample);

    /// Ends the record at `time` [s] and returns it, with the engine's knowledge of the time after it for each contact:
    /// shape [contact]; an empty list says that nothing is known. Throws `Error` (input) if histories were requested
    /// and did not fit.
    Record finish(double time, const std::vector<Outlook>& outlooks = {});

private:
    /// Where a contact is, and how far its time has been counted.
    struct Place {
        ContactInterval current{};
        bool has_state = false;
        std::size_t span = 0;     // the span that holds `counted_to`
        double counted_to = 0.0;  // [s] time already counted
        StretchTimes stretch{};   // of the judged stretch that holds `counted_to`
    };

    void keep_current(std::size_t contact, double to);
    void count(std::size_t contact, double to);
    Span stretch_of(std::size_t span) const;
    bool is_closed_by_next(std::size_t span) const;
    void count_judged(std::size_t contact, double from, double to);
    void end_stretch(std::size_t contact, ContactTally& tally);
    void note_change(std::size_t contact, model::ContactState to, double time);
    Tally* tally_of(Phase phase);
    void hand_over();

    Schedule schedule_;
    Request request_;
    Record record_;
    std::vector<Place> places_;  // shape [contact]
    std::vector<InterfaceCounter> interfaces_;
    std::size_t kept_ = 0;  // contact states in the histories
};

}  // namespace stridor::record
