#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "interrupt.hpp"
#include "sounds/compare.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/comparison_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/hearing/sound_search.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/sound/json_compare.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/side_by_side.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/kept_results.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>

namespace stridor::app {

namespace {

using classification::ComparedSound;
using hearing::SoundMatch;

constexpr std::size_t drawn = 3;  // [1] matches beside the recording in the figure

struct MatchOptions {
    std::string recording;
    CaseOptions chart;
    LibraryOption library;
    MotionOptions motion;
    std::string store;
    std::string out;
    std::size_t best = 5;
    int threads = 0;
    bool every = false;
    bool with_level = false;
    bool json = false;
};

hearing::SoundSearchResult searched(const MatchOptions& options, const io::MatchReport& report,
                                    const hearing::CellListening& listening) {
    hearing::SoundSearch settings;
    settings.extent = report.extent;
    settings.keep = options.best;
    settings.level = report.level;
    settings.crew = crews(options.threads);
    if (!options.store.empty())
        settings.ruled_out = hearing::ruled_out(report.study, options.store, report.recording.heard.category);
    const Interrupt interrupt;
    console::SearchDisplay display;
    settings.stop = interrupt.token();
    settings.progress = [&](const hearing::SearchProgress& progress) { display.show(progress); };
    storage::CommandCache kept("match", hearing::listening_text(report.study, listening), console::say);
    settings.kept = kept.results();
    hearing::SoundSearchResult result = hearing::search(report.study, report.recording.profile, listening, settings);
    if (result.is_stopped)
        throw Error(ErrorKind::interrupted,
                    {fmt::format("stopped after {} cells", result.heard),
                     settings.kept != nullptr ? "what was heard is kept" : "nothing could be kept",
                     "Run the same command again to go on."});
    kept.finish();
    if (result.best.empty())
        throw Error(ErrorKind::numerical, {"no cell of the chart has a sound", "all failed or were ruled out",
                                           "`stridor chart` says why cells fail."});
    return result;
}

// --- what is left in the folder

void write_folder(const MatchOptions& options, const io::MatchReport& report) {
    const std::filesystem::path folder(options.out);
    storage::make_folder(folder, "Choose another --out.");
    storage::write_file((folder / "match.json").string(), io::match_json(report) + "\n");
    std::vector<ComparedSound> sounds{report.recording};
    const Interrupt interrupt;
    for (std::size_t k = 0; k < report.result.best.size(); ++k) {
        const SoundMatch& match = report.result.best[k];
        const hearing::SimulatedSound cell = hearing::simulated_of(report.study, match);
        io::write_simulated_wav((folder / fmt::format("match-{}.wav", k + 1)).string(), cell, report.rate,
                                asked_motion(options.motion), interrupt.token());
        if (k >= drawn) continue;
        const std::string name = console::match_name(report.study, match);
        sounds.push_back(load_sound({name, fmt::format("match {}", k + 1), "simulation at " + name, cell},
                                    {asked_motion(options.motion), report.rate}));
    }
    pictures::draw_both(pictures::side_by_side(sounds), folder / "match");
}

void match(const MatchOptions& options) {
    io::MatchReport report;
    report.chart = options.chart.file;
    report.study = io::read_study(load_source(options.chart.file, options.chart.overrides));
    const hearing::AskedMotion asked = asked_motion(options.motion);
    const hearing::NamedSound named = io::named_recording(options.recording, lookup_in(options.library));
    report.recording = load_sound(named, {{}, std::get<hearing::RecordedSound>(named.source).rate});
    hearing::require_matchable(report.recording);
    if (options.with_level) hearing::require_comparable_level(report.recording, asked.quantity);
    report.motion = hearing::motion_words(report.study.base, asked);
    report.rate = hearing::matching_rate(report.recording);
    report.level = options.with_level ? classification::LevelUse::counted : classification::LevelUse::ignored;
    report.extent = options.every ? hearing::SearchExtent::every : hearing::SearchExtent::search;
    hearing::CellListening listening;
    listening.motion = asked;
    listening.sound.rate = report.rate;
    hearing::check_audible(report.study.base, listening.sound);
    report.result = searched(options, report, listening);
    if (!options.out.empty()) write_folder(options, report);
    console::print(options.json ? io::match_json(report) + "\n" : console::match_text(report));
    if (!options.out.empty() && !options.json)
        console::print(fmt::format("\n{0}/match.png {0}/match.svg {0}/match.json {0}/match-1.wav ...\n", options.out));
    if (!options.json && console::has_terminal()) {
        const sweep::CellPlace place = sweep::place_of(report.study, report.result.best.front().cell.index);
        console::say(console::styled("next: " + sweep::reproduce_command(report.study, place, report.chart),
                                     console::Style::dim, 2));
    }
}

}  // namespace

void add_match(CLI::App& program) {
    auto options = std::make_shared<MatchOptions>();
    CLI::App* command = program.add_subcommand("match", "Which cells of a chart sound most like this recording?");
    command->add_option("recording", options->recording, "FILE, FILE:channel=N or library:ID")->required();
    command->add_option("--chart", options->chart.file, "the chart file")->type_name("FILE")->required();
    command->add_option("--set", options->chart.overrides, "another value for a key of the chart file (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command->add_option("--best", options->best, "how many cells are told")
        ->check(CLI::Range(1, 100))
        ->capture_default_str();
    command->add_flag("--every", options->every,
                      "listen to every cell; otherwise a chart of more than 400 is searched from a coarse grid on");
    command
        ->add_option("--store", options->store,
                     "chart.sqlite of this chart: cells it knows to be quiet or failed are left out")
        ->type_name("FILE");
    add_output_folder(*command, options->out,
                      "folder for the best cells as WAV, the first three beside the recording as a figure, and JSON");
    command->add_flag("--with-level", options->with_level,
                      "count the level, too; only for a recorded velocity or acceleration");
    add_threads_option(*command, options->threads);
    add_library_option(*command, options->library);
    add_motion_options(*command, options->motion);
    add_json_option(*command, options->json, "stridor.match/1");
    command->footer(
        "Ctrl-C stops and keeps what was heard (in $XDG_CACHE_HOME or ~/.cache); the same command goes on.\n"
        "Examples:\n  stridor match squeal.wav --chart pair.toml\n"
        "  stridor match library:3 --chart pair.toml --store pair/chart.sqlite --best 3 --out matches");
    command->callback([options] { match(*options); });
}

}  // namespace stridor::app
