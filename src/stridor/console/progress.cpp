#include "stridor/console/progress.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <system_error>

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

// 0 for what is not there
std::uintmax_t size_of(const std::filesystem::path& file) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    return error ? 0 : size;
}

void redraw_or_say(const std::string& line, int percent) {
    if (has_terminal())
        fmt::print(stderr, "\r{}{}", line, percent >= 100 ? "\n" : "");
    else
        say(line);
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

void RenderDisplay::show(double time) {
    constexpr double long_run = 20.0;  // [s]
    const int percent = static_cast<int>(100.0 * time / duration_);
    const int step = has_terminal() ? 1 : 10;
    if (duration_ < long_run || percent / step == shown_ / step) return;
    shown_ = percent;
    redraw_or_say(fmt::format("rendered {:.0f} of {:g} s", time, duration_), percent);
}

AnalysisDisplay::AnalysisDisplay(std::optional<std::uint64_t> frames, double rate)
    : whole_(static_cast<double>(frames.value_or(0))) {
    constexpr double long_recording = 300.0;  // [s]
    is_shown_ = whole_ >= long_recording * rate;
}

void AnalysisDisplay::show(std::uint64_t frames) {
    const int percent = static_cast<int>(100.0 * static_cast<double>(frames) / whole_);
    if (percent < said_ + (has_terminal() ? 1 : 10)) return;
    said_ = percent;
    redraw_or_say(fmt::format("analysed {} %", percent), percent);
}

void SearchDisplay::show(const hearing::SearchProgress& progress) {
    constexpr std::size_t least_said = 50;                                           // [1] cells
    if (progress.done <= progress.before && progress.done < progress.known) return;  // known from an earlier run
    if (!has_terminal() && progress.known < least_said) return;
    display_.show(static_cast<double>(progress.done) / static_cast<double>(progress.known),
                  fmt::format("{} of {} cells", progress.done, progress.known));
}

HeardFilesDisplay::HeardFilesDisplay(const std::vector<hearing::Expectation>& recordings) : count_(recordings.size()) {
    for (const hearing::Expectation& recording : recordings)
        total_ += size_of(recording.file);
}

void HeardFilesDisplay::begin(const std::string& file) {
    file_ = std::filesystem::path(file).filename().string();
    size_ = size_of(file);
    ++number_;
}

void HeardFilesDisplay::show(double share) {
    if (total_ == 0 || !takes_long(count_, total_)) return;
    const double done = static_cast<double>(done_) + share * static_cast<double>(size_);
    display_.show(done / static_cast<double>(total_), fmt::format("{} of {}: {}", number_, count_, file_));
}

void RowDisplay::begin(const std::filesystem::path& file) {
    is_shown_ = takes_long(total_, size_of(file));
    file_ = file.filename().string();
}

void RowDisplay::show(double share) {
    if (!is_shown_) return;
    const double whole = (static_cast<double>(done_) + share) / static_cast<double>(total_);
    display_.show(whole, total_ > 1 ? fmt::format("{} of {}: {}", done_ + 1, total_, file_) : "");
}

void RowDisplay::end() {
    show(1.0);
    ++done_;
    clear();
}

}  // namespace stridor::console
