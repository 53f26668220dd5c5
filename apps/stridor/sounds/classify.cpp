#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/sound_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/sound/classified_recordings.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <stop_token>
#include <string>
#include <system_error>
#include <vector>

namespace stridor::app {

namespace {

using io::ClassifiedRecording;

struct ClassifyOptions {
    std::vector<std::string> files;
    SoundOptions input;
    std::string csv;
    bool json = false;
};

bool is_for_one(const ClassifyOptions& options) {
    std::error_code ignored;
    return options.files.size() == 1 && options.csv.empty() &&
           !std::filesystem::is_directory(options.files.front(), ignored);
}

void classify_one(const ClassifyOptions& options) {
    SoundOptions input = options.input;
    input.file = options.files.front();
    const io::SoundReport report = listen_to(input);
    say_unused(input, judges_of(report));
    console::print(options.json ? io::classify_json(report) + "\n" : console::verdict_text(report));
}

// a recording that is damaged is a row, too; the judges of one that was heard are added
ClassifiedRecording row_of(const SoundOptions& input, const std::function<void(double share)>& progress,
                           Judges& judges) {
    try {
        const io::SoundReport report = listen_quietly_to(input, progress);
        const Judges here = judges_of(report);
        judges = {judges.ear || here.ear, judges.rules || here.rules};
        return io::classified(input.file, report);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::interrupted) throw;
        return {input.file, recordings::refusal_reason(input.file, error)};
    }
}

std::vector<ClassifiedRecording> rows_of(const recordings::RecordingFiles& found, const ClassifyOptions& options,
                                         const std::stop_token& stop) {
    console::RowDisplay display("listened to", found.files.size());
    std::vector<ClassifiedRecording> rows;
    const auto progress = [&](double share) {
        if (stop.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {fmt::format("stopped after {} of {} recordings", rows.size(), found.files.size()),
                         "nothing is kept of them", ""});
        display.show(share);
    };
    for (const recordings::RefusedRecording& refused : found.unreadable)
        rows.push_back({refused.file, refused.reason});
    SoundOptions input = options.input;
    Judges judges;
    for (const std::filesystem::path& file : found.files) {
        input.file = file.string();
        display.begin(file);
        rows.push_back(row_of(input, progress, judges));
        display.end();
    }
    display.clear();
    if (judges.ear || judges.rules) say_unused(options.input, judges);
    return rows;
}

void classify_many(const ClassifyOptions& options) {
    // a slip of the pen is told at once, and not once per recording
    const parameters::SoundThresholds thresholds = thresholds_of(options.input);
    static_cast<void>(open_options(options.input.recording));
    const recordings::RecordingFiles found = recordings::recording_files(options.files, {});
    if (found.files.empty() && found.unreadable.empty())
        throw Error(ErrorKind::input, {"there is no recording in " + options.files.front(),
                                       "no file there is one by its name", "Name the files themselves?"});
    const Interrupt interrupt;
    const std::vector<ClassifiedRecording> rows = rows_of(found, options, interrupt.token());
    if (!options.csv.empty()) storage::write_file(options.csv, io::classified_csv(rows, thresholds));
    console::print(options.json ? io::classified_json(rows, thresholds) + "\n" : console::classified_text(rows));
    const auto refused = static_cast<std::size_t>(
        std::count_if(rows.begin(), rows.end(), [](const ClassifiedRecording& row) { return !row.refusal.empty(); }));
    if (refused > 0)
        throw Error(ErrorKind::input, {fmt::format("{} of {} recordings could not be heard", refused, rows.size()),
                                       "their rows say why", "The other rows hold."});
}

using parameters::SoundJudge;

// the thresholds of these judges, a line each
std::string threshold_lines(std::initializer_list<SoundJudge> judges) {
    std::string lines;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        if (std::find(judges.begin(), judges.end(), threshold.judge) != judges.end())
            lines += fmt::format("\n  {:<20} {:>6g} {:<5} {}", threshold.name,
                                 parameters::SoundThresholds{}.*(threshold.member),
                                 threshold.unit == "1" ? "" : threshold.unit, threshold.sentence);
    return lines;
}

}  // namespace

void add_classify(CLI::App& program) {
    auto options = std::make_shared<ClassifyOptions>();
    CLI::App* command = program.add_subcommand(
        "classify",
        "Hear whether a recording squeals, squeaks, creaks or is quiet, part by part and as a whole; of "
        "several recordings a table with a row each.");
    command
        ->add_option("files", options->files,
                     "WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT file, - for standard input; of several, and "
                     "of folders, a row per recording")
        ->required();
    add_listening_options(*command, options->input);
    add_csv_option(*command, options->csv, "write a row per recording");
    add_json_option(*command, options->json, "stridor.classify/1, of several stridor.classified/1");
    command->footer(
        "Of a folder those files are taken, at any depth, whose names end as recordings do. A recording that cannot be "
        "heard is a row that says why; the exit code is then 2.\n"
        "Examples:\n  stridor classify squeak.wav\n  stridor classify rig.uff --channel 2 --json\n"
        "  stridor classify door.flac --set certainty=0.6\n"
        "  stridor classify monday tuesday/late-*.wav --csv verdicts.csv\n\n"
        "Thresholds for --set. The ear judges what is heard through air (channels in Pa, and without calibration) by:" +
        threshold_lines({SoundJudge::ear, SoundJudge::both}) +
        "\n\nThe rules judge motions and forces by:" + threshold_lines({SoundJudge::rules, SoundJudge::both}));
    command->callback([options] { is_for_one(*options) ? classify_one(*options) : classify_many(*options); });
}

}  // namespace stridor::app
