#include "commands.hpp"
#include "input_options.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/signal_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/sound/signal_report.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/table/signal_csv_writer.hpp"
#include "stridor/recordings/uff58/uff58.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct ConvertOptions {
    std::string input;
    std::string output;  // empty: only say what the input holds
    InputOptions recording;
    std::string format;
    std::string bits;
    bool json = false;
};

std::string format_of(const ConvertOptions& options) {
    if (!options.format.empty()) return options.format;
    std::string ending = std::filesystem::path(options.output).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    if (ending == ".wav") return "wav";
    if (ending == ".csv" || ending == ".tsv" || ending == ".txt") return "csv";
    if (ending == ".uff" || ending == ".unv" || ending == ".uf" || ending == ".58") return "uff58b";
    throw Error(ErrorKind::input, {"the name \"" + options.output + "\" does not tell the format to write",
                                   "known are .wav, .csv and .uff", "Say it with --format."});
}

// the next of 1, 2, 5, 10, ... above the peak: whole numbers end one step below full scale
double round_full_scale(double peak) {
    if (!(peak > 0.0)) return 1.0;
    const int exponent = static_cast<int>(std::floor(std::log10(peak)));
    for (const int digit : {1, 2, 5, 10, 20})
        if (const double scale = digit * std::pow(10.0, exponent); scale > peak) return scale;
    return peak;
}

// a sound keeps its own scale; other measurements get one they fit in, 1 of the unit where single floats hold any
std::vector<recordings::FullScale> wav_full_scales(const io::SignalSummary& summary, recordings::WavSamples samples) {
    std::vector<recordings::FullScale> scales;
    for (std::size_t k = 0; k < summary.peaks.size(); ++k) {
        recordings::FullScale scale = summary.facts.full_scales[k];
        const bool is_whole = samples != recordings::WavSamples::float_32;
        if (is_whole && summary.peaks[k] > scale.value) scale.value = round_full_scale(summary.peaks[k]);
        scales.push_back(scale);
    }
    return scales;
}

recordings::WavSamples wav_samples(const ConvertOptions& options, const io::SignalSummary& summary) {
    if (options.bits == "16") return recordings::WavSamples::pcm_16;
    if (options.bits == "24") return recordings::WavSamples::pcm_24;
    if (options.bits == "float") return recordings::WavSamples::float_32;
    // what was whole numbers of sound goes back to such
    const std::string& format = summary.facts.format;
    if (format.find("16 bit PCM") != std::string::npos) return recordings::WavSamples::pcm_16;
    return format.find("24 bit PCM") != std::string::npos ? recordings::WavSamples::pcm_24
                                                          : recordings::WavSamples::float_32;
}

io::SignalOutput write(const ConvertOptions& options, const io::SignalSummary& summary, signal::Source& source) {
    io::SignalOutput output{options.output, format_of(options), 0};
    const bool is_stdout = options.output == "-";
    const std::string path = is_stdout ? "/dev/stdout" : options.output;
    if (output.format == "wav") {
        const recordings::WavSamples samples = wav_samples(options, summary);
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

void convert(const ConvertOptions& options) {
    const recordings::OpenOptions open = open_options(options.recording);
    if (!options.output.empty()) format_of(options);  // before hours are read
    const recordings::SignalInput input = recordings::open_input(options.input);
    const io::SignalSummary summary = io::summary_of(*recordings::open_signal(input, open));
    for (const std::string& note : summary.facts.notes)
        console::say("stridor: note: " + note);
    std::optional<io::SignalOutput> output;
    if (!options.output.empty()) {
        output = write(options, summary, *recordings::open_signal(input, open));
        if (output->clipped > 0)
            console::say(fmt::format("stridor: note: {} samples were cut to full scale", output->clipped));
    }
    const std::string text = options.json ? io::convert_json(summary, output) + "\n" : console::signal_text(summary);
    if (options.output == "-")
        console::say(text);
    else
        console::print(text);
}

}  // namespace

void add_convert(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Read a recording of any format, say what it holds, and write it as another.");
    command
        ->add_option("in", options->input,
                     "WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT file; - for standard input")
        ->required();
    command->add_option("out", options->output,
                        "file to write (.wav, .csv, .uff); without it only the report is printed");
    add_input_options(*command, options->recording);
    command->add_option("--format", options->format, "of OUT, whatever its name")
        ->check(CLI::IsMember({"wav", "csv", "uff58", "uff58b"}));
    command->add_option("--bits", options->bits, "of a WAV's samples; by default as in IN, or float")
        ->check(CLI::IsMember({"16", "24", "float"}));
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.convert/1)");
    command->footer(
        "Without --full-scale the unit comes from NAME.json beside the recording, the text in its header, or its own "
        "units; "
        "without any it is FS.\n"
        "Examples:\n  stridor convert squeak.wav\n  stridor convert squeak.wav squeak.uff --full-scale \"2 Pa\"\n"
        "  stridor convert rig.uff rig.wav --bits 24 --channel 1");
    command->callback([options] { convert(*options); });
}

}  // namespace stridor::app
