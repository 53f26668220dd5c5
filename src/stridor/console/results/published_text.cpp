#include "stridor/console/results/published_text.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

namespace stridor::console {

namespace {

using verification::HeldNumber;
using verification::PublishedNumber;

std::string number_line(const HeldNumber& held) {
    const PublishedNumber& number = *held.published;
    const bool word = is_word(number);
    const std::string unit = word || number.unit == "1" ? "" : fmt::format(" [{}]", number.unit);
    return fmt::format("  {:<49}{:>15}{:>15}{:>10}{:>8}  {}\n", number.quantity + unit,
                       number_text(number, number.theirs), number_text(number, held.ours),
                       word ? "" : fmt::format("{:.1e}", held.difference()),
                       word ? "" : fmt::format("{:.0e}", number.tolerance),
                       held.agrees() ? "ok" : styled("DIFFERS", Style::red, STDOUT_FILENO));
}

}  // namespace

std::string published_heading() {
    return fmt::format("  {:<49}{:>15}{:>15}{:>10}{:>8}\n", "", "theirs", "ours", "diff.", "allowed");
}

std::string published_text(const verification::HeldSystem& held) {
    const verification::PublishedSystem& system = *held.published;
    std::string text = styled(std::string(system.source), Style::bold, STDOUT_FILENO);
    text += fmt::format(", {}: {} [{}]\n", verification::origin_names[static_cast<std::size_t>(system.origin)],
                        system.system, system.file);
    if (!system.assumed.empty()) text += fmt::format("  assumed: {}\n", system.assumed);
    std::string_view precision;
    for (const HeldNumber& number : held.numbers) {
        if (number.published->precision != precision)
            text += fmt::format("  allowed: {}\n", number.published->precision);
        precision = number.published->precision;
        text += number_line(number);
    }
    return text;
}

std::string not_reproduced_text() {
    std::string text = "not reproduced\n";
    for (const verification::NotReproduced& each : verification::not_reproduced())
        text += fmt::format("  {}: {}\n    {}\n", each.source, each.what, each.why);
    return text;
}

}  // namespace stridor::console
