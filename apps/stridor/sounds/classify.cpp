#include "arguments.hpp"
#include "commands.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/console/results/verdict_text.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>

namespace stridor::app {

namespace {

struct ClassifyOptions {
    SoundOptions input;
    bool json = false;
};

void classify(const ClassifyOptions& options) {
    const io::SoundReport report = listen_to(options.input);
    console::print(options.json ? io::classify_json(report) + "\n" : console::verdict_text(report));
}

}  // namespace

void add_classify(CLI::App& program) {
    auto options = std::make_shared<ClassifyOptions>();
    CLI::App* command = program.add_subcommand(
        "classify", "Hear whether a recording squeals, squeaks, creaks or is quiet, part by part and as a whole.");
    add_sound_options(*command, options->input);
    add_json_option(*command, options->json, "stridor.classify/1");
    std::string names;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        names +=
            fmt::format("\n  {:<20} {:>6g} {:<5} {}", threshold.name, parameters::SoundThresholds{}.*(threshold.member),
                        threshold.unit == "1" ? "" : threshold.unit, threshold.sentence);
    command->footer(
        "Examples:\n  stridor classify squeak.wav\n  stridor classify rig.uff --channel 2 --json\n"
        "  stridor classify door.flac --set squeal_regularity=0.7\n\nThresholds for --set:" +
        names);
    command->callback([options] { classify(*options); });
}

}  // namespace stridor::app
