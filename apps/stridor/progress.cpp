#include "progress.hpp"

#include "terminal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace stridor::app {

namespace {

std::string duration_text(double seconds) {
    if (!std::isfinite(seconds)) return "?";
    const auto whole = static_cast<long>(seconds + 0.5);
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

double share_of(const sweep::Progress& progress) {
    return progress.total > 0 ? static_cast<double>(progress.done) / static_cast<double>(progress.total) : 1.0;
}

}  // namespace

std::string counts_text(const sweep::Counts& counts) {
    std::string text;
    const auto add = [&](std::string_view name, std::size_t number) {
        if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : "  ", name, number);
    };
    for (std::size_t k = 0; k < counts.categories.size(); ++k)
        add(classification::category_names[k], counts.categories[k]);
    // status 0 is done: those are counted by category
    for (std::size_t k = 1; k < counts.statuses.size(); ++k)
        add(sweep::status_names[k], counts.statuses[k]);
    return text;
}

std::string progress_line(const sweep::Progress& progress, int columns) {
    const double left = static_cast<double>(progress.total - progress.done) / progress.rate;
    const std::string numbers =
        fmt::format("{}/{} cells  {:.0f} %  {:.3g} cells/s  {} left", progress.done, progress.total,
                    std::floor(100.0 * share_of(progress)), progress.rate, duration_text(left));
    const std::string counts = counts_text(progress.counts);
    const auto width = static_cast<std::size_t>(columns > 1 ? columns - 1 : 1);
    constexpr std::size_t bar_width = 20;
    const auto filled = static_cast<std::size_t>(share_of(progress) * static_cast<double>(bar_width));
    const std::string bar = "[" + std::string(filled, '=') + std::string(bar_width - filled, ' ') + "] ";
    std::string line = bar + numbers + "  " + counts;
    if (line.size() > width) line = numbers + "  " + counts;  // a narrow terminal loses the bar first
    return line.substr(0, width);
}

void ProgressDisplay::show(const sweep::Progress& progress) {
    if (has_terminal()) {
        const std::string line = progress_line(progress, terminal_columns());
        std::fprintf(stderr, "\r\033[K%s", line.c_str());
        std::fflush(stderr);
        has_line_ = true;
        return;
    }
    const auto tenth = static_cast<std::size_t>(10.0 * share_of(progress));
    if (is_started_ && tenth <= last_tenth_) return;
    last_tenth_ = tenth;
    is_started_ = true;
    constexpr int unlimited = 1000;
    say(progress_line(progress, unlimited));
}

void ProgressDisplay::finish() {
    if (has_line_) say("");
    has_line_ = false;
}

}  // namespace stridor::app
