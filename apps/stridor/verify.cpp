#include "commands.hpp"
#include "stridor/base/error.hpp"
#include "stridor/verification/check_groups.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>

namespace stridor::app {

namespace {

std::string row(const verification::Check& check) {
    return fmt::format("  {:<46}{:>14.7g}{:>14.7g}{:>12.2e}{:>10.1e}  {}\n", check.name, check.expected, check.computed,
                       check.computed - check.expected, check.tolerance,
                       check.passes() ? "ok" : styled("FAILS", Style::red, STDOUT_FILENO));
}

void verify() {
    print(fmt::format("  {:<46}{:>14}{:>14}{:>12}{:>10}\n", "", "expected", "computed", "difference", "tolerance"));
    int total = 0;
    int failed = 0;
    for (const verification::CheckGroup& group : verification::check_groups()) {
        print(styled(std::string(group.title), Style::bold, STDOUT_FILENO) + " (" + std::string(group.source) + ")\n");
        for (const verification::Check& check : group.run()) {
            print(row(check));
            ++total;
            failed += check.passes() ? 0 : 1;
        }
    }
    print(fmt::format("{} of {} checks hold\n", total - failed, total));
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
