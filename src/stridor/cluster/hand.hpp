#pragma once

#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/cluster/timing.hpp"
#include "stridor/sweep/crew.hpp"

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace stridor::cluster {

/// How a rank other than the first works.
struct HandOptions {
    std::size_t threads = 1;  // [1] that compute there
    sweep::CrewMaker crew;    // who computes there
    Timing timing{};
};

/// A rank other than the first: it computes what rank 0 gives it, and hands over the cells.
class Hand {
public:
    /// Says hello to rank 0.
    Hand(Post& post, const sweep::Study& study, HandOptions options);

    /// Reads what has arrived, waits a moment for cells, hands over what is finished. False once rank 0 has ended.
    bool step();

    /// Of the whole job, once rank 0 has ended.
    int exit_code() const { return exit_code_; }

private:
    using Clock = Timing::Clock;

    void read_letters();
    void hand_over(Clock::time_point now);
    void tell(const Message& message);

    Post& post_;
    HandOptions options_;
    std::stop_source halt_;
    std::unique_ptr<sweep::Crew> crew_;
    std::vector<sweep::IndexedCell> finished_;
    Clock::time_point told_;    // when rank 0 last heard of this one
    Clock::time_point worked_;  // when there was last something to do
    bool has_told_its_end_ = false;
    bool has_ended_ = false;
    int exit_code_ = 0;
};

/// Computes for rank 0 until that ends; the exit code of the whole job.
int serve(Post& post, const sweep::Study& study, int threads);

}  // namespace stridor::cluster
