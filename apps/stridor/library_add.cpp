#include "input_options.hpp"
#include "interrupt.hpp"
#include "library.hpp"
#include "library_hearing.hpp"
#include "progress.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/io/sound/json_verdict.hpp"
#include "stridor/noise_library/recording.hpp"
#include "stridor/recordings/recording_files.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>
#include <stop_token>
#include <system_error>
#include <utility>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::Library;

/// How far a row of recordings is: the whole ones, and the share of the one that is heard.
class RowDisplay {
public:
    RowDisplay(std::string what, std::size_t total) : display_(std::move(what)), total_(total) {}

    void begin(const std::filesystem::path& file) {
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        is_shown_ = takes_long(total_, error ? 0 : size);
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
        clear();
    }
    void clear() { display_.clear(); }

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

struct AddOptions {
    LibraryOption library;
    std::vector<std::string> files;
    EntryOptions entry;
    HearingOptions hearing;
    bool without_verdict = false;
    bool again = false;
    bool json = false;
};

/// An error of a file, which is refused; those of the library end the command.
struct Refusal {
    Error error;
};

// "run.csv:12: the file is empty"
std::string reason_of(const std::string& file, const Error& error) {
    const base::Problem& problem = error.problem();
    const std::string place = error.place() ? base::describe(*error.place()) : file;
    const std::string why = problem.why.empty() ? "" : " (" + problem.why + ")";
    return (problem.what.find(file) == std::string::npos ? place + ": " : "") + problem.what + why;
}

/// Adds one file after the other, past what is known and what is broken.
class Adder {
public:
    Adder(const AddOptions& options, std::stop_token stop)
        : options_(options),
          stop_(std::move(stop)),
          library_(open_library(options.library, Access::fill)),
          files_(recordings::recording_files(options.files, library_.audio_folder())),
          row_("added", files_.files.size()) {
        apply(options.entry, recording_.given);
        recording_.twins = options.again ? noise_library::Twins::accept : noise_library::Twins::refuse_same_audio;
        HearingOptions hearing = options.hearing;
        if (options.without_verdict) hearing.judging = Judging::none;
        hear_ = probe_of(hearing, [this](double share) {
            go_on();
            row_.show(share);
        });
        arrivals_.passed_over = files_.passed_over;
        arrivals_.refused = files_.unreadable;
        arrivals_.left = files_.files.size();
        is_alone_ = options.files.size() == 1 && files_.files == std::vector<std::filesystem::path>{options.files[0]};
    }

    void run() {
        for (const std::filesystem::path& file : files_.files) {
            go_on();
            row_.begin(file);
            try {
                take(file);
            } catch (const Refusal& refusal) {
                if (is_alone_) throw Error(refusal.error);
                arrivals_.refused.push_back({file.string(), reason_of(file.string(), refusal.error)});
            }
            row_.end();
            --arrivals_.left;
        }
        // of those named, not of folders: what stays behind there is said, too
        if (!arrivals_.refused.empty())
            throw Error(
                ErrorKind::input,
                {fmt::format("refused {} of {}", arrivals_.refused.size(),
                             counted(files_.files.size() + files_.unreadable.size(), "recording", "recordings")),
                 "", "What could be added is in; the same command again tries these alone."});
    }

    /// Says what became of all, on stdout as JSON, else on stderr. A single file that was added, or not, says so
    /// itself.
    void tell() {
        row_.clear();
        if (options_.json) print(io::arrivals_json(library_.file(), entries_, arrivals_) + "\n");
        if (!is_alone_ || !arrivals_.known.empty()) say(summary_text(arrivals_));
    }

private:
    void go_on() const {
        if (stop_.stop_requested())
            throw Error(ErrorKind::interrupted,
                        {fmt::format("stopped before {}", counted(arrivals_.left, "file", "files")),
                         "what was added stays", "The same command again goes on."});
    }

    // what goes wrong in there is the file's fault
    template <typename Work>
    static auto with(const Work& work) {
        try {
            return work();
        } catch (const Error& error) {
            if (error.kind() == ErrorKind::interrupted) throw;
            throw Refusal{error};
        }
    }

    void take(const std::filesystem::path& file) {
        if (!options_.again) {
            const std::string hash = with([&] { return noise_library::audio_hash(file); });
            const std::optional<std::int64_t> twin = library_.entry_with(hash);
            if (twin) return arrivals_.known.push_back({file.string(), *twin});
        }
        recording_.file = file;
        try {
            const Entry entry = noise_library::add_recording(
                library_, recording_, [&](const auto& path, Entry& each) { with([&] { hear_(path, each); }); });
            arrivals_.added.push_back(entry.id);
            // what is in is said at once, whatever becomes of the next
            if (options_.json)
                entries_.push_back(entry);
            else
                print(judged_line(entry));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            throw Refusal{error};  // it changed meanwhile, or another process was quicker
        }
    }

    const AddOptions& options_;
    std::stop_token stop_;
    Library library_;
    recordings::RecordingFiles files_;
    RowDisplay row_;
    noise_library::Recording recording_{};
    noise_library::Probe hear_{};
    noise_library::Arrivals arrivals_{};
    std::vector<Entry> entries_{};  // for JSON alone
    bool is_alone_ = false;         // a single file was named
};

void add(const AddOptions& options) {
    const Interrupt interrupt;
    Adder adder(options, interrupt.token());
    run_and_tell(adder);
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
    query.extent = noise_library::EntryExtent::whole;
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
    judge(recordings::open_input(library.sound_file(entry).string()), hearing, entry, heard);
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
    command
        ->add_option("files", options->files,
                     "recordings of any format, and folders of them; what is said of them holds for all")
        ->required();
    add_library_option(*command, options->library);
    add_entry_options(*command, options->entry);
    add_hearing_options(*command, options->hearing);
    command->add_flag("--no-verdict", options->without_verdict, "do not listen: no category, no figures of the sound");
    command->add_flag("--again", options->again, "add a sound even if an entry has it already");
    command->add_flag("--json", options->json,
                      "print the new entries and a summary as one JSON document (schema stridor.library/1)");
    command->footer(
        "What is known already is skipped, what is broken refused, and the others added; exit code 2 if any was "
        "refused. Of a "
        "folder those files are taken, at any depth, whose names end as recordings do.\n"
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
