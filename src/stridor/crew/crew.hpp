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

/// Many tasks of one work, computed for one owner by threads or other processes.
namespace stridor::crew {

/// A task, as it is sent to another thread or process.
struct Task {
    std::size_t number = 0;  // which one of its work
    std::string bytes{};     // what the number alone does not tell
};

/// The result of a task.
struct Result {
    std::size_t number = 0;  // of the task
    std::string bytes{};
};

/// Computes one task after the other in one thread, with scratch memory of its own. Returns `std::nullopt` if it was
/// stopped. Throws only an error that concerns every task.
using Worker = std::function<std::optional<std::string>(const Task& task, const std::stop_token& stop)>;

/// A work. Works of equal text give equal bytes for a task.
struct Work {
    std::string text;                // all that decides the results
    std::function<Worker()> worker;  // one for each thread; its references must outlive the crew
};

/// The threads of one process, or of many, that compute the tasks of a work and hand their results over to one owner.
///
/// Results arrive in any order; the owner's result must not depend on it. All calls come from the owner's thread. The
/// destructor stops what still runs.
class Crew {
public:
    using Clock = std::chrono::steady_clock;

    Crew() = default;
    virtual ~Crew() = default;
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;

    /// Returns how many more tasks the crew would take now [1] so that nobody is idle soon, if `left` are left to be
    /// given. It takes few at a time, since the rest can still be given in a better order; 0 if it has enough or has
    /// stopped.
    virtual std::size_t appetite(std::size_t left) = 0;

    /// Gives the crew tasks to compute, in this order.
    virtual void give(std::vector<Task> tasks) = 0;

    /// Returns the results that have arrived since the last call. Waits for `enough` of them, for the deadline, for the
    /// end of all that was given, or until the crew wants more tasks, whichever comes first.
    virtual std::vector<Result> take(std::size_t enough, Clock::time_point deadline) = 0;

    /// Says whether nothing runs and everything was taken.
    virtual bool is_idle() = 0;

    /// Says whether the crew computes nothing any more, on request or after a failure.
    virtual bool has_stopped() = 0;

    /// Throws the error that stopped the crew, if there was one.
    virtual void rethrow() = 0;

    /// Returns the average time of one thread for a task [s]; 0 before the first has ended.
    virtual double seconds_per_task() = 0;
};

/// Makes the crew of a work. A stop request ends the crew's computing within a fraction of a second.
using CrewMaker = std::function<std::unique_ptr<Crew>(const Work& work, const std::stop_token& stop)>;

/// Makes crews of `threads` threads of this process; 0: one per processor this process may use.
CrewMaker thread_crews(int threads = 0);

/// Lets a crew compute all these tasks, the first ones first, and hands each result over as it comes, in any order.
///
/// `tick` is called ten times a second meanwhile, and once at the end; both calls come from the caller's thread. If the
/// crew has stopped on request, some results are missing in the end. Throws the error that stopped the crew.
void compute(Crew& crew, std::vector<Task> tasks, const std::function<void(Result)>& take,
             const std::function<void()>& tick = {});

/// Returns the error to throw if the bytes of a result cannot be this program's.
Error damaged_result();

/// Returns `count` tasks that consist of their numbers alone: 0, 1, 2, ...
std::vector<Task> numbered_tasks(std::size_t count);

}  // namespace stridor::crew
