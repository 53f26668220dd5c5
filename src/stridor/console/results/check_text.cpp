#include "stridor/console/results/check_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace stridor::console {

std::string check_heading() {
    return fmt::format("  {:<46}{:>14}{:>14}{:>12}{:>10}\n", "", "expected", "computed", "difference", "tolerance");
}

std::string check_row(const verification::Check& check) {
    return fmt::format("  {:<46}{:>14.7g}{:>14.7g}{:>12.2e}{:>10.1e}  {}\n", check.name, check.expected, check.computed,
                       check.computed - check.expected, check.tolerance,
                       check.passes() ? "ok" : styled("FAILS", Style::red, STDOUT_FILENO));
}

}  // namespace stridor::console
