#include "sounds/sound_options.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

namespace stridor::app {

namespace {

// Each thread takes the next piece when it is done with one: the dearest come first, so none waits long at the end.
void side_by_side(std::size_t count, const std::function<void(std::size_t)>& work) {
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    std::atomic<std::size_t> next{0};
    const auto take = [&](std::size_t /*thread*/) {
        for (std::size_t piece = next++; piece < count; piece = next++)
            work(piece);
    };
    tbb::parallel_for(std::size_t{0}, std::min(threads, count), take, tbb::simple_partitioner());
}

// nothing for short ones
sound::AnalysisProgress progress_of(const signal::ChannelLayout& layout) {
    console::AnalysisDisplay display(layout.frames, layout.rate);
    if (!display.is_shown()) return {};
    return [display](std::uint64_t frames) mutable { display.show(frames); };
}

/// A recording that is opened, and what is known of it.
struct Listening {
    explicit Listening(const SoundOptions& options) {
        report.thresholds = thresholds_of(options);
        file = recordings::open_signal(options.file, open_options(options.recording));
        report.file = file->facts().name;
        report.format = file->facts().format;
        report.notes = file->facts().notes;
    }

    void hear(const sound::AnalysisProgress& progress, std::optional<sound::SoundField> field = {}) {
        report.channels = sound::analyse(*file, progress, side_by_side, field);
        for (const sound::SoundAnalysis& analysis : report.channels)
            report.verdicts.push_back(classification::verdict_on(analysis, report.thresholds));
        report.loudest = sound::loudest(report.channels);
    }

    std::unique_ptr<recordings::SignalFile> file{};
    io::SoundReport report{};
};

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

void add_listening_options(CLI::App& command, SoundOptions& options) {
    add_input_options(command, options.recording);
    command.add_option("--set", options.thresholds, "another threshold: --set certainty=0.6 (repeatable)")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

void add_sound_options(CLI::App& command, SoundOptions& options) {
    command
        .add_option("file", options.file,
                    "WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT file; - for standard input")
        ->required();
    add_listening_options(command, options);
}

parameters::SoundThresholds thresholds_of(const SoundOptions& options) {
    parameters::SoundThresholds thresholds;
    for (const std::string& assignment : options.thresholds)
        parameters::set_sound_threshold(thresholds, assignment);
    return thresholds;
}

Judges judges_of(std::span<const signal::Channel> channels) {
    Judges judges;
    for (const signal::Channel& channel : channels)
        (sound::is_heard_through_air(channel) ? judges.ear : judges.rules) = true;
    return judges;
}

Judges judges_of(const io::SoundReport& report) {
    Judges judges;
    for (const classification::RecordingVerdict& verdict : report.verdicts)
        (verdict.passages.empty() ? judges.rules : judges.ear) = true;
    return judges;
}

void say_unused(const SoundOptions& options, Judges judges) {
    using parameters::SoundJudge;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds()) {
        const bool is_used =
            threshold.judge == SoundJudge::both || (threshold.judge == SoundJudge::ear ? judges.ear : judges.rules);
        const bool is_set = std::any_of(options.thresholds.begin(), options.thresholds.end(), [&](const auto& text) {
            return base::trimmed(std::string_view(text).substr(0, text.find('='))) == threshold.name;
        });
        if (is_set && !is_used)
            console::say(fmt::format("stridor: note: {} changes nothing here: {}", threshold.name,
                                     threshold.judge == SoundJudge::ear
                                         ? "the ear asks for it, and motions and forces are judged by rules"
                                         : "the rules ask for it, and what comes through air is judged by the ear"));
    }
}

io::SoundReport listen_to(const SoundOptions& options, std::optional<sound::SoundField> field) {
    Listening listening(options);
    for (const std::string& note : listening.report.notes)
        console::say("stridor: note: " + note);
    listening.hear(progress_of(listening.file->layout()), field);
    return std::move(listening.report);
}

io::SoundReport listen_quietly_to(const SoundOptions& options, const std::function<void(double share)>& progress) {
    Listening listening(options);
    const double whole = static_cast<double>(listening.file->layout().frames.value_or(0));
    listening.hear([&](std::uint64_t frames) {
        progress(whole > 0.0 ? std::min(1.0, static_cast<double>(frames) / whole) : 0.0);
    });
    return std::move(listening.report);
}

}  // namespace stridor::app
