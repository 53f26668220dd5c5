#include "arguments.hpp"
#include "commands.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/console/results/sound_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/pictures/sound.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>

namespace stridor::app {

namespace {

struct AnalyseOptions {
    SoundOptions input;
    std::string figure;
    pictures::Sheet sheet;
    std::string field = "free";
    bool json = false;
    bool weighted = false;
};

void analyse(const AnalyseOptions& options) {
    const auto field = options.field == "diffuse" ? sound::SoundField::diffuse : sound::SoundField::free;
    const io::SoundReport report = listen_to(options.input, field);
    if (!options.figure.empty()) {
        drawing::Scene scene = pictures::sound(report.channels[report.loudest], report.verdicts[report.loudest]);
        scene.title = drawing::StyledText(console::channel_title(report, report.loudest));
        pictures::draw(scene, options.figure, options.sheet);
    }
    console::print(options.json ? io::analyse_json(report) + "\n"
                                : console::analysis_text(report, options.weighted ? console::Weighting::of_all
                                                                                  : console::Weighting::of_pressures));
    if (!options.json && console::has_terminal())
        console::say(
            console::styled("next: stridor classify " + options.input.file, console::Style::dim, STDERR_FILENO));
}

}  // namespace

void add_analyse(CLI::App& program) {
    auto options = std::make_shared<AnalyseOptions>();
    CLI::App* command = program.add_subcommand(
        "analyse",
        "Level over time, spectrum, bands, segments and features of a recording, of one in Pa loudness, sharpness and "
        "roughness; and a figure with its spectrogram.");
    add_sound_options(*command, options->input);
    command->add_flag("--a-weighting", options->weighted, "A-weighted levels even where the unit is not Pa");
    command
        ->add_option("--field", options->field,
                     "how a sound in Pa comes to the listener, for its loudness and sharpness")
        ->check(one_of({"free", "diffuse"}))
        ->capture_default_str();
    add_figure_option(*command, options->figure, options->sheet, "draw waveform, level, spectrogram and segments");
    add_json_option(*command, options->json, "stridor.analyse/1");
    command->footer(
        "Examples:\n  stridor analyse squeak.wav\n  stridor analyse squeak.wav --full-scale \"2 Pa\" --figure "
        "squeak.png\n"
        "  stridor analyse rig.uff --channel 1 --json");
    command->callback([options] { analyse(*options); });
}

}  // namespace stridor::app
