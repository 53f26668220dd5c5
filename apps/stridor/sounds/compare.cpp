#include "sounds/compare.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
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

namespace stridor::app {

namespace {

using classification::ComparedSound;
using hearing::NamedSound;

constexpr double least_detail = 1e-3;  // [s]
constexpr double most_detail = 2.0;    // [s]

double detail_of(const std::string& text) {
    const double detail = base::parse_quantity(text, "s");
    if (!(detail >= least_detail && detail <= most_detail))
        base::refuse("--detail " + text + " is too short or too long", "it goes from 1 ms to 2 s", "");
    return detail;
}

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

void add_motion_options(CLI::App& command, MotionOptions& options) {
    command
        .add_option("--of", options.of,
                    "whose motion stands for the sound of a simulation: joint (of several contacts the strongest), "
                    "plate, or a name as for `stridor listen`")
        ->type_name("joint|plate|NAME")
        ->capture_default_str();
    command.add_option("--quantity", options.quantity, "what of it")
        ->check(one_of({"velocity", "acceleration"}))
        ->capture_default_str();
}

hearing::AskedMotion asked_motion(const MotionOptions& options) {
    const signal::MotionQuantity quantity =
        options.quantity == "velocity" ? signal::MotionQuantity::velocity : signal::MotionQuantity::acceleration;
    return {options.of, "", quantity};
}

void add_compare_options(CLI::App& command, CompareOptions& options) {
    command.add_option("sounds", options.sounds, "2 to 8 sounds: recordings, cases, cells of charts, library:ID")
        ->required();
    command.add_option("--label", options.labels, "what a sound is called; once for each, in their order")
        ->type_name("TEXT")
        ->allow_extra_args(false);
    add_library_option(command, options.library);
    add_motion_options(command, options.motion);
}

io::SoundLookup lookup_in(const LibraryOption& library) {
    return {library.file, console::say_note, console::say_warning};
}

ComparedSound load_sound(const NamedSound& sound, const hearing::ComparisonSettings& settings) {
    if (std::holds_alternative<hearing::RecordedSound>(sound.source)) return hearing::compared(sound, settings);
    const Interrupt interrupt;
    return hearing::compared(sound, settings, interrupt.token());
}

std::vector<ComparedSound> load_sounds(const CompareOptions& options) {
    hearing::require_comparable(options.sounds.size());
    if (!options.labels.empty() && options.labels.size() != options.sounds.size())
        base::refuse(fmt::format("{} labels for {} sounds", options.labels.size(), options.sounds.size()),
                     "each sound needs its own", "");
    if (std::count(options.sounds.begin(), options.sounds.end(), "-") > 1)
        base::refuse("standard input is asked for twice", "it can be read once", "");
    hearing::ComparisonSettings settings;
    settings.detail = detail_of(options.detail);
    settings.motion = asked_motion(options.motion);
    std::vector<NamedSound> all;
    for (const std::string& text : options.sounds)
        all.push_back(io::named_sound(text, lookup_in(options.library)));
    settings.rate = hearing::common_rate(all);
    std::vector<ComparedSound> sounds;
    for (const NamedSound& each : all)
        sounds.push_back(load_sound(each, settings));
    for (std::size_t k = 0; k < options.labels.size(); ++k)
        sounds[k].label = options.labels[k];
    if (std::any_of(all.begin(), all.end(), [&](const NamedSound& each) { return is_resampled(each, settings.rate); }))
        console::say_note(fmt::format("all sounds are compared at the lowest rate, {:g} Hz", settings.rate));
    return sounds;
}

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
