#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/evaluation_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/sound/expectations.hpp"
#include "stridor/io/sound/hearing_report.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/kept_results.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace stridor::app {

namespace {

struct EvaluateOptions {
    std::vector<std::string> files;
    std::vector<std::string> assignments;
    std::string of = "joint";
    std::string planes = "all";
    std::size_t perturb_every = hearing::HearingOptions{}.perturb_every;
    std::string recordings;
    std::string labels;
    std::string csv;
    int threads = 0;
    bool json = false;
};

hearing::HearingOptions hearing_options(const EvaluateOptions& options) {
    hearing::HearingOptions hearing;
    hearing.perturb_every = options.perturb_every;
    hearing.crew = crews(options.threads);
    hearing.settings.motion.of = options.of;
    for (const std::string& assignment : options.assignments)
        if (parameters::is_sound_threshold(assignment))
            parameters::set_sound_threshold(hearing.settings.thresholds, assignment);
    return hearing;
}

// --- what is heard

std::vector<io::HeardChart> charts_of(const EvaluateOptions& options) {
    std::vector<std::string> overrides;
    std::copy_if(options.assignments.begin(), options.assignments.end(), std::back_inserter(overrides),
                 [](const std::string& assignment) { return !parameters::is_sound_threshold(assignment); });
    std::vector<io::HeardChart> charts;
    for (const std::string& file : options.files)
        charts.push_back({file, sweep::PlaneSet::file, io::read_study(load_source(file, overrides)), {}});
    if (!charts.empty() || !options.recordings.empty()) return charts;
    return io::built_in_charts(options.planes, overrides);
}

// each chart is kept until all of them are heard
void hear_charts(std::vector<io::HeardChart>& charts, hearing::HearingOptions options) {
    std::vector<std::unique_ptr<storage::CommandCache>> all_kept;
    for (io::HeardChart& chart : charts) {
        all_kept.push_back(std::make_unique<storage::CommandCache>(
            "evaluate", hearing::heard_text(chart.study, options), console::say));
        options.kept = all_kept.back()->results();
        console::say(fmt::format("{} sounds: {}", sweep::cell_count(chart.study), chart.study.base.title));
        console::ProgressDisplay display;
        options.progress = [&](const sweep::Progress& progress) { display.show(progress); };
        chart.sounds = hearing::hear(chart.study, options);
        display.finish();
        if (chart.sounds.empty()) hearing::throw_stopped(chart.study.base.title);
    }
    for (const std::unique_ptr<storage::CommandCache>& kept : all_kept)
        kept->finish();
}

// they, too, are kept until all of them are heard
std::vector<hearing::HeardRecording> hear_recordings(const std::vector<hearing::Expectation>& expectations,
                                                     const hearing::HearingOptions& options) {
    const parameters::SoundThresholds& thresholds = options.settings.thresholds;
    storage::CommandCache kept("evaluate", hearing::heard_text(expectations, thresholds), console::say);
    console::HeardFilesDisplay display(expectations);
    hearing::RecordingHearing hearing{thresholds, options.stop, kept.results()};
    hearing.begin = [&](const std::string& file) { display.begin(file); };
    hearing.progress = [&](double share) { display.show(share); };
    hearing.end = [&] { display.end(); };
    std::vector<hearing::HeardRecording> heard = hearing::hear(expectations, hearing);
    kept.finish();
    return heard;
}

void evaluate(const EvaluateOptions& options) {
    if (!options.csv.empty() && !options.recordings.empty() && options.files.empty())
        throw Error(ErrorKind::input, {"--csv has nothing to write", "it has a row per simulated sound", ""});
    io::HearingReport report;
    report.options = hearing_options(options);
    report.charts = charts_of(options);
    if (only_helps()) {
        for (const io::HeardChart& chart : report.charts)
            help_with(hearing::work_of(chart.study, report.options), options.threads);
        return;
    }
    std::vector<hearing::Expectation> expectations;
    if (!options.recordings.empty()) expectations = io::read_expectations(options.recordings, options.labels);
    {
        const Interrupt interrupt;
        report.options.stop = interrupt.token();
        if (!report.charts.empty()) report.cases = hearing::hear_table_1(report.options);
        hear_charts(report.charts, report.options);
        if (!expectations.empty()) report.recordings = hear_recordings(expectations, report.options);
    }
    if (!options.csv.empty()) storage::write_file(options.csv, io::hearing_csv(report));
    console::print(options.json ? io::hearing_json(report) + "\n" : console::evaluation_text(report));
}

}  // namespace

void add_evaluate(CLI::App& program) {
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command = program.add_subcommand(
        "evaluate", "How often the verdict by ear says what the contact states say, on thousands of simulated sounds.");
    CLI::Option* files = command->add_option("files", options->files,
                                             "chart files whose every cell is heard (default: built-in planes); - is "
                                             "stdin");
    CLI::Option* planes = command
                              ->add_option("--planes", options->planes,
                                           "built-in planes: Figures 8 and 6 of the paper, the soft parts, or all")
                              ->check(one_of({"paper", "soft", "all"}))
                              ->capture_default_str()
                              ->excludes(files);
    command
        ->add_option("--set", options->assignments,
                     "another threshold by ear (squeal_regularity=0.7) or key of the charts (joint.incidence_angle=50)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command
        ->add_option(
            "--of", options->of,
            "whose velocity is heard: the joint's along (of several contacts the strongest), the plate's across the "
            "contact")
        ->check(one_of({"joint", "plate"}))
        ->capture_default_str();
    command
        ->add_option("--perturb-every", options->perturb_every,
                     "every so many sounds are also judged with noise, gains, rates and bands; 0: none")
        ->check(CLI::Range(0, 1000000))
        ->capture_default_str();
    CLI::Option* recordings =
        command->add_option("--recordings", options->recordings,
                            "recordings instead, with what they are in expected.csv or the table of README.md");
    recordings->type_name("FOLDER")->excludes(planes);
    command->add_option("--labels", options->labels, "another table of what they are: CSV, or a page ending in .md")
        ->type_name("FILE")
        ->needs(recordings);
    add_csv_option(*command, options->csv, "write a row per simulated sound, with the figures of both verdicts");
    add_threads_option(*command, options->threads);
    add_json_option(*command, options->json, "stridor.evaluate/1");
    command->footer(
        "Told are Table 1, confusion tables, even and odd cells apart, and what noise, gains, rates and bands change.\n"
        "Ctrl-C stops and keeps what was heard so far (in $XDG_CACHE_HOME or ~/.cache); the same command goes on.\n"
        "Examples:\n  stridor evaluate\n  stridor evaluate --planes soft\n  stridor evaluate pair.toml --set "
        "joint.incidence_angle=50 --csv sounds.csv\n"
        "  stridor evaluate pair.toml --set creak_rest=0.6 --perturb-every 0\n"
        "  stridor evaluate --recordings clips");
    command->callback([options] { evaluate(*options); });
}

}  // namespace stridor::app
