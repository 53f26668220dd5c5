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

/// Returns one line about the progress of a sweep: bar, cells, rate, time left, running counts. At most `columns` wide.
std::string progress_line(const sweep::Progress& progress, int columns);

/// Returns running counts: "none 812  squeal 340  squeak 51  creak 12  failed 3"; only those that occur.
std::string counts_text(const sweep::Counts& counts);

/// Shows a sweep's progress on stderr: a line that is redrawn in a terminal, a line per 10 % anywhere else.
class ProgressDisplay {
public:
    /// Shows the progress of the sweep. Prints nothing if nothing has changed.
    void show(const sweep::Progress& progress);

    /// Leaves the last state on the screen and moves to a fresh line.
    void finish();

private:
    std::size_t last_done_ = 0;  // [1] cells when it last said something
    std::size_t last_total_ = 0;
    bool is_started_ = false;
    bool has_line_ = false;
};

/// Says whether a row of so many recordings, or of so many bytes, deserves a progress line.
constexpr bool takes_long(std::size_t recordings, std::uintmax_t bytes) {
    constexpr std::size_t many = 20;
    constexpr std::uintmax_t some_minutes_of_sound = 60'000'000;
    return recordings >= many || bytes >= some_minutes_of_sound;
}

/// Whether a display shows the time left.
enum class TimeLeft { hidden, shown };

/// Shows on stderr the progress of a long piece of work: a line that is redrawn in a terminal, a line per 10 % anywhere
/// else.
class ShareDisplay {
public:
    /// Begins the line with `what`: "analysed".
    explicit ShareDisplay(std::string what, TimeLeft time_left = TimeLeft::hidden)
        : what_(std::move(what)),
          time_left_(time_left) {}
    ~ShareDisplay() { clear(); }
    ShareDisplay(const ShareDisplay&) = delete;
    ShareDisplay& operator=(const ShareDisplay&) = delete;

    /// Shows the share [1] that is done; `detail` ends the line.
    void show(double share, const std::string& detail = "");

    /// Removes the line from the screen, before anything else is written.
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

// Progress of long work on sounds, on stderr: a line that is redrawn in a terminal, a line per 10 % anywhere else, and
// no line for short work.

/// Shows the progress of rendering a sound.
class RenderDisplay {
public:
    /// Takes the `duration` [s] of the run.
    explicit RenderDisplay(double duration) : duration_(duration) {}

    /// Shows that `time` [s] of the run is rendered.
    void show(double time);

private:
    double duration_;
    int shown_ = 0;  // [%]
};

/// Shows the progress of analysing a recording.
class AnalysisDisplay {
public:
    /// Takes the number of `frames`, if it is known, and the rate [Hz] of the recording.
    AnalysisDisplay(std::optional<std::uint64_t> frames, double rate);

    /// Says whether the recording is long enough for a progress line: five minutes or more.
    bool is_shown() const { return is_shown_; }
    /// Shows that `frames` [1] are analysed.
    void show(std::uint64_t frames);

private:
    double whole_;  // [1] frames
    bool is_shown_;
    int said_ = 0;  // [%]
};

/// Shows the progress of a search by sound.
class SearchDisplay {
public:
    /// Shows the progress. Without a terminal a search of fewer than 50 cells is not shown.
    void show(const hearing::SearchProgress& progress);

private:
    ShareDisplay display_{"listened to", TimeLeft::shown};
};

/// Shows the progress in a row of recordings by their bytes: "2 of 8: squeak.wav".
class HeardFilesDisplay {
public:
    /// Takes the recordings that will be heard, and reads the sizes of their files now.
    explicit HeardFilesDisplay(const std::vector<hearing::Expectation>& recordings);

    /// Begins the next file.
    void begin(const std::string& file);
    /// Shows the share [1] of the present file that is heard.
    void show(double share);
    /// Ends the present file.
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

/// Shows the progress in a row of recordings by their number: the whole ones, and the share of the present one.
class RowDisplay {
public:
    /// Takes the word for the work, as in "listened to", and the `total` number of recordings [1].
    RowDisplay(std::string what, std::size_t total) : display_(std::move(what)), total_(total) {}

    /// Begins the next recording. It is shown if it takes long.
    void begin(const std::filesystem::path& file);
    /// Shows the share [1] of the present recording that is heard.
    void show(double share);
    /// Ends the present recording.
    void end();
    /// Removes the line, so that other text can stand there.
    void clear() { display_.clear(); }
    /// Returns the number of whole recordings so far [1].
    std::size_t done() const { return done_; }

private:
    ShareDisplay display_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::string file_;
    bool is_shown_ = false;
};

}  // namespace stridor::console
