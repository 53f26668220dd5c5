#pragma once

#include "stridor/base/error.hpp"

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

/// Many tasks of one work, which threads or other processes compute for one owner.
namespace stridor::crew {

/// Something to compute, as it is told to another thread or process.
struct Task {
    std::size_t number = 0;  // which one of its work
    std::string bytes{};     // what the number alone does not say
};

/// What came of a task.
struct Result {
    std::size_t number = 0;  // of the task
    std::string bytes{};
};

/// Computes one task after the other in one thread, with scratch memory of its own; nothing if it was stopped. Throws
/// only what concerns every task.
using Worker = std::function<std::optional<std::string>(const Task& task, const std::stop_token& stop)>;

/// What there is to compute. Whoever has a work of the same text gets the same bytes for a task.
struct Work {
    std::string text;                // all that decides the results
    std::function<Worker()> worker;  // one for each thread; what it refers to must outlive the crew
};

/// Who computes the tasks of a work, and hands their results over to one owner: the threads of one process, or those of
/// many.
///
/// Results arrive in any order; what the owner makes of them must not depend on it. All calls come from the owner's
/// thread. The destructor stops what still runs.
class Crew {
public:
    using Clock = std::chrono::steady_clock;

    Crew() = default;
    virtual ~Crew() = default;
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// How many more tasks it would take now [1], so that nobody is idle soon, if so many are left to be given. Few at
    /// a time, for what is not given yet can still be given in a better order; none if it has enough, or has stopped.
    virtual std::size_t appetite(std::size_t left) = 0;

    /// Gives it tasks to compute, in this order.
    virtual void give(std::vector<Task> tasks) = 0;

    /// The results that have arrived since the last call. Waits for `enough` of them, for the deadline, for the end of
    /// all that was given, or until it wants more tasks, whichever comes first.
    virtual std::vector<Result> take(std::size_t enough, Clock::time_point deadline) = 0;

    /// True once nothing runs and everything was taken.
    virtual bool is_idle() = 0;

    /// True once it computes nothing any more, be it on request or because something failed.
    virtual bool has_stopped() = 0;

    /// Throws what failed, if anything did.
    virtual void rethrow() = 0;

    /// How long one thread computes at a task [s], on average so far; 0 before the first has ended.
    virtual double seconds_per_task() = 0;
};

/// Makes the crew of a work; a stop request ends what it does within a fraction of a second.
using CrewMaker = std::function<std::unique_ptr<Crew>(const Work& work, const std::stop_token& stop)>;

/// Has a crew compute all these tasks, first those in front, and hands each result over as it comes, in any order.
///
/// `tick` is called ten times a second meanwhile, and once at the end; both calls come from the caller's thread. Where
/// the crew has stopped on request, some results are missing in the end. Throws what failed in the crew.
void compute(Crew& crew, std::vector<Task> tasks, const std::function<void(Result)>& take,
             const std::function<void()>& tick = {});

/// What to throw where the bytes of a result are none that this program writes.
Error damaged_result();

/// So many tasks that are told by their numbers alone: 0, 1, 2, ...
std::vector<Task> numbered_tasks(std::size_t count);

}  // namespace stridor::crew
