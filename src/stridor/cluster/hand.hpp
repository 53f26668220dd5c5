#pragma once

#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/crew/crew.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace stridor::cluster {

/// The threads that compute in a rank other than the first.
struct HandOptions {
    std::size_t threads = 1;  // [1]
    crew::CrewMaker crew;
};

/// A rank other than the first: it computes the tasks of rank 0, and hands over the results.
///
/// A command has one work after the other, and all ranks reach them in the same order. Rank 0 may skip a work whose
/// results are all kept. So it tells which one it begins, and the others go on to that one.
class Hand {
public:
    /// Begins. The post must outlive this object.
    explicit Hand(Post& post, Timing timing = {});
    ~Hand();
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    /// Reaches a work, and waits for rank 0 to begin it.
    void take_up(const crew::Work& work, HandOptions options);

    /// Reads what has arrived, waits a moment for results, hands over finished ones. Returns false once the work is
    /// over: rank 0 has begun another one, or has ended.
    bool step();

    /// Takes all steps of a work.
    void serve(const crew::Work& work, HandOptions options);

    /// Waits at the end of the command for the end of rank 0, and returns the exit code of the whole job. If rank 0
    /// begins another work by then, this rank lacks it, which is a failure.
    int wait_for_the_end();

    /// Tells rank 0 that this rank fails.
    void fail(const Failure& failure);

    /// Returns the exit code of the whole job, or `std::nullopt` before rank 0 has ended.
    std::optional<int> exit_code() const { return exit_code_; }

private:
    using Clock = Timing::Clock;

    struct Labour;

    void read_letters();
    void read(Message message);
    void begin();
    void hand_over(Clock::time_point now);
    void tell(const Message& message);

    Post& post_;
    Timing timing_;
    HandOptions options_;
    const crew::Work* work_ = nullptr;  // the one this rank has come upon
    std::optional<Begin> begun_;        // what rank 0 has begun, and this rank has not yet
    std::unique_ptr<Labour> labour_;    // the work that both are at
    Clock::time_point told_;            // when rank 0 last heard of this one
    std::optional<int> exit_code_;
};

}  // namespace stridor::cluster
