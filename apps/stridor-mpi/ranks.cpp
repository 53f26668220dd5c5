#include "ranks.hpp"

#include "crews.hpp"
#include "stridor/base/check.hpp"
#include "stridor/cluster/hand.hpp"
#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/post.hpp"
#include "stridor/cluster/rank_crew.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/crew/thread_crew.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

namespace stridor::app {

namespace {

using Clock = std::chrono::steady_clock;

// for the others to hear that the command has ended: they look for letters every few milliseconds
constexpr std::chrono::seconds patience{5};

// one job to a process, as MPI has it, which the functions of crews.hpp find here
Ranks*& the_ranks() {
    static Ranks* ranks = nullptr;
    return ranks;
}

Ranks& ranks() {
    STRIDOR_EXPECT(the_ranks() != nullptr);
    return *the_ranks();
}

// of a process that is bound to some processors these, else its part of the machine's
int threads_of(const MpiPost& post, int asked) {
    const int usable = static_cast<int>(crew::thread_count(0));
    const int all = static_cast<int>(sysconf(_SC_NPROCESSORS_ONLN));
    if (asked == 0) return usable < all ? usable : std::max(all / post.neighbours(), 1);
    if (asked > usable && post.rank() == 0)
        console::say(
            fmt::format("rank 0 may use {} of the {} processors that --threads asks for. Start mpirun with "
                        "--bind-to none, or --map-by numa:PE={}?",
                        usable, asked, asked));
    return asked;
}

}  // namespace

crew::CrewMaker crews(int threads) {
    MpiPost& post = ranks().post();
    return cluster::rank_crews(post, threads_of(post, threads));
}

bool only_helps() {
    return ranks().post().rank() != 0;
}

void help_with(const crew::Work& work, int threads) {
    const int count = threads_of(ranks().post(), threads);
    ranks().hand().serve(work, {crew::thread_count(count), crew::thread_crews(count)});
}

Ranks::Ranks(MpiPost& post) : post_(post), hand_(post) {
    the_ranks() = this;
}

Ranks::~Ranks() {
    the_ranks() = nullptr;
}

int Ranks::end(int exit_code) {
    return post_.rank() == 0 ? lead_to_the_end(exit_code) : wait_for_the_end(exit_code);
}

int Ranks::lead_to_the_end(int exit_code) {
    for (int rank = 1; rank < post_.ranks(); ++rank)
        post_.send(rank, cluster::pack(cluster::End{exit_code}));
    std::set<int> gone{0};
    for (const Clock::time_point deadline = Clock::now() + patience; Clock::now() < deadline;) {
        while (const std::optional<cluster::Letter> letter = post_.poll())
            if (std::holds_alternative<cluster::Bye>(cluster::unpack(letter->bytes))) gone.insert(letter->from);
        if (gone.size() == static_cast<std::size_t>(post_.ranks())) return exit_code;
        std::this_thread::sleep_for(cluster::busy_pause);
    }
    // one is dead or does not answer: MPI would wait for it for ever
    post_.abort(exit_code == 0 ? base::exit_code(ErrorKind::io) : exit_code);
}

int Ranks::wait_for_the_end(int exit_code) {
    // it should have helped, and could not: rank 0 may not have had its trouble
    if (!hand_.exit_code() && exit_code != 0)
        hand_.fail(
            {ErrorKind::io,
             {fmt::format("rank {} could not begin", post_.rank()),
              fmt::format("it ended with exit code {}", exit_code), "Are all files to be found from its machine?"}});
    const int of_all = hand_.wait_for_the_end();
    post_.send(0, cluster::pack(cluster::Bye{}));
    return of_all;
}

}  // namespace stridor::app
