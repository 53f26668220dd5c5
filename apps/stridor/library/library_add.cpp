#include "arguments.hpp"
#include "interrupt.hpp"
#include "library/library.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/library/library_texts.hpp"
#include "stridor/io/library/recording_probe.hpp"
#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/starter_noises.hpp"
#include "stridor/recordings/recording_files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <exception>
#include <memory>
#include <optional>
#include <stop_token>
#include <system_error>
#include <utility>
#include <vector>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::Library;

using io::JudgingOptions;

JudgingOptions judging_options(JudgingOptions options) {
    options.note = console::say_note;
    return options;
}

void add_judging_options(CLI::App& command, JudgingOptions& options) {
    command
        .add_option("--channel", options.channel,
                    "the sound among several channels: name or number (default: by unit, the loudest)")
        ->type_name("NAME|NUMBER");
    add_full_scale_option(command, options.full_scales);
}

struct AddOptions {
    LibraryOption library;
    std::vector<std::string> files;
    EntryOptions entry;
    JudgingOptions judging;
    bool without_verdict = false;
    bool again = false;
    bool json = false;
};

/// Adds recordings, shows how far it is, and tells what became of them.
void add(const AddOptions& options) {
    const Interrupt interrupt;
    Library library = noise_library::open_library(options.library.file, Access::fill, waiting(interrupt.token()));
    const recordings::RecordingFiles files = recordings::recording_files(options.files, library.audio_folder());
    console::RowDisplay row("added", files.files.size());
    std::vector<Entry> entries;  // for JSON alone
    const bool is_alone =
        options.files.size() == 1 && files.files == std::vector<std::filesystem::path>{options.files[0]};
    noise_library::Adding adding;
    apply(options.entry, adding.given);
    adding.known = options.again ? noise_library::Known::added_again : noise_library::Known::skipped;
    adding.refused = is_alone ? noise_library::Refused::thrown : noise_library::Refused::listed;
    adding.stop = interrupt.token();
    JudgingOptions judging = judging_options(options.judging);
    if (options.without_verdict) judging.judging = io::Judging::none;
    adding.probe = io::probe_of(judging, [&](double share) {
        noise_library::go_on(adding.stop, files.files.size() - row.done());
        row.show(share);
    });
    adding.begin = [&](const std::filesystem::path& file) { row.begin(file); };
    adding.end = [&] { row.end(); };
    adding.added = [&](const Entry& entry) {
        // what is in is said at once, whatever becomes of the next
        if (options.json)
            entries.push_back(entry);
        else
            console::print(console::judged_line(entry));
    };
    const noise_library::Added added = noise_library::add_recordings(library, files, adding);
    row.clear();
    if (options.json) console::print(io::arrivals_json(library.file(), entries, added.arrivals) + "\n");
    // a single file that was added, or not, says so itself
    if (!is_alone || !added.arrivals.known.empty()) console::say(console::summary_text(added.arrivals));
    if (added.ended_by) std::rethrow_exception(added.ended_by);
}

struct JudgeOptions {
    LibraryOption library;
    std::vector<std::int64_t> ids;
    SelectionOptions selection;
    JudgingOptions judging;
    bool all = false;
    bool json = false;
};

// those named, else those that meet the conditions and have no verdict of this program
std::vector<std::int64_t> ids_to_judge(Library& library, const JudgeOptions& options) {
    if (options.ids.empty())
        return io::ids_to_judge(library, query_of(options.selection),
                                options.all ? io::Rejudged::all : io::Rejudged::outdated);
    static_cast<void>(library.get(options.ids));  // all of them are there
    return options.ids;
}

void judge_again(const JudgeOptions& options) {
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
    const std::vector<std::int64_t> ids = ids_to_judge(library, options);
    if (ids.empty() && !options.json) return console::say("nothing to judge: all verdicts are of this version");
    console::RowDisplay row("judged", ids.size());
    std::vector<Entry> entries;
    for (const std::int64_t id : ids) {
        const std::array<std::int64_t, 1> only{id};
        const Entry before = library.get(only).front();
        row.begin(library.audio_file(before));
        const Entry entry =
            io::judge_again(library, id, judging_options(options.judging), [&](double share) { row.show(share); });
        row.end();
        if (options.json)
            entries.push_back(entry);
        else
            console::print(fmt::format("{:>4}  {}  {}\n", entry.id, entry.file,
                                       before.category == entry.category || before.category.empty()
                                           ? entry.category
                                           : before.category + " -> " + entry.category));
    }
    if (options.json) console::print(io::library_json(library.file(), entries) + "\n");
}

struct StarterOptions {
    LibraryOption library;
    bool json = false;
};

void fill(const StarterOptions& options) {
    const Interrupt interrupt;
    noise_library::Library library =
        noise_library::open_library(options.library.file, noise_library::Access::fill, waiting(interrupt.token()));
    console::ShareDisplay display("made");
    std::vector<Entry> entries;  // for JSON alone
    noise_library::StarterAdding adding;
    adding.probe = io::probe_of({io::Judging::by_ear, {}, {}, console::say_note}, {});
    adding.case_text = [](const parameters::Case& c) { return io::case_toml(c, {io::Comments::none, ""}); };
    adding.stop = interrupt.token();
    adding.progress = [&](double share, const std::string& name) { display.show(share, name); };
    adding.added = [&](const Entry& entry) {
        display.clear();
        if (options.json)
            entries.push_back(entry);
        else
            console::print(console::judged_line(entry));
    };
    const noise_library::Added added = noise_library::add_starter(library, adding);
    display.clear();
    if (options.json) console::print(io::arrivals_json(library.file(), entries, added.arrivals) + "\n");
    console::say(console::summary_text(added.arrivals));
    if (added.ended_by) std::rethrow_exception(added.ended_by);
}

}  // namespace

void add_library_add(CLI::App& library) {
    auto options = std::make_shared<AddOptions>();
    CLI::App* command =
        library.add_subcommand("add", "Add recordings, with what is known of them, and listen to them.");
    command
        ->add_option("files", options->files,
                     "recordings of any format, and folders of them; what is said of them holds for all")
        ->required();
    add_library_option(*command, options->library);
    add_entry_options(*command, options->entry);
    add_judging_options(*command, options->judging);
    command->add_flag("--no-verdict", options->without_verdict, "do not listen: no category, no figures of the sound");
    command->add_flag("--again", options->again, "add a sound even if an entry has it already");
    add_json_option(*command, options->json, "stridor.library/1",
                    "print the new entries and a summary as one JSON document");
    command->footer(
        "What is known already is skipped, what is broken refused, and the others added; exit code 2 if any was "
        "refused, 4 after an interrupt: the same command goes on. Of a folder those files are taken, at any depth, "
        "whose names end as recordings do.\n"
        "What the file says of itself (lines \"# preload: 20 N\", the sidecar, a simulation's case) counts where no "
        "option says it.\n"
        "Examples:\n  stridor library add squeal.wav --system brake --recorded vehicle --full-scale \"2 Pa\"\n"
        "  stridor library add run-*.csv --recorded rig --system seal --temperature \"23 degC\"");
    command->callback([options] { add(*options); });
}

void add_library_judge(CLI::App& library) {
    auto options = std::make_shared<JudgeOptions>();
    CLI::App* command = library.add_subcommand(
        "judge", "Listen again: to entries without a verdict or with one of another version, or to those named.");
    command->add_option("ids", options->ids, "these entries, whatever their verdict");
    add_library_option(*command, options->library);
    add_selection_options(*command, options->selection);
    add_judging_options(*command, options->judging);
    command->add_flag("--all", options->all, "all that meet the conditions, whatever their verdict");
    add_json_option(*command, options->json, "stridor.library/1", "print the entries as one JSON document");
    command->footer(
        "Figures that you changed stay as they are.\n"
        "Examples:\n  stridor library judge\n  stridor library judge 12 --channel 2\n"
        "  stridor library judge --all --where \"recorded = rig\"");
    command->callback([options] { judge_again(*options); });
}

void add_library_starter(CLI::App& library) {
    auto options = std::make_shared<StarterOptions>();
    CLI::App* command = library.add_subcommand(
        "starter", "Fill a library with simulated noises of many systems, to try it before there are recordings.");
    add_library_option(*command, options->library);
    command->add_option("library", options->library.file, "the same as --library FILE")
        ->type_name("LIBRARY")
        ->excludes("--library");
    add_json_option(*command, options->json, "stridor.library/1",
                    "print the new entries and a summary as one JSON document");
    command->footer(
        "The noises are simulated on the spot, the same on every machine. What the library has already is not added "
        "again.\n"
        "Examples:\n  stridor library starter try.sqlite\n"
        "  stridor rig sensitivity --library try.sqlite --where \"system = seal\" --over preload");
    command->callback([options] { fill(*options); });
}

}  // namespace stridor::app
