#pragma once

#include "mpi_post.hpp"
#include "stridor/cluster/hand.hpp"

namespace stridor::app {

/// The ranks of this job while a command runs, for the functions of crews.hpp. Only one may live at a time.
class Ranks {
public:
    explicit Ranks(MpiPost& post);
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// Ends the command in all ranks and returns the exit code of this process. Rank 0 tells the exit code, the others
    /// wait for it. Another rank with a failure (`exit_code` not 0) first tells rank 0.
    int end(int exit_code);

    /// Returns the post between the ranks.
    MpiPost& post() { return post_; }

    /// Returns this rank as a helper of rank 0.
    cluster::Hand& hand() { return hand_; }

private:
    int lead_to_the_end(int exit_code);
    int wait_for_the_end(int exit_code);

    MpiPost& post_;
    cluster::Hand hand_;
};

}  // namespace stridor::app
