#include "commands.hpp"
#include "program.hpp"

namespace {

constexpr const char* footer =
    "First steps:\n"
    "  stridor init squeal -o squeal.toml     write a commented case file\n"
    "  stridor simulate squeal.toml           does it squeal?\n"
    "  stridor stability squeal.toml --over contact.kinetic_friction=0:0.8\n"
    "  stridor init noise-chart -o pair.toml && stridor chart pair.toml --out pair\n"
    "\n"
    "`stridor help COMMAND` lists the options of a command.\n"
    "Exit codes: 0 done, 2 bad input or usage, 3 numerical failure, 4 interrupted (run the same command again), 5 a "
    "file, disk or other program failed. Data goes to stdout, messages to stderr.";

}  // namespace

int main(int argc, char** argv) {
    using namespace stridor;
    app::begin_process();
    const app::Program program{"stridor", "Predicts whether a rubbing contact squeals, squeaks, creaks or stays quiet.",
                               footer, app::add_commands};
    return app::run(program, argc, argv);
}
