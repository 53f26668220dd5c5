#include "stridor/console/progress.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>

namespace stridor::console {

namespace {

// "0:25 left" behind a separator; nothing where it cannot be told
std::string time_left_text(std::string_view separator, double seconds) {
    constexpr double longest = 1e8;  // [s] three years
    if (!(seconds <= longest)) return "";
    const auto whole = static_cast<long>(seconds + 0.5);
    const long hours = whole / 3600;
    const std::string minutes =
        hours > 0 ? fmt::format("{}:{:02}", hours, whole / 60 % 60) : fmt::format("{}", whole / 60);
    return fmt::format("{}{}:{:02} left", separator, minutes, whole % 60);
}

double share_of(std::size_t done, std::size_t total) {
    return total > 0 ? static_cast<double>(done) / static_cast<double>(total) : 1.0;
}

}  // namespace

std::string counts_text(const sweep::Counts& counts) {
    std::string text;
    const auto add = [&](std::string_view name, std::size_t number) {
        if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : "  ", name, number);
    };
    for (std::size_t k = 0; k < counts.categories.size(); ++k)
        add(classification::category_names[k], counts.categories[k]);
    add(classification::name(classification::Quiet::locks), counts.locks);
    // status 0 is done: those are counted by category
    for (std::size_t k = 1; k < counts.statuses.size(); ++k)
        add(sweep::status_names[k], counts.statuses[k]);
    return text;
}

std::string progress_line(const sweep::Progress& progress, int columns) {
    const double left = static_cast<double>(progress.total - progress.done) / progress.rate;
    std::string numbers = fmt::format("{}/{} cells  {:.0f} %", progress.done, progress.total,
                                      std::floor(100.0 * share_of(progress.done, progress.total)));
    if (progress.rate > 0.0) numbers += fmt::format("  {:.3g} cells/s{}", progress.rate, time_left_text("  ", left));
    const std::string counts = counts_text(progress.counts);
    const auto width = static_cast<std::size_t>(columns > 1 ? columns - 1 : 1);
    constexpr std::size_t bar_width = 20;
    const auto filled =
        static_cast<std::size_t>(share_of(progress.done, progress.total) * static_cast<double>(bar_width));
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
    // the total of a refined chart grows: what was said last is taken as a share of today's
    const auto tenth = [&](std::size_t done) { return static_cast<int>(10.0 * share_of(done, progress.total)); };
    if (is_started_ && tenth(progress.done) <= tenth(last_done_)) return;
    // its last rounds are many and small: less than a hundredth more is not worth a line
    const bool is_tail = progress.total != last_total_ && 100 * (progress.done - last_done_) < progress.total;
    if (is_started_ && is_tail) return;
    last_done_ = progress.done;
    last_total_ = progress.total;
    is_started_ = true;
    constexpr int unlimited = 1000;
    say(progress_line(progress, unlimited));
}

void ProgressDisplay::finish() {
    if (has_line_) say("");
    has_line_ = false;
}

std::string ShareDisplay::line(double share, const std::string& detail) {
    std::string text =
        fmt::format("{} {} %{}{}", what_, static_cast<int>(100.0 * share), detail.empty() ? "" : ", ", detail);
    if (time_left_ == TimeLeft::hidden || !(share > begin_share_)) return text;
    const double taken = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    return text + time_left_text(", ", taken * (1.0 - share) / (share - begin_share_));
}

void ShareDisplay::show(double share, const std::string& detail) {
    const int percent = static_cast<int>(100.0 * share);
    if (begin_share_ < 0.0) {
        begin_share_ = share;
        begin_ = std::chrono::steady_clock::now();
    }
    if (has_terminal()) {
        // ten times a second is more than an eye follows
        const auto now = std::chrono::steady_clock::now();
        if (has_line_ && percent == said_ && now - drawn_ < std::chrono::milliseconds(100)) return;
        drawn_ = now;
        said_ = percent;
        const auto width = static_cast<std::size_t>(terminal_columns() > 1 ? terminal_columns() - 1 : 1);
        std::fprintf(stderr, "\r\033[K%s", shown(line(share, detail)).substr(0, width).c_str());
        std::fflush(stderr);
        has_line_ = true;
        return;
    }
    if (percent / 10 <= said_ / 10) return;
    said_ = percent;
    say(line(share, detail));
}

void ShareDisplay::clear() {
    if (!has_line_) return;
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
    has_line_ = false;
}

}  // namespace stridor::console
