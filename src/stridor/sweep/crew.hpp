#pragma once

#include "stridor/sweep/cell.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

namespace stridor::sweep {

/// Who computes the runs of a study, and hands their cells over to one owner: the threads of one process, or those of
/// many.
///
/// A run is known by the index of its first cell (`evaluate_run`). Cells arrive in any order; what the owner makes of
/// them must not depend on it. All calls come from the owner's thread. The destructor stops what still runs.
class Crew {
public:
    using Clock = std::chrono::steady_clock;

    Crew() = default;
    virtual ~Crew() = default;
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// How many more runs it would take now [1], so that nobody is idle soon, if so many are left to be given. Few at a
    /// time, for what is not given yet can still be given in a better order; none if it has enough, or has stopped.
    virtual std::size_t appetite(std::size_t left) = 0;

    /// Gives it runs to compute, in this order.
    virtual void give(std::vector<std::size_t> runs) = 0;

    /// The cells that have arrived since the last call. Waits for `enough` of them, for the deadline, for the end of
    /// all that was given, or until it wants more runs, whichever comes first.
    virtual std::vector<IndexedCell> take(std::size_t enough, Clock::time_point deadline) = 0;

    /// True once nothing runs and everything was taken.
    virtual bool is_idle() = 0;

    /// True once it computes nothing any more, be it on request or because something failed.
    virtual bool has_stopped() = 0;

    /// Throws what failed, if anything did.
    virtual void rethrow() = 0;

    /// How long one thread computes at a run [s], on average so far; 0 before the first has ended.
    virtual double seconds_per_run() = 0;
};

/// Makes the crew of a study, which outlives it; a stop request ends its work within a fraction of a second.
using CrewMaker = std::function<std::unique_ptr<Crew>(const Study& study, const std::stop_token& stop)>;

}  // namespace stridor::sweep
