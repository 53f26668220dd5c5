#pragma once

#include "stridor/signal/level.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/signal/spectrogram.hpp"
#include "stridor/signal/spectrum.hpp"
#include "stridor/sound/course.hpp"
#include "stridor/sound/passages.hpp"
#include "stridor/sound/quality.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stridor::sound {

/// The shape of a waveform over equal moments.
struct Waveform {
    double interval = 0.0;  // [s]
    std::vector<SampleExtent> extents{};
};

/// The results of one channel of a recording.
struct SoundAnalysis {
    std::string name{};                     // of the channel; may be empty
    std::string unit = signal::full_scale;  // of its samples
    double rate = 0.0;                      // [Hz]
    double duration = 0.0;                  // [s]
    double mean_square = 0.0;               // [unit²] of all samples
    double peak = 0.0;                      // [unit] largest magnitude
    double greatest_weighted = 0.0;         // [unit²] greatest A-weighted mean square of any frame
    signal::LevelHistory level{};           // [dB re `reference_of(unit)`] fast
    signal::Spectrum spectrum{};
    signal::Spectrogram spectrogram{};
    Waveform waveform{};
    std::vector<SoundStretch> stretches{};  // one after the other, in time
    std::vector<Passage> passages{};        // in time; of a microphone's channel: in Pa or uncalibrated
    signal::Spectrogram impulses{};         // of the loudest passage, through short frames
    std::optional<SoundQuality> quality{};  // of a channel in Pa, if asked for
};

/// Describes one channel as a whole as its samples come: levels, spectra, waveform. Its memory does not grow.
class ChannelOverview {
public:
    /// Takes the `rate` [Hz] of the samples; the channel says their unit.
    ChannelOverview(double rate, signal::Channel channel);
    ~ChannelOverview();
    ChannelOverview(ChannelOverview&&) noexcept;
    ChannelOverview& operator=(ChannelOverview&&) noexcept;

    /// Returns the level of the channel, which takes each sample before `push` does.
    signal::LevelMeter& meter();

    /// Takes the next samples in the channel's unit.
    void push(std::span<const double> samples);

    /// Ends the recording and returns its description. The stretches are left to `StretchFinder`.
    SoundAnalysis finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Called as a recording is read, with the number of frames done.
using AnalysisProgress = std::function<void(std::uint64_t frames)>;

/// Does the pieces of work 0 ... count - 1, which are independent, and returns when all are done. Pass a runner with
/// threads here.
using Runner = std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)>;
void one_after_the_other(std::size_t count, const std::function<void(std::size_t)>& work);

/// Analyses a recording as its samples come, for a sound whose end is not in sight. Its results are those of `analyse`,
/// bit for bit, however the samples are cut into pieces. Its memory grows by some kilobytes per channel and second.
class SoundListener {
public:
    /// Takes rate and channels. Throws `Error` (input) for a rate below 1 kHz or above 10 MHz, and for more than 64
    /// channels.
    explicit SoundListener(const signal::ChannelLayout& layout);
    ~SoundListener();
    SoundListener(SoundListener&&) noexcept;
    SoundListener& operator=(SoundListener&&) noexcept;

    /// Takes the next samples, shape [frame][channel]. The first 65,536 frames wait for each other: what stands still
    /// in them is taken away. Throws `Error` (input) for a sample that is not finite.
    void push(std::span<const double> frames);

    /// Returns the passages that are complete so far, in time; empty for a channel that is no microphone's.
    std::span<const Passage> passages(std::size_t channel) const;

    /// Returns the stretches that are complete so far, in time.
    std::span<const SoundStretch> stretches(std::size_t channel) const;

    /// Ends the recording and returns the analysis of all channels; shape [channel]. Throws `Error` (input) for a
    /// recording without samples.
    std::vector<SoundAnalysis> finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Says whether a channel counts as a microphone's: one in Pa does, and an uncalibrated one; motions and forces are
/// heard as they are.
bool is_heard_through_air(const signal::Channel& channel);

/// Reads a recording to its end and returns the analysis of all channels; shape [channel].
///
/// The stretches, the passages and the overview of each channel are pieces of work for `run`, and so is reading on. If
/// `field` is given, the channels in Pa get their sound quality, heard in that field. A constant part of a channel that
/// outweighs the changing part (gravity in an accelerometer) is taken away first, so that levels and peaks are those of
/// the changing part.
///
/// Throws what `Source::read` throws, and `Error` (input) for a recording without samples or with one that is not
/// finite, for a rate below 1 kHz or above 10 MHz, and for more than 64 channels.
std::vector<SoundAnalysis> analyse(signal::Source& source, const AnalysisProgress& progress = {},
                                   const Runner& run = one_after_the_other, std::optional<SoundField> field = {});

/// Returns the channel with the greatest level above 40 Hz, the first of equals. There must be at least one. Levels are
/// compared and not samples, since channels may have different units.
std::size_t loudest(std::span<const SoundAnalysis> channels);

}  // namespace stridor::sound
