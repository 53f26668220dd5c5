#include "library/library.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/results/library_text.hpp"
#include "stridor/console/terminal.hpp"
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

}  // namespace stridor::app
