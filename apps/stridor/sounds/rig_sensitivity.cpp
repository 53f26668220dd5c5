#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "library/library.hpp"
#include "sounds/rig.hpp"
#include "stridor/console/results/sensitivity_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/library/json_library.hpp"
#include "stridor/noise_library/sensitivity.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/sensitivity.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace stridor::app {

namespace {

using noise_library::Sensitivity;

struct SensitivityCommand {
    LibraryOption library;
    SelectionOptions selection;
    std::string over = "preload";
    std::size_t bins = 0;
    std::string by = "category";
    std::string figure;
    pictures::Sheet sheet;
    bool records = false;
    bool json = false;
};

void run_sensitivity(const SensitivityCommand& command) {
    noise_library::Library library =
        noise_library::open_library(command.library.file, noise_library::Access::read, waiting());
    noise_library::SensitivityOptions options;
    options.quantity = command.over;
    options.bins = command.bins;
    options.judge = command.by == "category" ? noise_library::Judge::stridor : noise_library::Judge::engineer;
    const Sensitivity result = noise_library::sensitivity_in(library, query_of(command.selection), options);
    if (!command.figure.empty()) pictures::draw(pictures::sensitivity(result), command.figure, command.sheet);
    console::print(command.json ? io::sensitivity_json(library.file(), result) + "\n"
                                : console::sensitivity_text(result, command.records ? console::SensitivityRows::records
                                                                                    : console::SensitivityRows::bins));
}

}  // namespace

void add_rig_sensitivity(CLI::App& rig) {
    auto options = std::make_shared<SensitivityCommand>();
    CLI::App* command = rig.add_subcommand(
        "sensitivity", "How category, level and dominant frequency move over a quantity across records of a library.");
    command
        ->add_option("--over", options->over,
                     "preload, velocity, temperature, humidity, or any other number of the records")
        ->type_name("FIELD")
        ->capture_default_str();
    add_selection_options(*command, options->selection);
    command->add_option("--bins", options->bins, "number of bins (default: a bin per value up to 10 values, else 6)")
        ->check(CLI::Range(1, 1000));
    command->add_option("--by", options->by, "whose word counts: category (Stridor's) or denomination (the engineer's)")
        ->check(one_of({"category", "denomination"}))
        ->capture_default_str();
    command->add_flag("--records", options->records, "a row per record instead of bins");
    CLI::Option* figure =
        command->add_option("--figure", options->figure, "draw the records to FILE.png, FILE.svg or FILE.pdf")
            ->type_name("FILE")
            ->check(in_a_folder());
    add_sheet_options(*command, options->sheet, figure);
    add_json_option(*command, options->json, "stridor.sensitivity/1");
    add_library_option(*command, options->library);
    command->footer(
        "Level and dominant frequency are the figures `level` and `dominant_frequency` of an entry.\n"
        "Examples:\n  stridor rig sensitivity --over preload --where \"recorded = rig\" --figure preload.png\n"
        "  stridor rig sensitivity --over temperature --by denomination --records");
    command->callback([options] { run_sensitivity(*options); });
}

}  // namespace stridor::app
