#include "input_options.hpp"
#include "library.hpp"
#include "library_hearing.hpp"
#include "progress.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/json_library.hpp"
#include "stridor/io/json_verdict.hpp"
#include "stridor/noise_library/recording.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <system_error>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::Library;

constexpr std::size_t many = 20;              // recordings whose number alone is worth a progress line
constexpr std::uintmax_t large = 60'000'000;  // [bytes] some minutes of sound

/// How far a row of recordings is: the whole ones, and the share of the one that is heard.
class RowDisplay {
public:
    RowDisplay(std::string what, std::size_t total) : display_(std::move(what)), total_(total) {}

    void begin(const std::filesystem::path& file) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        is_shown_ = total_ >= many || (!error && size >= large);
        file_ = file.filename().string();
    }
    void show(double share) {
        if (!is_shown_) return;
        const double whole = (static_cast<double>(done_) + share) / static_cast<double>(total_);
        display_.show(whole, total_ > 1 ? fmt::format("{} of {}: {}", done_ + 1, total_, file_) : "");
    }
    void end() {
        show(1.0);
        ++done_;
        display_.clear();
    }

private:
    ShareDisplay display_;
    std::size_t total_;
    std::size_t done_ = 0;
    std::string file_;
    bool is_shown_ = false;
};

void add_hearing_options(CLI::App& command, HearingOptions& options) {
    command
        .add_option("--channel", options.channel,
                    "the sound among several channels: name or number (default: by unit, the loudest)")
        ->type_name("NAME|NUMBER");
    add_full_scale_option(command, options.full_scales);
}

// "   1  squeal.wav  3.2 s, 48000 Hz, 1 channel: squeal"
std::string judged_line(const Entry& entry) {
    std::string line = entry_line(entry);
    if (!entry.category.empty()) line.insert(line.size() - 1, ": " + entry.category);
    return line;
}

struct AddOptions {
    LibraryOption library;
    std::vector<std::string> files;
    EntryOptions entry;
    HearingOptions hearing;
    bool without_verdict = false;
    bool again = false;
    bool json = false;
};

void add(const AddOptions& options) {
    noise_library::Recording recording;
    apply(options.entry, recording.given);
    recording.twins = options.again ? noise_library::Twins::accept : noise_library::Twins::refuse_same_audio;
    HearingOptions hearing = options.hearing;
    if (options.without_verdict) hearing.judging = Judging::none;
    Library library = open_library(options.library, Access::fill);
    RowDisplay row("added", options.files.size());
    const noise_library::Probe probe = probe_of(hearing, [&](double share) { row.show(share); });
    std::vector<Entry> entries;
    for (const std::string& file : options.files) {
        recording.file = file;
        row.begin(file);
        const Entry entry = noise_library::add_recording(library, recording, probe);
        row.end();
        // what is in is said at once, whatever becomes of the next
        if (options.json)
            entries.push_back(entry);
        else
            print(judged_line(entry));
    }
    if (options.json) print(io::library_json(library.file(), entries) + "\n");
}

struct JudgeOptions {
    LibraryOption library;
    std::vector<std::int64_t> ids;
    SelectionOptions selection;
    HearingOptions hearing;
    bool all = false;
    bool json = false;
};

bool is_outdated(const Entry& entry) {
    const std::optional<io::KeptVerdict> kept = io::kept_verdict(entry.verdict);
    return !kept || !kept->is_current;
}

// those named, else those that meet the conditions and have no verdict of this program
std::vector<std::int64_t> ids_to_judge(Library& library, const JudgeOptions& options) {
    if (!options.ids.empty()) {
        static_cast<void>(library.get(options.ids));  // all of them are there
        return options.ids;
    }
    noise_library::Query query = query_of(options.selection);
    query.extent = noise_library::Extent::whole;
    std::vector<std::int64_t> ids;
    library.visit(query, [&](const Entry& entry) {
        if (options.all || is_outdated(entry)) ids.push_back(entry.id);
    });
    return ids;
}

// heard before the library is locked: others may write meanwhile
Entry heard_again(Library& library, std::int64_t id, const HearingOptions& options, const Heard& heard) {
    const std::array<std::int64_t, 1> only{id};
    Entry entry = library.get(only).front();
    HearingOptions hearing = options;
    if (const std::optional<io::KeptVerdict> kept = io::kept_verdict(entry.verdict);
        hearing.channel.empty() && kept && kept->channel > 0)
        hearing.channel = std::to_string(kept->channel);
    judge(io::open_input(library.sound_file(entry).string()), hearing, entry, heard);
    const auto put = [&](Entry& each) {
        each.category = entry.category;
        each.verdict = entry.verdict;
        each.figures = entry.figures;
        each.duration = entry.duration;
    };
    return library.edit(only, put).front();
}

void judge_again(const JudgeOptions& options) {
    Library library = open_library(options.library, Access::read);
    const std::vector<std::int64_t> ids = ids_to_judge(library, options);
    if (ids.empty() && !options.json) return say("nothing to judge: all verdicts are of this version");
    RowDisplay row("judged", ids.size());
    std::vector<Entry> entries;
    for (const std::int64_t id : ids) {
        const std::array<std::int64_t, 1> only{id};
        const Entry before = library.get(only).front();
        row.begin(library.audio_file(before));
        const Entry entry = heard_again(library, id, options.hearing, [&](double share) { row.show(share); });
        row.end();
        if (options.json)
            entries.push_back(entry);
        else
            print(fmt::format("{:>4}  {}  {}\n", entry.id, entry.file,
                              before.category == entry.category || before.category.empty()
                                  ? entry.category
                                  : before.category + " -> " + entry.category));
    }
    if (options.json) print(io::library_json(library.file(), entries) + "\n");
}

}  // namespace

void add_library_add(CLI::App& library) {
    auto options = std::make_shared<AddOptions>();
    CLI::App* command =
        library.add_subcommand("add", "Add recordings, with what is known of them, and listen to them.");
    command->add_option("files", options->files, "recordings of any format; what is said of them holds for all")
        ->required();
    add_library_option(*command, options->library);
    add_entry_options(*command, options->entry);
    add_hearing_options(*command, options->hearing);
    command->add_flag("--no-verdict", options->without_verdict, "do not listen: no category, no figures of the sound");
    command->add_flag("--again", options->again, "add a sound even if an entry has it already");
    command->add_flag("--json", options->json, "print the new entries as one JSON document (schema stridor.library/1)");
    command->footer(
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
    add_hearing_options(*command, options->hearing);
    command->add_flag("--all", options->all, "all that meet the conditions, whatever their verdict");
    command->add_flag("--json", options->json, "print the entries as one JSON document (schema stridor.library/1)");
    command->footer(
        "Figures that you changed stay as they are.\n"
        "Examples:\n  stridor library judge\n  stridor library judge 12 --channel 2\n"
        "  stridor library judge --all --where \"recorded = rig\"");
    command->callback([options] { judge_again(*options); });
}

}  // namespace stridor::app
