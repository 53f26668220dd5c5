#include "sound_options.hpp"

#include "stridor/base/quantity.hpp"
#include "stridor/classification/sound_rules.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <cmath>

namespace stridor::app {

namespace {

void side_by_side(std::size_t count, const std::function<void(std::size_t)>& work) {
    tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner());
}

// a line that is redrawn in a terminal, a line per 10 % of long recordings anywhere else, nothing for short ones
sound::AnalysisProgress progress_of(const signal::ChannelLayout& layout) {
    constexpr double long_recording = 300.0;  // [s]
    const double whole = layout.frames ? static_cast<double>(*layout.frames) : 0.0;
    if (whole < long_recording * layout.rate) return {};
    return [whole, said = 0](std::uint64_t frames) mutable {
        const int percent = static_cast<int>(100.0 * static_cast<double>(frames) / whole);
        if (percent < said + (has_terminal() ? 1 : 10)) return;
        said = percent;
        const std::string line = fmt::format("analysed {} %", percent);
        if (has_terminal())
            static_cast<void>(std::fprintf(stderr, "\r%s%s", line.c_str(), percent >= 100 ? "\n" : ""));
        else
            say(line);
    };
}

}  // namespace

void add_sound_options(CLI::App& command, SoundOptions& options) {
    command
        .add_option("file", options.file,
                    "WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT file; - for standard input")
        ->required();
    add_input_options(command, options.recording);
    command.add_option("--set", options.thresholds, "another threshold: --set squeal_regularity=0.7 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

io::SoundReport listen_to(const SoundOptions& options, std::optional<sound::SoundField> field) {
    io::SoundReport report;
    for (const std::string& assignment : options.thresholds)
        parameters::set_sound_threshold(report.thresholds, assignment);
    const std::unique_ptr<recordings::SignalFile> file =
        recordings::open_signal(options.file, open_options(options.recording));
    report.file = file->facts().name;
    report.format = file->facts().format;
    report.notes = file->facts().notes;
    for (const std::string& note : report.notes)
        say("stridor: note: " + note);
    report.channels = sound::analyse(*file, progress_of(file->layout()), side_by_side, field);
    for (const sound::SoundAnalysis& analysis : report.channels)
        report.verdicts.push_back(classification::classify_recording(analysis.stretches, report.thresholds));
    report.loudest = sound::loudest(report.channels);
    return report;
}

std::string channel_title(const io::SoundReport& report, std::size_t channel) {
    const sound::SoundAnalysis& analysis = report.channels[channel];
    const bool is_only = report.channels.size() == 1;
    std::string text = is_only ? report.file : fmt::format("{}, channel {}", report.file, channel + 1);
    if (!analysis.name.empty()) text += " (" + analysis.name + ")";
    return text;
}

std::string segment_table(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    const double reference = signal::reference_of(analysis.unit);
    std::string text =
        fmt::format("{:>9}{:>10}  {:<10}{:>9}{:>11}{:>9}{:>11}{:>9}{:>7}{:>9}\n", "from", "to", "category", "level",
                    "frequency", "tonal", "regularity", "moves", "rest", "kurtosis");
    for (const classification::SoundSegment& segment : verdict.segments) {
        const sound::SoundFeatures& f = segment.verdict.features;
        const bool is_noisy = segment.verdict.category != classification::Category::none;
        const std::string category = styled(fmt::format("{:<10}", classification::name(segment.verdict.category)),
                                            is_noisy ? Style::bold : Style::plain, STDOUT_FILENO);
        text += fmt::format("{:>7.3f} s{:>8.3f} s  {}", segment.from, segment.to, category);
        if (f.mean_square > 0.0)
            text += fmt::format("{:>6.1f} dB{:>8.0f} Hz{:>9.2f}{:>11.3f}{:>7.1f} %{:>7.2f}{:>9.1f}\n",
                                signal::level_of(segment.mean_square, reference), f.frequency, f.tonality, f.regularity,
                                100.0 * f.movement, f.rest, f.kurtosis);
        else
            text += "  silence\n";
    }
    return text;
}

}  // namespace stridor::app
