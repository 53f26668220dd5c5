#pragma once

#include "stridor/recordings/calibration.hpp"
#include "stridor/recordings/raw_signal.hpp"
#include "stridor/signal/source.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::recordings {

/// What the user knows better than the file.
struct OpenOptions {
    std::vector<FullScale> full_scales{};  // what the number 1 in the file stands for, of every channel or one each
    std::optional<double> rate{};          // [Hz] of a CSV table or a MAT file
    std::optional<std::size_t> dataset{};  // [1] of the time histories of a UFF file, from 1
    std::optional<std::size_t> channel{};  // [1] this one alone, from 1
    std::string channel_name{};            // the same by its name, or its number as text (`signal::channel_named`)
};

/// Where the unit of a channel comes from; each is stronger than those after it.
enum class Calibration { option, sidecar, description, file, none };

/// What a recording says of itself, and how it was read.
struct SignalFacts {
    std::string name;                         // of the file
    std::string format;                       // "WAV (Microsoft), Signed 24 bit PCM"
    std::vector<FullScale> full_scales{};     // what the number 1 in the file stands for, shape [channel]
    std::vector<Calibration> calibrations{};  // shape [channel]
    std::vector<std::string> notes{};         // what the user should know, one sentence each
    std::vector<std::pair<std::string, std::string>> metadata{};  // what else the file and its sidecar say
    std::string time{};                        // what was taken for the time: column 1, "t" in ms; empty: a rate
    std::vector<std::string> left_out{};       // what is in the file and no channel, with the reason
    std::vector<std::string> units_in_file{};  // as the file has them, shape [channel]; empty: none
};

/// The calibration that somebody gave a recording (by an option, a sidecar, its description), as text that
/// `full_scales_in` reads: for one channel, or for each where they differ; empty where nobody did.
std::string given_calibration(const SignalFacts& facts);

/// A recording on a disk: samples in SI units, read in blocks.
class SignalFile final : public signal::Source {
public:
    /// `picked` are the channels of the file to read, counted from 0.
    SignalFile(RawSignal raw, signal::ChannelLayout layout, SignalFacts facts, std::vector<std::size_t> picked);

    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> frames) override;

    /// What the file and its sidecar say beside the samples.
    const SignalFacts& facts() const { return facts_; }

private:
    double sample(std::size_t index, std::size_t channel) const;

    RawSignal raw_;
    signal::ChannelLayout layout_;
    SignalFacts facts_;
    std::vector<std::size_t> picked_;  // channels of the file, shape [channel]
    std::vector<double> block_;        // as in the file, shape [frame][channel of the file]
    std::uint64_t frames_ = 0;         // read so far
};

/// Opens a recording: WAV, RF64, W64, FLAC, Ogg, MP3, AIFF and others through libsndfile, MPEG-4, AAC, AMR and WebM
/// through ffmpeg's libraries where they are there, a table of signals as CSV, UFF 58 and 58b, MAT files through
/// libmatio where it is there.
/// The format is told by the content; "-" is standard input.
///
/// Units come from the options, else the sidecar NAME.json, else the calibration in the file's description, else the
/// units in the file; samples without any are "FS" and nothing else. A channel among others that holds what is no
/// sample (not finite, an overload) or a counter is left out with a note, unless it is asked for by its name. Channels
/// are counted without it. Throws `Error` (input) for what is damaged, empty, or of no known format, and `Error` (io)
/// for what cannot be read. Samples that are not finite are refused with their frame while reading.
std::unique_ptr<SignalFile> open_signal(const std::string& path, const OpenOptions& options = {});

/// Is this the beginning of a recording: a sound, a UFF or a MAT file? Tables have none.
bool is_recording(std::string_view beginning);

/// The same in two steps: what is open can be read twice, even standard input; and bytes in memory can be read.
SignalInput open_input(const std::string& path);

/// Likewise, of what is open.
std::unique_ptr<SignalFile> open_signal(const SignalInput& input, const OpenOptions& options = {});

}  // namespace stridor::recordings
