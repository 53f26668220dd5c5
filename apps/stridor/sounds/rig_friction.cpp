#include "commands.hpp"
#include "sounds/rig.hpp"
#include "stridor/analysis/friction_trace.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/console/results/friction_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/simulation/json_friction.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/recordings/rig_channels.hpp"
#include "stridor/signal/channel_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace stridor::app {

namespace {

using analysis::FrictionTrace;

// an hour of four channels at 10 kHz
constexpr std::uint64_t most_samples = 150'000'000;

struct FrictionOptions {
    std::string file;
    std::string preload;
    std::string velocity;  // nominal
    std::string channel, velocity_channel, normal_channel;
    std::string full_scale;
    double least_drop = analysis::FrictionTraceOptions{}.least_drop;
    std::string longest_drop = "250 ms";
    std::string into;
    bool json = false;
};

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

// the case with the measured coefficients
std::string changed_case(const FrictionOptions& options, const io::FrictionTest& test, const FrictionTrace& trace) {
    parameters::Case c = io::read_case(load_source(options.into));
    const double mu_d = rounded(trace.all.kinetic_friction.value);
    double mu_s = rounded(trace.all.static_friction.value);
    if (!std::isfinite(mu_d)) base::refuse("the trace shows no kinetic coefficient", "nothing slides in it", "");
    std::string heading = fmt::format("friction coefficients measured: {}, preload {:g} N", test.file, test.preload);
    if (!std::isfinite(mu_s)) {
        mu_s = mu_d;
        heading += "\nno static coefficient was to be seen: it is set to the kinetic one";
    }
    if (mu_s < mu_d)
        base::refuse(fmt::format("the static coefficient, {:g}, comes out below the kinetic one, {:g}", mu_s, mu_d),
                     "the model needs it the other way round", "Is --preload right, and the sensor's zero?");
    parameters::set_quantity(c, *parameters::find_field("contact.static_friction"), mu_s);
    parameters::set_quantity(c, *parameters::find_field("contact.kinetic_friction"), mu_d);
    return io::case_toml(c, {io::Comments::full, heading});
}

void friction(const FrictionOptions& options) {
    recordings::OpenOptions open;
    if (!options.full_scale.empty()) open.full_scales = {recordings::parse_full_scale(options.full_scale)};
    const std::unique_ptr<recordings::SignalFile> file = recordings::open_signal(options.file, open);
    const signal::ChannelLayout layout = file->layout();
    const recordings::FrictionChannels places =
        recordings::friction_channels(layout, {options.channel, options.velocity_channel, options.normal_channel});
    for (const std::string& note : file->facts().notes)
        console::say("stridor: note: " + note);
    const std::vector<signal::Signal> channels = signal::read_all(*file, most_samples);

    analysis::FrictionMeasurement measurement;
    measurement.rate = layout.rate;
    measurement.preload = base::parse_quantity(options.preload, "N");
    measurement.force = channels[places.force].samples;
    if (places.velocity) measurement.velocity = channels[*places.velocity].samples;
    if (places.normal) measurement.normal_force = channels[*places.normal].samples;
    analysis::FrictionTraceOptions settings;
    settings.least_drop = options.least_drop;
    settings.longest_drop = base::parse_quantity(options.longest_drop, "s");
    const FrictionTrace trace = analysis::friction_trace(measurement, settings);

    io::FrictionTest test;
    test.file = options.file;
    test.channel = layout.channels[places.force].name;
    if (places.velocity) test.velocity_channel = layout.channels[*places.velocity].name;
    if (places.normal) test.normal_channel = layout.channels[*places.normal].name;
    test.rate = layout.rate;
    test.duration = signal::duration(channels[places.force]);
    test.preload = measurement.preload;
    test.velocity = !options.velocity.empty() ? base::parse_quantity(options.velocity, "m/s")
                    : places.velocity         ? recordings::usual_speed(channels[*places.velocity].samples)
                                              : std::numeric_limits<double>::quiet_NaN();
    test.condition = analysis::vda_condition(test.preload, test.velocity);
    for (const std::string& note : trace.notes)
        console::say("stridor: note: " + note);
    if (!options.into.empty()) {
        console::print_data(changed_case(options, test, trace));
        console::say(fmt::format("static {}, kinetic {}", console::coefficient_text(trace.all.static_friction),
                                 console::coefficient_text(trace.all.kinetic_friction)));
        return;
    }
    console::print(options.json ? io::friction_json(test, trace) + "\n" : console::friction_text(test, trace));
}

}  // namespace

void add_rig_friction(CLI::App& rig) {
    auto options = std::make_shared<FrictionOptions>();
    CLI::App* command =
        rig.add_subcommand("friction", "Friction coefficients and force drops of a measured friction force.");
    command->add_option("file", options->file, "measurement: CSV, UFF58 or WAV; - reads stdin")->required();
    command->add_option("--preload", options->preload, "force that presses the parts together")
        ->type_name("FORCE")
        ->required();
    command
        ->add_option("--channel", options->channel, "the friction force: name or number (default: the only one in N)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--velocity-channel", options->velocity_channel,
                     "the imposed velocity (default: the only one in m/s)")
        ->type_name("NAME|NUMBER");
    command
        ->add_option("--normal-channel", options->normal_channel,
                     "the pressing force (default: the one that says so, else the preload)")
        ->type_name("NAME|NUMBER");
    command->add_option("--velocity", options->velocity, "nominal velocity of the test")->type_name("VELOCITY");
    command->add_option("--full-scale", options->full_scale, "what 1 in an uncalibrated file stands for")
        ->type_name("VALUE");
    command->add_option("--least-drop", options->least_drop, "smallest drop, as a share of the force's level")
        ->check(CLI::Range(1e-4, 1.0))
        ->capture_default_str();
    command->add_option("--longest-drop", options->longest_drop, "a fall that takes longer is drift")
        ->type_name("TIME")
        ->capture_default_str();
    CLI::Option* into =
        command->add_option("--into", options->into, "print this case with the coefficients put in")->type_name("CASE");
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.friction/1)")->excludes(into);
    command->footer(
        "Examples:\n  stridor rig friction seal.csv --preload \"10 N\" --velocity \"4 mm/s\"\n"
        "  stridor rig friction seal.uff --preload \"40 N\" --channel \"friction force\" --json\n"
        "  stridor rig friction seal.csv --preload \"10 N\" --into seal.toml > measured.toml");
    command->callback([options] { friction(*options); });
}

}  // namespace stridor::app
