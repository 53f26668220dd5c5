#pragma once

#include "stridor/record/contact_history.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/record/trace.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::record {

enum class KeepHistory { no, yes };

/// What to keep of a run besides the tallies, which are always kept.
struct Request {
    KeepHistory history = KeepHistory::no;
    TraceRequest trace;
};

/// Most contact states that a history holds: 160 MB.
inline constexpr std::size_t most_history = 4'000'000;

/// All that is kept of a run.
struct Record {
    std::vector<Tally> phases;  // in the schedule's order
    ContactHistory history;     // empty unless asked for
    Trace trace;                // empty unless asked for
};

/// Takes what an engine tells it and keeps what was asked for.
///
/// The engine says `enter` at each change of state, `vibrate` for each stretch between two span boundaries, `sample`
/// for each trace sample and `finish` once. Times never decrease.
class Recorder {
public:
    Recorder(Schedule schedule, Request request, int dofs);

    const Schedule& schedule() const { return schedule_; }
    const Request& request() const { return request_; }

    /// The contact enters a state at its `from`; `to` is ignored.
    void enter(const ContactInterval& interval);

    /// Adds the vibration of a stretch of time that lies within span number `span`; shape [dof].
    void vibrate(std::size_t span, double duration, std::span<const Vibration> vibration);

    /// Where the next sample goes; to be asked for each of them.
    Trace& trace();

    /// Ends the record at `time` and hands it over, with what the engine knows of the time after it. Throws `Error`
    /// (input) if a history was asked for and did not fit.
    Record finish(double time, const Outlook& outlook = {});

private:
    void keep_current(double to);
    void count(double to);
    void note_change(model::ContactState from, model::ContactState to, double time);
    Tally* tally_of(Phase phase);
    void hand_over();

    Schedule schedule_;
    Request request_;
    Record record_;
    ContactInterval current_;
    bool has_state_ = false;
    std::size_t span_ = 0;     // the span that holds `counted_to_`
    double counted_to_ = 0.0;  // [s] time already counted
};

}  // namespace stridor::record
