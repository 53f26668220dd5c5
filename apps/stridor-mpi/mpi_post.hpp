#pragma once

#include "stridor/cluster/post.hpp"

#include <list>
#include <memory>

namespace stridor::app {

/// Letters by MPI, between all ranks of the job. Only this class knows MPI, and it never blocks in it: Open MPI waits
/// by keeping a processor busy.
class MpiPost final : public cluster::Post {
public:
    /// Begins MPI. Only the thread that made this object may use it. A process may make only one.
    MpiPost(int& argc, char**& argv);

    /// Ends MPI, which waits until the other ranks end it, too.
    ~MpiPost() override;

    int rank() const override { return rank_; }
    int ranks() const override { return ranks_; }
    void send(int to, std::string bytes) override;
    std::optional<cluster::Letter> poll() override;

    /// Returns the number of ranks on this rank's machine, itself included.
    int neighbours() const { return neighbours_; }

    /// Ends the whole job at once, with this exit code.
    [[noreturn]] void abort(int exit_code);

private:
    struct Sending;

    int rank_ = 0;
    int ranks_ = 1;
    int neighbours_ = 1;
    std::list<std::unique_ptr<Sending>> sending_;  // their bytes must stay until they have left
};

}  // namespace stridor::app
