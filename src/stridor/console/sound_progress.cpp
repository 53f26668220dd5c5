#include "stridor/console/sound_progress.hpp"

#include "stridor/console/terminal.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <system_error>

namespace stridor::console {

namespace {

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
