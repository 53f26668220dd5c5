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

/// Facts that the user knows better than the file.
struct OpenOptions {
    std::vector<FullScale> full_scales{};  // the value of the number 1 in the file, for all channels or one each
    std::optional<double> rate{};          // [Hz] of a CSV table or a MAT file
    std::optional<std::size_t> dataset{};  // [1] of the time histories of a UFF file, from 1
    std::optional<std::size_t> channel{};  // [1] this one alone, from 1
    std::string channel_name{};            // the channel by its name, or its number as text (`signal::channel_named`)
};

/// The origin of a channel's unit; each has priority over those after it.
enum class Calibration { option, sidecar, description, file, none };

/// The facts of a recording, and how it was read.
struct SignalFacts {
    std::string name;                         // of the file
    std::string format;                       // "WAV (Microsoft), Signed 24 bit PCM"
    std::vector<FullScale> full_scales{};     // the value of the number 1 in the file, shape [channel]
    std::vector<Calibration> calibrations{};  // shape [channel]
    std::vector<std::string> notes{};         // facts for the user, one sentence each
    std::vector<std::pair<std::string, std::string>> metadata{};  // further facts in the file and its sidecar
    std::string time{};                        // the column of times: column 1, "t" in ms; empty: a rate
    std::vector<std::string> left_out{};       // content of the file that is no channel, with the reason
    std::vector<std::string> units_in_file{};  // as the file has them, shape [channel]; empty: none
};

/// Returns the calibration that somebody gave a recording (by an option, a sidecar, its description), as text that
/// `full_scales_in` reads: one for all channels, or one for each if they differ; empty if there is none.
std::string given_calibration(const SignalFacts& facts);

/// A recording on a disk: samples in SI units, read in blocks.
class SignalFile final : public signal::Source {
public:
    /// Reads these channels of the file (`picked`), counted from 0.
    SignalFile(RawSignal raw, signal::ChannelLayout layout, SignalFacts facts, std::vector<std::size_t> picked);

    const signal::ChannelLayout& layout() const override { return layout_; }
    std::size_t read(std::span<double> frames) override;

    /// Returns the facts in the file and its sidecar beside the samples.
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
/// through ffmpeg's libraries if they are installed, a table of signals as CSV, UFF 58 and 58b, MAT files through
/// libmatio if it is installed. The content decides the format; "-" is standard input.
///
/// Units come from the options, else the sidecar NAME.json, else the calibration in the file's description, else the
/// units in the file; samples without a unit are "FS". In a file of several channels, a channel with values that are no
/// samples (not finite, an overload), or with a counter, is left out with a note, unless it is requested by its name.
/// Channels are counted without it. Throws `Error` (input) for a file that is damaged, empty, or of unknown format, and
/// `Error` (io) if it cannot be read. Samples that are not finite are refused with their frame while reading.
std::unique_ptr<SignalFile> open_signal(const std::string& path, const OpenOptions& options = {});

/// Says whether this is the beginning of a recording: a sound, a UFF or a MAT file. Tables have no mark.
bool is_recording(std::string_view beginning);

/// Opens the file of a recording without reading it, so that it can be read twice, even standard input. Throws `Error`
/// (io).
SignalInput open_input(const std::string& path);

/// Opens a recording from an open file, or from bytes in memory. Throws `Error` (input) for a file that
/// is damaged, empty, or of unknown format, and `Error` (io) if it cannot be read.
std::unique_ptr<SignalFile> open_signal(const SignalInput& input, const OpenOptions& options = {});

}  // namespace stridor::recordings
