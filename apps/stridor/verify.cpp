#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/results/evaluation_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/verification/check.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>

namespace stridor::app {

namespace {

void verify() {
    console::print(console::check_heading());
    int total = 0;
    int failed = 0;
    for (const verification::CheckGroup& group : verification::check_groups()) {
        console::print(console::styled(std::string(group.title), console::Style::bold, STDOUT_FILENO) + " (" +
                       std::string(group.source) + ")\n");
        for (const verification::Check& check : group.run()) {
            console::print(console::check_row(check));
            ++total;
            failed += check.passes() ? 0 : 1;
        }
    }
    console::print(fmt::format("{} of {} checks hold\n", total - failed, total));
    if (failed > 0)
        throw Error(ErrorKind::numerical,
                    {fmt::format("{} checks fail", failed), "this build does not compute what it should",
                     "Please report the table above with your compiler and processor."});
}

}  // namespace

void add_verify(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "verify", "Compute the numbers this program must reproduce, and hold them against closed forms.");
    command->footer("Takes about a second. Exit code 3 if any check fails.");
    command->callback([] { verify(); });
}

}  // namespace stridor::app
