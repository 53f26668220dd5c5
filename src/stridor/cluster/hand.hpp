#pragma once

#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/crew/crew.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace stridor::cluster {

/// Who computes in a rank other than the first.
struct HandOptions {
    std::size_t threads = 1;  // [1]
    crew::CrewMaker crew;
};

/// A rank other than the first: it computes what rank 0 gives it, and hands over the results.
///
/// A command has one work after the other, and all ranks come upon them in the same order. Rank 0 may leave one out, of
/// which everything is kept: so it says which one it begins, and the others go on to that.
class Hand {
public:
    /// The post must outlive this.
    explicit Hand(Post& post, Timing timing = {});
    ~Hand();
    Hand(const Hand&) = delete;
    Hand& operator=(const Hand&) = delete;

    /// Comes upon a work, and waits for rank 0 to begin it.
    void take_up(const crew::Work& work, HandOptions options);

    /// Reads what has arrived, waits a moment for results, hands over what is finished. False once the work is over:
    /// rank 0 has begun another one, or has ended.
    bool step();

    /// All steps of a work.
    void serve(const crew::Work& work, HandOptions options);

    /// Waits for the end of rank 0, having come to the end of the command; the exit code of the whole job. A work that
    /// rank 0 has begun by then is one that this rank does not have, which is a failure.
    int wait_for_the_end();

    /// Says that this rank fails.
    void fail(const Failure& failure);

    /// Of the whole job, once rank 0 has ended.
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
