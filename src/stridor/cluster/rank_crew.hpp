#pragma once

#include "stridor/base/error.hpp"
#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/crew/crew.hpp"

#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <stop_token>
#include <vector>

namespace stridor::cluster {

/// A rank has been silent for so long that it is taken for dead: it will not reach the job's end.
class SilentRank final : public Error {
public:
    using Error::Error;
};

/// How rank 0 leads the others.
struct RankCrewOptions {
    std::size_t threads = 1;  // [1] that compute in rank 0
    crew::CrewMaker crew;     // the crew of rank 0
    std::chrono::seconds longest_silence{60};
    Timing timing{};
};

/// The threads of all ranks, as rank 0 sees them; the others are each a `Hand`.
///
/// Tasks are dealt out in their order, to each rank in batches of a tenth of a second of work, two batches ahead, and
/// smaller ones towards the end. No call here waits for a message. A rank that dies ends the job (by MPI, or by its
/// silence); the results kept by then stay, and the same command goes on with any number of ranks.
class RankCrew final : public crew::Crew {
public:
    /// Begins the work in all ranks. The post must be that of rank 0 and outlive this.
    RankCrew(Post& post, const crew::Work& work, const std::stop_token& stop, RankCrewOptions options);

    std::size_t appetite(std::size_t left) override;
    void give(std::vector<crew::Task> tasks) override;
    std::vector<crew::Result> take(std::size_t enough, Clock::time_point deadline) override;
    bool is_idle() override;
    bool has_stopped() override;
    void rethrow() override;
    double seconds_per_task() override;

private:
    // another rank
    struct Member {
        int rank = 0;
        Hello hello{};
        bool has_said_hello = false;
        bool has_stopped = false;
        std::size_t outstanding = 0;    // [1] tasks that it was given and that are not here
        std::size_t wanted = 0;         // [1] tasks that it would be given now
        double seconds_per_task = 0.0;  // [s] 0: not known yet
        Clock::duration heard{};        // when `attention_` was so much
    };

    void read_letters();
    void read(Member& member, Message message);
    void fail(std::exception_ptr failure);
    void halt_all();
    void expect_signs_of_life();
    bool is_satisfied(std::size_t enough);
    bool is_done();  // nothing runs, here or elsewhere
    static std::size_t batch(const Member& member);

    Post& post_;
    RankCrewOptions options_;
    std::stop_source halt_;
    std::stop_callback<std::function<void()>> relay_;  // passes the caller's stop request on to halt_
    std::unique_ptr<crew::Crew> own_;                  // of this rank
    std::vector<Member> members_;
    Clock::duration attention_{};  // for how long this rank has looked for letters, its own absences left out
    Clock::time_point looked_;     // the last time
    std::vector<crew::Result> arrived_;
    std::exception_ptr failure_;
    bool was_fed_ = false;  // since the owner was last told that there is room
    bool has_asked_to_stop_ = false;
    Clock::time_point stop_asked_;
};

/// Makes the crew of rank 0: `threads` threads of its own, and the other ranks.
crew::CrewMaker rank_crews(Post& post, int threads);

}  // namespace stridor::cluster
