#pragma once

#include "stridor/sweep/run.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace stridor::console {

/// One line that says how far a sweep is: bar, cells, rate, time left, running counts. At most `columns` wide.
std::string progress_line(const sweep::Progress& progress, int columns);

/// Running counts: "none 812  squeal 340  squeak 51  creak 12  failed 3"; only those that occur.
std::string counts_text(const sweep::Counts& counts);

/// Shows a sweep's progress on stderr: a line that is redrawn in a terminal, a line per 10 % anywhere else.
class ProgressDisplay {
public:
    /// Shows how far the sweep is. Says nothing where nothing new is to be said.
    void show(const sweep::Progress& progress);

    /// Leaves the last state on the screen and moves to a fresh line.
    void finish();

private:
    std::size_t last_done_ = 0;  // [1] cells when it last said something
    std::size_t last_total_ = 0;
    bool is_started_ = false;
    bool has_line_ = false;
};

/// Is a row of so many recordings, or of so many bytes, worth a progress line?
constexpr bool takes_long(std::size_t recordings, std::uintmax_t bytes) {
    constexpr std::size_t many = 20;
    constexpr std::uintmax_t some_minutes_of_sound = 60'000'000;
    return recordings >= many || bytes >= some_minutes_of_sound;
}

/// Does a display say how long it will still take?
enum class TimeLeft { hidden, shown };

/// Shows on stderr how far a long piece of work is: a line that is redrawn in a terminal,
/// a line per 10 % anywhere else.
class ShareDisplay {
public:
    /// `what` begins the line: "analysed".
    explicit ShareDisplay(std::string what, TimeLeft time_left = TimeLeft::hidden)
        : what_(std::move(what)),
          time_left_(time_left) {}
    ~ShareDisplay() { clear(); }
    ShareDisplay(const ShareDisplay&) = delete;
    ShareDisplay& operator=(const ShareDisplay&) = delete;

    /// `share` [1] is done; `detail` ends the line.
    void show(double share, const std::string& detail = "");

    /// Takes the line off the screen, before anything else is written.
    void clear();

private:
    std::string line(double share, const std::string& detail);

    std::string what_;
    TimeLeft time_left_;
    std::chrono::steady_clock::time_point begin_{};  // when it was shown first
    std::chrono::steady_clock::time_point drawn_{};
    double begin_share_ = -1.0;  // [1] what was done then
    int said_ = 0;               // [%]
    bool has_line_ = false;
};

}  // namespace stridor::console
