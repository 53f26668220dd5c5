#include "arguments.hpp"
#include "interrupt.hpp"
#include "library/library.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/io/library/recording_probe.hpp"
#include "stridor/noise_library/starter/add_starter.hpp"

#include <CLI/CLI.hpp>

#include <exception>
#include <memory>
#include <vector>

namespace stridor::app {

namespace {

using noise_library::Entry;

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
