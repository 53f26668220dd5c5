#pragma once

#include "mpi_post.hpp"
#include "stridor/cluster/hand.hpp"

namespace stridor::app {

/// The ranks of this job while a command runs, for the functions of crews.hpp. One lives at a time.
class Ranks {
public:
    explicit Ranks(MpiPost& post);
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// Ends the command in all ranks: rank 0 tells the exit code, the others wait for it. The exit code of this
    /// process. Who has a failure (`exit_code` not 0) and is not rank 0 says so to rank 0 first.
    int end(int exit_code);

    /// How ranks speak with one another.
    MpiPost& post() { return post_; }

    /// This rank, as one that helps rank 0.
    cluster::Hand& hand() { return hand_; }

private:
    int lead_to_the_end(int exit_code);
    int wait_for_the_end(int exit_code);

    MpiPost& post_;
    cluster::Hand hand_;
};

}  // namespace stridor::app
