#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/hearing/sound_ring.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

/// An ear for a sound that is not over.
///
/// What comes without a gap is a *take*. Its passages are those of a recording of the same samples, told as soon as
/// they are complete, and its verdict at its end is that recording's, bit for bit. Times count the samples that were
/// heard from the first one on: they do not depend on the pace or the pieces in which these came.
namespace stridor::hearing {

/// A passage of one channel, judged by itself.
struct LivePassage {
    std::size_t channel = 0;     // from 0
    double from = 0.0;           // [s]
    double to = 0.0;             // [s]
    double level = 0.0;          // [dB] above 40 Hz, mean
    double frequency = 0.0;      // [Hz] dominant, of the loudest segment; 0: none
    bool is_background = false;  // `quiet_depth` below the loudest passage of the last minute, hence `none`
    classification::RecordingVerdict verdict{};

    classification::Category category() const;
};

/// A noise of one or more passages with at most two seconds between them, in any channel.
struct LiveNoise {
    std::size_t number = 0;   // [1] from 1
    double from = 0.0;        // [s]
    double to = 0.0;          // [s]
    bool is_cut = false;      // it was too long for one clip: the next noise begins where this one ends
    LivePassage strongest{};  // of the noisy ones, by level; their channels have one unit, or the first is taken
    double clip_from = 0.0;   // [s] two seconds before it, or where the take or the clip before began
    double clip_to = 0.0;     // [s]
};

/// Says why a take is over.
enum class TakeEnd { gap, full, end };

/// A take that is over, and the verdict on it.
struct LiveTake {
    std::size_t number = 0;  // [1] from 1
    double from = 0.0;       // [s]
    double to = 0.0;         // [s]
    TakeEnd why = TakeEnd::end;
    std::vector<sound::SoundAnalysis> channels{};
    std::vector<classification::RecordingVerdict> verdicts{};  // shape [channel]
};

/// Is told what is heard.
struct LiveListener {
    std::function<void(const LivePassage&)> passage = [](const LivePassage&) { /* nobody listens */ };
    std::function<void(const LiveNoise&, signal::Source& clip)> noise = [](const LiveNoise&, signal::Source&) {};
    std::function<void(const LiveTake&)> take = [](const LiveTake&) { /* nobody listens */ };
};

/// How a live ear listens.
struct LiveEarOptions {
    parameters::SoundThresholds thresholds{};
    double longest_take = 3600.0;  // [s] longer ones are cut: their passages must not fill the memory
    double longest_clip = 30.0;    // [s] of the noise in it
};

/// What the last three seconds of a channel are, judged by themselves: a first word, seconds before a passage is told.
struct LiveGuess {
    classification::Category category = classification::Category::none;
    double probability = 0.0;  // [1] of an ear; 0 for a motion
};

/// The level of one channel over the last minute, second by second, for those who watch.
struct LiveCourse {
    double now = 0.0;                                   // [unit²] averaged as sound level meters do, "fast"
    std::deque<double> seconds{};                       // [unit²] greatest of each, sixty at most; the last is now
    std::deque<classification::Category> categories{};  // of the noise in each second; none: no noise
    LiveGuess guess{};                                  // of the last call of `LiveEar::guess`
};

/// Listens to samples as they come.
class LiveEar {
public:
    /// Takes rate and channels. Throws `Error` (input) as `SoundListener` does.
    LiveEar(signal::ChannelLayout layout, const LiveEarOptions& options, LiveListener listener);

    /// Takes the next samples in the channels' units, shape [frame][channel]. Throws `Error` (input) for a sample that
    /// is not finite; those of the same tenth of a second are not heard then.
    void push(std::span<const double> frames);

    /// Ends the take, for what comes next does not follow on what came. Tells what is left of it.
    void gap() { end_take(TakeEnd::gap); }

    /// Ends the sound.
    void finish() { end_take(TakeEnd::end); }

    /// Judges the last three seconds of each channel of this take. Background counts as none. It takes as long as
    /// hearing these seconds.
    void guess();

    /// Returns how much was heard [s].
    double heard() const { return seconds_of(heard_ + pending_.size() / layout_.channels.size()); }

    /// Returns the level of each channel; shape [channel].
    const std::vector<LiveCourse>& courses() const { return courses_; }

    const signal::ChannelLayout& layout() const { return layout_; }

private:
    /// What a channel has told of this take.
    struct Told {
        std::size_t passages = 0;
        std::size_t stretches = 0;                     // of a motion: those in windows that were told
        std::deque<std::pair<double, double>> loud{};  // [s], [unit²] passages of the last minute
    };

    double seconds_of(std::uint64_t frames) const { return static_cast<double>(frames) / layout_.rate; }
    double take_from() const { return seconds_of(take_begin_); }
    void hear(std::span<const double> frames);
    void watch(std::span<const double> frames);
    void tell_new_passages();
    void tell_rest(const sound::SoundAnalysis& analysis, std::size_t channel);
    void tell_passages(std::size_t channel, std::span<const sound::Passage> passages,
                       std::span<const sound::SoundStretch> stretches);
    void tell_stretches(std::size_t channel, std::span<const sound::SoundStretch> stretches, bool is_over);
    void tell(std::size_t channel, sound::SoundAnalysis part, double from, double to);
    bool is_background(std::size_t channel, double power) const;
    void take_noise(const LivePassage& passage);
    void end_noise();
    void end_take(TakeEnd why);

    signal::ChannelLayout layout_;
    LiveEarOptions options_;
    LiveListener listener_;
    std::size_t hop_;  // frames that are heard at a time
    std::vector<double> pending_{};
    std::uint64_t heard_ = 0;       // frames
    std::uint64_t take_begin_ = 0;  // frames
    std::size_t takes_ = 0;
    std::size_t noises_ = 0;
    std::optional<sound::SoundListener> analysis_{};
    std::vector<Told> told_{};
    std::vector<LiveCourse> courses_;
    std::uint64_t second_ = 0;  // the last one of the courses
    SoundRing ring_;
    std::optional<LiveNoise> noise_{};
    double cut_at_ = 0.0;  // [s] the end of the last noise that was too long for one clip
};

}  // namespace stridor::hearing
