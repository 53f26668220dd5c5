#include "interrupt.hpp"
#include "library/library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/library/library_archive.hpp"
#include "stridor/io/library/library_repair.hpp"
#include "stridor/io/library/recording_probe.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace stridor::app {

namespace {

using noise_library::Findings;

struct CheckOptions {
    LibraryOption library;
    bool repair = false;
    std::vector<std::string> archives;
};

// says what is there; throws what is not
void tell(const Findings& findings, const std::filesystem::path& file) {
    const std::vector<std::string> lines = console::finding_lines(findings);
    std::string text;
    for (const std::string& line : lines)
        text += line + "\n";
    text += fmt::format("{}, {}: {}\n", console::counted(findings.saved.entries.size(), "entry", "entries"),
                        console::counted(findings.sounds, "sound", "sounds"),
                        lines.empty() ? "nothing is damaged" : "whole but for what is named above");
    console::print(text);
    if (!lines.empty())
        throw Error(ErrorKind::io, {"the library " + file.string() + " is damaged",
                                    console::counted(lines.size(), "finding", "findings"),
                                    "`stridor library check --repair ARCHIVE` brings back what an export has."});
}

void repair(const CheckOptions& options, const std::filesystem::path& file) {
    const std::vector<std::filesystem::path> archives(options.archives.begin(), options.archives.end());
    io::JudgingOptions judging;
    judging.note = console::say_note;
    const io::Repair done = io::repair_library(file, archives, io::probe_of(judging, {}));
    console::print(fmt::format("{} kept, {} brought back from archives, {} made anew from sounds, {} lost\n",
                               console::counted(done.kept, "entry", "entries"), done.from_archives, done.from_sounds,
                               done.lost.size()));
    if (!done.lost.empty()) console::print("lost: " + console::ids_text(done.lost) + "\n");
    if (done.mended_sounds > 0)
        console::print(console::counted(done.mended_sounds, "sound", "sounds") + " brought back\n");
    if (!done.damaged_file.empty()) console::say("the damaged file is kept as " + done.damaged_file.string());
    tell(done.findings, file);
}

void check_library(const CheckOptions& options) {
    const std::filesystem::path file =
        options.library.file.empty() ? noise_library::default_library() : std::filesystem::path(options.library.file);
    if (options.repair) return repair(options, file);
    tell(noise_library::check(file), file);
}

using noise_library::Access;
using noise_library::Entry;
using noise_library::Library;

struct ExportOptions {
    LibraryOption library;
    std::string archive;
    std::vector<std::int64_t> ids;
    SelectionOptions selection;
};

void export_entries(const ExportOptions& options) {
    Library library = noise_library::open_library(options.library.file, Access::read, waiting());
    std::vector<Entry> entries;
    if (options.ids.empty()) {
        noise_library::Query query = query_of(options.selection);
        query.extent = noise_library::EntryExtent::whole;
        entries = library.find(query);
    } else {
        entries = library.get(options.ids);
    }
    if (entries.empty())
        throw Error(ErrorKind::input, {"there is nothing to export", "no entry meets the conditions", ""});
    io::export_library(library, entries, options.archive);
    console::say(fmt::format("wrote {} to {}", console::counted(entries.size(), "entry", "entries"), options.archive));
}

struct ImportOptions {
    LibraryOption library;
    std::string archive;
};

void import_entries(const ImportOptions& options) {
    Library library = noise_library::open_library(options.library.file, Access::fill, waiting());
    constexpr std::uint64_t large = 100'000'000;  // [bytes] what takes a second or so
    console::ShareDisplay display("imported");
    const auto show = [&](std::uint64_t done, std::uint64_t total) {
        if (total >= large) display.show(static_cast<double>(done) / static_cast<double>(total));
    };
    const io::Import result = io::import_library(library, options.archive, show);
    display.clear();
    const std::string ids = result.added.empty() ? ""
                            : result.added.size() == 1
                                ? fmt::format(", id {}", result.added.front())
                                : fmt::format(", ids {} to {}", result.added.front(), result.added.back());
    console::print(fmt::format("{} added{}; {} there already\n",
                               console::counted(result.added.size(), "entry", "entries"), ids, result.skipped));
    if (result.heard_otherwise > 0)
        console::say(fmt::format(
            "stridor: note: {} of those there already had another verdict by ear, which was kept; `stridor library "
            "judge` brings verdicts up to date",
            result.heard_otherwise));
}

}  // namespace

void add_library_check(CLI::App& library) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        library.add_subcommand("check", "Look at every page, entry and sound of the library for damage.");
    add_library_option(*command, options->library);
    CLI::Option* repair = command->add_flag("--repair", options->repair,
                                            "save what is whole, and bring back the rest from archives and sounds");
    command->add_option("archives", options->archives, "files that `stridor library export` wrote, for --repair")
        ->needs(repair);
    command->footer(
        "Exit code 5 if anything is damaged. The damaged file is kept beside the repaired one.\n"
        "Examples:\n  stridor library check\n  stridor library check --repair brakes.tar");
    command->callback([options] { check_library(*options); });
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
