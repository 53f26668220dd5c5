#include "arguments.hpp"
#include "commands.hpp"
#include "sounds/rig.hpp"
#include "stridor/console/results/friction_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/simulation/friction_test.hpp"
#include "stridor/io/simulation/json_friction.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <string>

namespace stridor::app {

namespace {

struct FrictionOptions {
    io::FrictionTexts texts;
    std::string into;
    bool json = false;
};

void friction(const FrictionOptions& options) {
    const io::MeasuredFriction measured = io::measured_friction(options.texts, console::say_note);
    const analysis::FrictionTrace& trace = measured.trace;
    if (!options.into.empty()) {
        console::print_data(io::case_with_friction(io::read_case(load_source(options.into)), measured));
        console::say(fmt::format("static {}, kinetic {}", console::coefficient_text(trace.all.static_friction),
                                 console::coefficient_text(trace.all.kinetic_friction)));
        return;
    }
    console::print(options.json ? io::friction_json(measured.test, trace) + "\n"
                                : console::friction_text(measured.test, trace));
}

}  // namespace

void add_rig_friction(CLI::App& rig) {
    auto options = std::make_shared<FrictionOptions>();
    CLI::App* command =
        rig.add_subcommand("friction", "Friction coefficients and force drops of a measured friction force.");
    command->add_option("file", options->texts.file, "measurement: CSV, UFF58 or WAV; - reads stdin")->required();
    command->add_option("--preload", options->texts.preload, "force that presses the parts together")
        ->type_name("FORCE")
        ->required();
    command
        ->add_option("--channel", options->texts.channel,
                     "the friction force: name or number (default: the only one in N)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--velocity-channel", options->texts.velocity_channel,
                     "the imposed velocity (default: the only one in m/s)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--normal-channel", options->texts.normal_channel,
                     "the pressing force (default: the one that says so, else the preload)")
        ->type_name("NAME|NUMBER");
    command->add_option("--velocity", options->texts.velocity, "nominal velocity of the test")->type_name("VELOCITY");
    command->add_option("--full-scale", options->texts.full_scale, "what 1 in an uncalibrated file stands for")
        ->type_name("VALUE");
    command->add_option("--least-drop", options->texts.least_drop, "smallest drop, as a share of the force's level")
        ->check(CLI::Range(1e-4, 1.0))
        ->capture_default_str();
    command->add_option("--longest-drop", options->texts.longest_drop, "a fall that takes longer is drift")
        ->type_name("TIME")
        ->capture_default_str();
    CLI::Option* into =
        command->add_option("--into", options->into, "print this case with the coefficients put in")->type_name("CASE");
    add_json_option(*command, options->json, "stridor.friction/1")->excludes(into);
    command->footer(
        "Examples:\n  stridor rig friction seal.csv --preload \"10 N\" --velocity \"4 mm/s\"\n"
        "  stridor rig friction seal.uff --preload \"40 N\" --channel \"friction force\" --json\n"
        "  stridor rig friction seal.csv --preload \"10 N\" --into seal.toml > measured.toml");
    command->callback([options] { friction(*options); });
}

}  // namespace stridor::app
