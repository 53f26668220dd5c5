#include "sounds/sound_options.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"

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

// nothing for short ones
sound::AnalysisProgress progress_of(const signal::ChannelLayout& layout) {
    console::AnalysisDisplay display(layout.frames, layout.rate);
    if (!display.is_shown()) return {};
    return [display](std::uint64_t frames) mutable { display.show(frames); };
}

}  // namespace

void add_full_scale_option(CLI::App& command, std::vector<std::string>& full_scales) {
    command
        .add_option("--full-scale", full_scales,
                    "what the number 1 in the file stands for: \"2 Pa\"; once, or once per channel")
        ->type_name("QUANTITY")
        ->allow_extra_args(false);
}

void add_input_options(CLI::App& command, InputOptions& options) {
    add_full_scale_option(command, options.full_scales);
    command.add_option("--channel", options.channel, "this channel alone: its name, or its number from 1")
        ->type_name("NAME|NUMBER");
    command.add_option("--dataset", options.dataset, "this time history of a UFF file, counted from 1")
        ->check(CLI::Range(1, 1'000'000));
    command.add_option("--rate", options.rate, "sampling rate of a CSV table or MAT file that does not tell it")
        ->type_name("HZ");
}

recordings::OpenOptions open_options(const InputOptions& options) {
    recordings::OpenOptions open;
    open.full_scales = recordings::parse_full_scales(options.full_scales);
    if (!options.rate.empty()) open.rate = base::parse_quantity(options.rate, "Hz");
    if (open.rate && !(*open.rate > 0.0))
        throw Error(ErrorKind::input, {"\"" + options.rate + "\" is no sampling rate", "it must be positive", ""});
    open.channel_name = options.channel;
    if (options.dataset > 0) open.dataset = options.dataset;
    return open;
}

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
        console::say("stridor: note: " + note);
    report.channels = sound::analyse(*file, progress_of(file->layout()), side_by_side, field);
    for (const sound::SoundAnalysis& analysis : report.channels)
        report.verdicts.push_back(classification::verdict_on(analysis, report.thresholds));
    report.loudest = sound::loudest(report.channels);
    return report;
}

}  // namespace stridor::app
