#include "stridor/io/sound/signal_report.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/json_parts.hpp"
#include "stridor/recordings/table/signal_csv.hpp"
#include "stridor/recordings/uff58/uff58.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace stridor::io {

namespace {

using base::Json;

constexpr std::size_t block_frames = 1U << 14U;

Json channels_of(const SignalSummary& summary) {
    Json channels = Json::array();
    for (std::size_t k = 0; k < summary.layout.channels.size(); ++k) {
        const signal::Channel& channel = summary.layout.channels[k];
        channels.push_back({{"name", channel.name},
                            {"unit", channel.unit},
                            {"unit_in_file", base::text_or_null(summary.facts.units_in_file[k])},
                            {"full_scale", summary.facts.full_scales[k].value},
                            {"calibration", name(summary.facts.calibrations[k])},
                            {"peak", summary.peaks[k]}});
    }
    return channels;
}

// a sound keeps its own scale; other measurements get one they fit in, 1 of the unit where single floats hold any
std::vector<recordings::FullScale> wav_full_scales(const SignalSummary& summary, recordings::WavSamples samples) {
    std::vector<recordings::FullScale> scales;
    for (std::size_t k = 0; k < summary.peaks.size(); ++k) {
        recordings::FullScale scale = summary.facts.full_scales[k];
        const bool is_whole = samples != recordings::WavSamples::float_32;
        if (is_whole && summary.peaks[k] > scale.value) scale.value = round_full_scale(summary.peaks[k]);
        scales.push_back(scale);
    }
    return scales;
}

recordings::WavSamples wav_samples(const SignalTarget& target, const SignalSummary& summary) {
    if (target.bits == "16") return recordings::WavSamples::pcm_16;
    if (target.bits == "24") return recordings::WavSamples::pcm_24;
    if (target.bits == "float") return recordings::WavSamples::float_32;
    // what was whole numbers of sound goes back to such
    const std::string& format = summary.facts.format;
    if (format.find("16 bit PCM") != std::string::npos) return recordings::WavSamples::pcm_16;
    return format.find("24 bit PCM") != std::string::npos ? recordings::WavSamples::pcm_24
                                                          : recordings::WavSamples::float_32;
}

}  // namespace

WatchedSource::WatchedSource(signal::Source& source) : source_(source), peaks_(source.layout().channels.size(), 0.0) {}

std::size_t WatchedSource::read(std::span<double> frames) {
    const std::size_t count = source_.read(frames);
    const std::size_t width = peaks_.size();
    for (std::size_t k = 0; k < count * width; ++k)
        peaks_[k % width] = std::max(peaks_[k % width], std::abs(frames[k]));
    frames_ += count;
    return count;
}

SignalSummary summary_of(recordings::SignalFile& file) {
    WatchedSource watched(file);
    std::vector<double> block(block_frames * watched.layout().channels.size());
    while (watched.read(block) > 0) {
    }
    SignalSummary summary{file.facts(), file.layout(), watched.peaks()};
    summary.layout.frames = watched.frames();
    return summary;
}

std::string_view name(recordings::Calibration calibration) {
    constexpr std::array<std::string_view, 5> names{"option", "sidecar", "description", "file", "none"};
    return names[static_cast<std::size_t>(calibration)];
}

std::string convert_json(const SignalSummary& summary, const std::optional<SignalOutput>& output) {
    const std::uint64_t frames = summary.layout.frames.value_or(0);
    Json document = json_parts::opening("convert");
    document["file"] = summary.facts.name;
    document["format"] = summary.facts.format;
    document["rate"] = summary.layout.rate;
    document["frames"] = frames;
    document["duration"] = static_cast<double>(frames) / summary.layout.rate;
    document["time"] = base::text_or_null(summary.facts.time);
    document["channels"] = channels_of(summary);
    document["left_out"] = summary.facts.left_out;
    document["notes"] = summary.facts.notes;
    document["metadata"] = Json::object();
    for (const auto& [key, value] : summary.facts.metadata)
        document["metadata"][key] = value;
    if (output) document["output"] = {{"file", output->name}, {"format", output->format}, {"clipped", output->clipped}};
    document["units"] = {{"rate", "Hz"}, {"duration", "s"}};
    return base::text_of(document);
}

std::string format_of(const SignalTarget& target) {
    if (!target.format.empty()) return target.format;
    std::string ending = std::filesystem::path(target.file).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending == ".wav") return "wav";
    if (ending == ".csv" || ending == ".tsv" || ending == ".txt") return "csv";
    if (ending == ".uff" || ending == ".unv" || ending == ".uf" || ending == ".58") return "uff58b";
    throw Error(ErrorKind::input, {"the name \"" + target.file + "\" does not tell the format to write",
                                   "known are .wav, .csv and .uff", "Say it with --format."});
}

double round_full_scale(double peak) {
    if (!(peak > 0.0)) return 1.0;
    const int exponent = static_cast<int>(std::floor(std::log10(peak)));
    for (const int digit : {1, 2, 5, 10, 20})
        if (const double scale = digit * std::pow(10.0, exponent); scale > peak) return scale;
    return peak;
}

SignalOutput write_signal(const SignalTarget& target, const SignalSummary& summary, signal::Source& source) {
    SignalOutput output{target.file, format_of(target), 0};
    const bool is_stdout = target.file == "-";
    const std::string path = is_stdout ? "/dev/stdout" : target.file;
    if (output.format == "wav") {
        const recordings::WavSamples samples = wav_samples(target, summary);
        if (is_stdout)
            throw Error(ErrorKind::input, {"a WAV file cannot be written to standard output",
                                           "its header needs the length of the recording", "Name a file."});
        output.clipped = recordings::write_wav(path, source, {samples, wav_full_scales(summary, samples), ""}).clipped;
    } else if (output.format == "csv") {
        recordings::write_signal_csv(path, source);
    } else {
        recordings::write_uff58(
            path, source, output.format == "uff58" ? recordings::Uff58Form::ascii : recordings::Uff58Form::binary);
    }
    return output;
}

}  // namespace stridor::io
