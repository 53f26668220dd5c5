#pragma once

#if defined(__SANITIZE_THREAD__)
#    include <atomic>
#endif

namespace stridor::sweep {

/// Tells the thread sanitizer what TBB promises by itself: a task sees all that was written before the loop, and the
/// caller all that tasks wrote, once the loop is over. In every other build it is nothing.
///
/// TBB's library is not compiled with the sanitizer, which so misses its synchronisation and would call every result a
/// race. Made before the loop; each task holds a `Task`; the caller calls `join()` after the loop.
class ForkJoin {
public:
    /// Stands in each task of the loop.
    class Task {
    public:
        /// The task begins.
        Task() { order(); }
        ~Task() { order(); }
        Task(const Task&) = delete;
        Task& operator=(const Task&) = delete;
    };

    /// Before the loop.
    ForkJoin() { order(); }
    ~ForkJoin() = default;
    ForkJoin(const ForkJoin&) = delete;
    ForkJoin& operator=(const ForkJoin&) = delete;

    /// After the loop.
    void join() const { order(); }

private:
#if defined(__SANITIZE_THREAD__)
    // not a member: a task would have to read where it is before the two are ordered
    static inline std::atomic<unsigned> events_ = 0;
    static void order() {
        events_.fetch_add(1, std::memory_order_acq_rel);
    }
#else
    static void order() {}
#endif
};

}  // namespace stridor::sweep
