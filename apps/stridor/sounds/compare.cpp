#include "sounds/compare.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "sounds/compare_options.hpp"
#include "stridor/console/results/comparison_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/sound/json_compare.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/side_by_side.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace stridor::app {

namespace {

using classification::ComparedSound;

struct CompareCommand {
    CompareOptions input;
    bool json = false;
};

struct FigureCommand {
    CompareOptions input;
    std::string output = "compare.png";
    pictures::Sheet sheet;
};

void compare(const CompareCommand& options) {
    const std::vector<ComparedSound> sounds = load_sounds(options.input);
    console::print(options.json ? io::compare_json(sounds) + "\n" : console::comparison_text(sounds));
    if (!options.json && console::has_terminal())
        console::say(console::styled("next: stridor figure compare with the same arguments draws them",
                                     console::Style::dim, STDERR_FILENO));
}

}  // namespace

void add_compare(CLI::App& program) {
    auto options = std::make_shared<CompareCommand>();
    CLI::App* command = program.add_subcommand(
        "compare", "Lay recordings and simulations side by side: categories, figures, and how far apart they are.");
    add_compare_options(*command, options->input);
    add_json_option(*command, options->json, "stridor.compare/1");
    command->footer(std::string(io::sound_forms) +
                    "\nExamples:\n  stridor compare vehicle.wav rig.uff squeal.toml\n"
                    "  stridor compare library:3 \"pair.toml:x=20 N,y=0.6\" --of plate --json");
    command->callback([options] { compare(*options); });
}

void add_figure_compare(CLI::App& figure) {
    auto options = std::make_shared<FigureCommand>();
    CLI::App* command = figure.add_subcommand(
        "compare",
        "Vehicle, rig and model side by side: time history, spectrogram, contact states, figures (Figure 4).");
    add_compare_options(*command, options->input);
    command
        ->add_option("--detail", options->input.detail,
                     "how long the stretch is that is drawn wave by wave, 1 ms to 2 s")
        ->type_name("TIME")
        ->capture_default_str();
    add_output_file(*command, options->output, "FILE.png, FILE.svg or FILE.pdf")->capture_default_str();
    add_sheet_options(*command, options->sheet);
    command->footer(std::string(io::sound_forms) +
                    "\nExample:\n  stridor figure compare vehicle.wav rig.uff squeal.toml --label vehicle --label rig "
                    "--label model -o figure-4.png");
    command->callback([options] {
        pictures::draw(pictures::side_by_side(load_sounds(options->input)), options->output, options->sheet);
    });
}

}  // namespace stridor::app
