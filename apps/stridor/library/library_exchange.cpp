#include "interrupt.hpp"
#include "library/library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/library/library_archive.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace stridor::app {

namespace {

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
