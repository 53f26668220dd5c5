#include "commands.hpp"
#include "interrupt.hpp"
#include "mpi_post.hpp"
#include "program.hpp"
#include "ranks.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <csignal>

namespace {

constexpr const char* footer =
    "Every rank reads the same files and computes; rank 0 alone writes and speaks. Threads of a rank: --threads.\n"
    "  mpirun -n 64 stridor-mpi chart pair.toml --out pair\n"
    "  mpirun -n 16 stridor-mpi advise quiet.toml --tolerance preload=10% --samples 100000\n"
    "  srun --mpi=pmix -n 64 stridor-mpi chart pair.toml --out pair\n"
    "\n"
    "A job that ends too soon, for whatever reason, goes on when the same command is run again, on any number of "
    "ranks. "
    "SIGTERM and SIGUSR1 keep everything. Options, results and exit codes are those of `stridor`; mpirun has exit "
    "codes "
    "of its own.";

// the commands that a cluster computes
constexpr void (*commands[])(CLI::App&) = {stridor::app::add_chart, stridor::app::add_advise,
                                           stridor::app::add_evaluate};

// Rank 0 speaks for all, and stops all: what the others would say is the same, and their signals are its own.
void leave_it_to_rank_0() {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (nowhere >= 0) {
        dup2(nowhere, STDOUT_FILENO);
        dup2(nowhere, STDERR_FILENO);
        close(nowhere);
    }
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1})
        std::signal(signal, SIG_IGN);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace stridor;
    app::begin_process();
    // a batch system may send one while MPI begins, which takes seconds on many machines
    app::note_signals();
    app::MpiPost post(argc, argv);
    if (post.rank() != 0) leave_it_to_rank_0();
    app::Ranks ranks(post);
    const app::Program program{"stridor-mpi", "Computes charts, advice and evaluations on the ranks of an MPI job.",
                               footer, commands};
    return ranks.end(app::run(program, argc, argv));
}
