#include "stridor/io/sound/signal_output.hpp"

#include "stridor/base/error.hpp"
#include "stridor/recordings/table/signal_csv_writer.hpp"
#include "stridor/recordings/uff58/uff58.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace stridor::io {

namespace {

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
