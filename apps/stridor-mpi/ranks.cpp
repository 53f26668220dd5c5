#include "ranks.hpp"

#include "crews.hpp"
#include "stridor/base/check.hpp"
#include "stridor/cluster/hand.hpp"
#include "stridor/cluster/messages.hpp"
#include "stridor/cluster/rank_crew.hpp"
#include "stridor/cluster/timing.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/sweep/thread_crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <thread>

namespace stridor::app {

namespace {

using Clock = std::chrono::steady_clock;

// for the others to hear that the command has ended: they look for letters every few milliseconds
constexpr std::chrono::seconds patience{5};

// what MPI is: one job to a process, which the command and the functions that it calls find here
struct Job {
    MpiPost* post = nullptr;
    std::optional<int> exit_code;  // once rank 0 has told it
};

Job& job() {
    static Job the_job;
    return the_job;
}

// of a process that is bound to some processors these, else its part of the machine's
int threads_of(const MpiPost& post, int asked) {
    const int usable = static_cast<int>(sweep::thread_count(0));
    const int all = static_cast<int>(std::thread::hardware_concurrency());
    if (asked == 0) return usable < all ? usable : std::max(all / post.neighbours(), 1);
    if (asked > usable && post.rank() == 0)
        console::say(
            fmt::format("rank 0 may use {} of the {} processors that --threads asks for. Start mpirun with "
                        "--bind-to none, or --map-by numa:PE={}?",
                        usable, asked, asked));
    return asked;
}

}  // namespace

sweep::CrewMaker crews(int threads) {
    STRIDOR_EXPECT(job().post != nullptr);
    MpiPost& post = *job().post;
    return cluster::rank_crews(post, threads_of(post, threads));
}

bool helps_with(const sweep::Study& study, int threads) {
    STRIDOR_EXPECT(job().post != nullptr);
    MpiPost& post = *job().post;
    if (post.rank() == 0) return false;
    job().exit_code = cluster::serve(post, study, threads_of(post, threads));
    return true;
}

Ranks::Ranks(MpiPost& post) : post_(post) {
    job() = {&post, std::nullopt};
}

Ranks::~Ranks() {
    job() = {};
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
    if (!job().exit_code && exit_code != 0)
        post_.send(0, cluster::pack(cluster::Failure{ErrorKind::io,
                                                     {fmt::format("rank {} could not begin", post_.rank()),
                                                      fmt::format("it ended with exit code {}", exit_code),
                                                      "Are all files to be found from its machine?"}}));
    while (!job().exit_code) {
        while (const std::optional<cluster::Letter> letter = post_.poll()) {
            const cluster::Message message = cluster::unpack(letter->bytes);
            if (const auto* end = std::get_if<cluster::End>(&message)) job().exit_code = end->exit_code;
        }
        std::this_thread::sleep_for(cluster::idle_pause);
    }
    post_.send(0, cluster::pack(cluster::Bye{}));
    return *job().exit_code;
}

}  // namespace stridor::app
