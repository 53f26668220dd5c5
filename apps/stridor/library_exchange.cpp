#include "library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/io/json_library.hpp"
#include "stridor/io/library_archive.hpp"
#include "stridor/noise_library/recording.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <array>
#include <memory>

namespace stridor::app {

namespace {

using noise_library::Access;
using noise_library::Entry;
using noise_library::Library;

struct AddOptions {
    LibraryOption library;
    std::vector<std::string> files;
    EntryOptions entry;
    bool again = false;
    bool json = false;
};

void add(const AddOptions& options) {
    noise_library::Recording recording;
    apply(options.entry, recording.given);
    recording.twins = options.again ? noise_library::Twins::accept : noise_library::Twins::refuse_same_audio;
    Library library = open_library(options.library, Access::fill);
    std::vector<Entry> entries;
    for (const std::string& file : options.files) {
        recording.file = file;
        entries.push_back(noise_library::add_recording(library, recording, probe_sound));
        // what is in is said at once, whatever becomes of the next
        if (!options.json) print(entry_line(entries.back()));
    }
    if (options.json) print(io::library_json(library.file(), entries) + "\n");
}

struct ExportOptions {
    LibraryOption library;
    std::string archive;
    std::vector<std::int64_t> ids;
    SelectionOptions selection;
};

std::string count_text(std::size_t count) {
    return fmt::format("{} {}", count, count == 1 ? "entry" : "entries");
}

void export_entries(const ExportOptions& options) {
    Library library = open_library(options.library, Access::read);
    std::vector<Entry> entries;
    if (options.ids.empty()) {
        noise_library::Query query = query_of(options.selection);
        query.extent = noise_library::Extent::whole;
        entries = library.find(query);
    } else {
        entries = library.get(options.ids);
    }
    if (entries.empty())
        throw Error(ErrorKind::input, {"there is nothing to export", "no entry meets the conditions", ""});
    io::export_library(library, entries, options.archive);
    say(fmt::format("wrote {} to {}", count_text(entries.size()), options.archive));
}

struct ImportOptions {
    LibraryOption library;
    std::string archive;
};

void import_entries(const ImportOptions& options) {
    Library library = open_library(options.library, Access::fill);
    const io::Import result = io::import_library(library, options.archive);
    const std::string ids = result.added.empty() ? ""
                            : result.added.size() == 1
                                ? fmt::format(", id {}", result.added.front())
                                : fmt::format(", ids {} to {}", result.added.front(), result.added.back());
    print(fmt::format("{} added{}; {} there already\n", count_text(result.added.size()), ids, result.skipped));
}

}  // namespace

void add_library_add(CLI::App& library) {
    auto options = std::make_shared<AddOptions>();
    CLI::App* command = library.add_subcommand("add", "Add recordings, with what is known of them.");
    command->add_option("files", options->files, "sound files; what is said of them holds for all")->required();
    add_library_option(*command, options->library);
    add_entry_options(*command, options->entry);
    command->add_flag("--again", options->again, "add a sound even if an entry has it already");
    command->add_flag("--json", options->json, "print the new entries as one JSON document (schema stridor.library/1)");
    command->footer(
        "Example:\n  stridor library add squeal.wav --system brake --recorded rig --preload \"40 N\" --velocity \"4 "
        "mm/s\" "
        "--temperature \"23 degC\"");
    command->callback([options] { add(*options); });
}

void add_library_export(CLI::App& library) {
    auto options = std::make_shared<ExportOptions>();
    CLI::App* command =
        library.add_subcommand("export", "Write entries with their audio into one archive, for a colleague.");
    command->add_option("archive", options->archive, "file to write (tar)")->required();
    command->add_option("ids", options->ids, "these entries alone");
    add_library_option(*command, options->library);
    add_selection_options(*command, options->selection);
    command->footer("Example:\n  stridor library export brakes.tar --where \"system = brake\"");
    command->callback([options] { export_entries(*options); });
}

void add_library_import(CLI::App& library) {
    auto options = std::make_shared<ImportOptions>();
    CLI::App* command = library.add_subcommand("import", "Add the entries of an archive: all of them, or none.");
    command->add_option("archive", options->archive, "file that `stridor library export` wrote")->required();
    add_library_option(*command, options->library);
    command->footer("Example:\n  stridor library import brakes.tar");
    command->callback([options] { import_entries(*options); });
}

}  // namespace stridor::app
