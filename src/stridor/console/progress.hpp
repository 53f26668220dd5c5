#pragma once

#include "stridor/hearing/heard_recordings.hpp"
#include "stridor/hearing/sound_search.hpp"
#include "stridor/sweep/run.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

// How far long work on sounds is, on stderr: a line that is redrawn in a terminal, a line per 10 % anywhere else, and
// nothing for what takes no time worth a line.

/// How far a sound is rendered.
class RenderDisplay {
public:
    /// `duration` [s] of the run.
    explicit RenderDisplay(double duration) : duration_(duration) {}

    /// `time` [s] of the run is rendered.
    void show(double time);

private:
    double duration_;
    int shown_ = 0;  // [%]
};

/// How far a recording is analysed.
class AnalysisDisplay {
public:
    /// `frames` of a recording of this rate [Hz], where they are known.
    AnalysisDisplay(std::optional<std::uint64_t> frames, double rate);

    /// Is the recording long enough that anybody wants to know? From five minutes on.
    bool is_shown() const { return is_shown_; }
    /// `frames` [1] are analysed.
    void show(std::uint64_t frames);

private:
    double whole_;  // [1] frames
    bool is_shown_;
    int said_ = 0;  // [%]
};

/// How far a search by sound is.
class SearchDisplay {
public:
    /// Shows how far it is. Without a terminal a search of fewer than 50 cells is not shown.
    void show(const hearing::SearchProgress& progress);

private:
    ShareDisplay display_{"listened to", TimeLeft::shown};
};

/// How far a row of recordings is by their bytes: "2 of 8: squeak.wav".
class HeardFilesDisplay {
public:
    /// The recordings that will be heard; the sizes of their files are read now.
    explicit HeardFilesDisplay(const std::vector<hearing::Expectation>& recordings);

    /// The next file is begun.
    void begin(const std::string& file);
    /// `share` [1] of the file that was begun is heard.
    void show(double share);
    /// The file that was begun is heard.
    void end() { done_ += size_; }

private:
    ShareDisplay display_{"listened to", TimeLeft::shown};
    std::size_t count_;
    std::size_t number_ = 0;
    std::string file_;
    std::uintmax_t total_ = 0;  // [bytes]
    std::uintmax_t done_ = 0;   // [bytes]
    std::uintmax_t size_ = 0;   // [bytes] of the one that is heard
};

/// How far a row of recordings is by their number: the whole ones, and the share of the one that is heard.
class RowDisplay {
public:
    /// `what` is done to each, as in "listened to"; `total` [1] recordings.
    RowDisplay(std::string what, std::size_t total) : display_(std::move(what)), total_(total) {}

    /// The next recording is begun. It is shown if it takes long.
    void begin(const std::filesystem::path& file);
    /// `share` [1] of the recording that was begun is heard.
    void show(double share);
    /// The recording that was begun is done.
    void end();
    /// Takes the line away, so that other text can stand there.
    void clear() { display_.clear(); }
    /// Whole recordings so far [1].
    std::size_t done() const { return done_; }

private:
    ShareDisplay display_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::string file_;
    bool is_shown_ = false;
};

}  // namespace stridor::console
