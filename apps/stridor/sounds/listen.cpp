#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "sounds/player.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/console/results/listening_text.hpp"
#include "stridor/console/sound_progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/sound/json_listen.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/record/schedule.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/storage/temporary.hpp"
#include "stridor/sweep/cell_choice.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

namespace stridor::app {

namespace {

using parameters::Direction;
using parameters::direction_names;
using parameters::DriveKind;
using signal::MotionQuantity;

constexpr double normal_peak = -1.0;  // [dBFS] where the largest sample of a normalised sound lies
// full scale of an absolute sound: the loudest of Table 1 peaks at a third of it
constexpr double velocity_full_scale = 10.0;       // [m/s]
constexpr double acceleration_full_scale = 100e3;  // [m/s^2]

struct ListenOptions {
    CaseOptions input;
    std::string cell;       // "x=20 N,y=0.6"
    std::string direction;  // "going", "coming"; empty: the whole motion
    bool judged = false;
    std::string out;
    std::string of = "joint";
    std::string quantity = "velocity";
    std::string component;  // empty: x of the joint, y of the plate
    std::string rate = "48000 Hz";
    std::string seconds;
    std::string level = "normalised";
    std::string full_scale;
    std::string high_pass = "20 Hz";
    std::string fade = "5 ms";
    bool json = false;
};

struct Choice {
    parameters::Case c;
    io::SoundInfo info;  // where it came from
};

std::optional<Direction> direction_of(const ListenOptions& options) {
    if (options.direction.empty()) return std::nullopt;
    return options.direction == "going" ? Direction::going : Direction::coming;
}

// --- which motion

// nothing where the whole run is heard
std::optional<double> seconds_of(const ListenOptions& options) {
    if (options.seconds.empty()) return std::nullopt;
    const double seconds = base::parse_quantity(options.seconds, "s");
    if (!(seconds > 0.0))
        base::refuse("--seconds " + options.seconds + " is no time to listen", "it must be positive", "");
    return seconds;
}

// a longer run, put over the file's as any other key; of one that lasts longer the beginning is heard
void set_duration(io::TomlSource& source, const parameters::Case& c, const std::optional<double>& seconds) {
    if (!seconds || *seconds <= c.run.duration) return;
    const bool is_whole = c.run.window == c.run.duration;
    source.overrides.push_back("run.duration=" + base::shortest(*seconds));
    if (is_whole) source.overrides.push_back("run.window=" + base::shortest(*seconds));
}

Choice chosen_cell(const ListenOptions& options, io::TomlSource source) {
    set_duration(source, io::read_study(source).base, seconds_of(options));
    const sweep::Study study = io::read_study(source);
    sweep::CellChoice cell = sweep::parse_cell(options.cell);
    if (const std::optional<Direction> direction = direction_of(options)) cell.direction = direction;
    const sweep::CellPlace place = sweep::nearest_cell(study, cell);
    Choice choice{sweep::case_at(study, place), {}};
    choice.info.cell = sweep::cell_words(study, place);
    return choice;
}

Choice choose(const ListenOptions& options) {
    io::TomlSource source = load_source(options.input.file, options.input.overrides);
    if (!options.cell.empty()) return chosen_cell(options, std::move(source));
    if (!options.seconds.empty()) set_duration(source, io::read_case(source), seconds_of(options));
    return {io::read_case(source), {}};
}

// --- what of it

sound::Pickup pickup(const ListenOptions& options) {
    const bool is_joint = options.of == "joint";
    const std::string component = options.component.empty() ? (is_joint ? "x" : "y") : options.component;
    if (!is_joint && component == "x")
        base::refuse("the plate's motion along x is imposed", "it is the drive, without any vibration",
                     "Listen to --component y of the plate, or to the joint.");
    const MotionQuantity quantity =
        options.quantity == "velocity" ? MotionQuantity::velocity : MotionQuantity::acceleration;
    if (!is_joint) return {2, quantity};
    return {component == "x" ? 0U : 1U, quantity};
}

// the part of the motion that is heard; all of it if no direction is named
std::vector<sound::Stretch> stretches(const ListenOptions& options, const parameters::Case& c) {
    const std::optional<Direction> direction = direction_of(options);
    const bool is_constant = c.drive.kind == DriveKind::constant;
    if (is_constant && direction && options.cell.empty() &&
        (*direction == Direction::going) != (c.drive.velocity > 0.0))
        base::refuse("this drive has no " + options.direction + " phase", "its velocity is constant",
                     "Change its sign: --set drive.velocity=" + base::shortest(-c.drive.velocity));
    if (!options.judged && (is_constant || !direction)) return {{0.0, c.run.duration}};
    if (!is_constant && !direction)
        base::refuse("--judged needs a direction", "going and coming phases are judged by themselves",
                     "Add --direction going or coming.");
    const record::Phase phase = is_constant                      ? record::Phase::all
                                : *direction == Direction::going ? record::Phase::going
                                                                 : record::Phase::coming;
    std::vector<sound::Stretch> found =
        sound::stretches_of(record::schedule(c), phase, options.judged ? record::Use::judged : record::Use::counted);
    if (found.empty())
        base::refuse("no " + options.direction + " phase lies in the window of " + base::shortest(c.run.window) + " s",
                     options.judged ? "only whole phases are judged" : "the drive does not move that way",
                     "Ask for more --seconds.");
    return found;
}

sound::AuralisationSettings settings_for(const ListenOptions& options, const parameters::Case& c) {
    sound::AuralisationSettings settings;
    settings.pickup = pickup(options);
    settings.rate = base::parse_quantity(options.rate, "Hz");
    settings.high_pass = base::parse_quantity(options.high_pass, "Hz");
    settings.fade = base::parse_quantity(options.fade, "s");
    if (!(settings.rate >= 8000.0 && settings.rate <= 192000.0) || settings.rate != std::floor(settings.rate))
        base::refuse("--rate " + options.rate + " is no rate for a sound", "it is a whole number from 8 kHz to 192 kHz",
                     "Use 44100, 48000 or 51200.");
    if (!(settings.high_pass >= 0.0 && settings.high_pass <= 0.1 * settings.rate))
        base::refuse("--high-pass " + options.high_pass + " leaves nothing to hear",
                     "it goes from 0 to a tenth of the rate", "20 Hz is the default, 0 leaves all in.");
    if (!(settings.fade >= 0.0)) base::refuse("--fade " + options.fade + " is no time", "it must not be negative", "");
    const double end = seconds_of(options).value_or(c.run.duration);
    for (const sound::Stretch& stretch : stretches(options, c))
        if (stretch.from < end) settings.stretches.push_back({stretch.from, std::min(stretch.to, end)});
    if (settings.stretches.empty())
        base::refuse("nothing of this part lies in the first " + base::shortest(end) + " s", "",
                     "Ask for more --seconds.");
    return settings;
}

// --- how loud

double full_scale_for(const ListenOptions& options, const hearing::RenderedSound& sound) {
    const std::string unit = sound.layout().channels.front().unit;
    const bool is_absolute = options.level == "absolute";
    if (!options.full_scale.empty() && !is_absolute)
        base::refuse("--full-scale does not go with a normalised level",
                     "its full scale follows from the loudest sample", "Add --level absolute.");
    const double usual = unit == "m/s" ? velocity_full_scale : acceleration_full_scale;
    if (!is_absolute)
        return sound.peak() < hearing::least_motion
                   ? usual
                   : sound.peak() / base::power_of_2(normal_peak / 20.0 * 3.321928094887362);
    const double full_scale = options.full_scale.empty() ? usual : base::parse_quantity(options.full_scale, unit);
    if (!(full_scale > 0.0)) base::refuse("--full-scale " + options.full_scale + " is not positive", "", "");
    if (sound.peak() > full_scale)
        base::refuse(fmt::format("the sound peaks at {:.4g} {}, above the full scale of {:g} {}", sound.peak(), unit,
                                 full_scale, unit),
                     "it would be clipped", fmt::format("Use --full-scale \"{:.1g} {}\".", 2.0 * sound.peak(), unit));
    return full_scale;
}

// --- where it goes

void require_destination(const ListenOptions& options) {
    if (options.out.empty()) {
        if (find_player().empty())
            throw Error(ErrorKind::io,
                        {"no program to play a sound is installed", "none of " + known_players() + " is on the PATH",
                         "Write a file with -o FILE.wav, or install one (Debian: alsa-utils)."});
    } else if (!options.out.ends_with(".wav")) {
        base::refuse("-o " + options.out + " is no WAV file", "sounds are written as WAV only",
                     "Give it a name that ends in .wav.");
    }
}

std::string description(const io::SoundInfo& info, const parameters::Case& c) {
    return fmt::format("simulated by stridor {}: {} {} along {}; {}", base::version(), info.of, info.quantity,
                       info.component, c.title);
}

void listen(ListenOptions options) {
    require_destination(options);
    const std::optional<Direction> of_cell =
        options.cell.empty() ? std::nullopt : sweep::parse_cell(options.cell).direction;
    if (options.direction.empty() && of_cell) options.direction = direction_names[static_cast<std::size_t>(*of_cell)];
    Choice choice = choose(options);
    const sound::AuralisationSettings settings = settings_for(options, choice.c);
    std::unique_ptr<hearing::RenderedSound> sound;
    {
        const Interrupt interrupt;
        console::RenderDisplay display(choice.c.run.duration);
        sound = hearing::render(choice.c, settings, interrupt.token(), [&](double time) { display.show(time); });
    }
    io::SoundInfo& info = choice.info;
    info.file = options.out;
    info.of = options.of;
    info.component = settings.pickup.dof == 0 ? "x" : "y";
    info.quantity = options.quantity;
    info.direction = options.direction.empty() ? "whole" : options.direction;
    info.part = options.judged ? "judged" : "all";
    info.unit = sound::unit_of(settings.pickup.quantity);
    info.rate = settings.rate;
    info.duration = static_cast<double>(sound->frames()) / settings.rate;
    info.high_pass = settings.high_pass;
    info.peak = sound->peak();
    info.rms = std::sqrt(sound->mean_square());
    info.level = options.level;
    info.full_scale = full_scale_for(options, *sound);
    info.player = options.out.empty() ? find_player() : "";

    const std::string case_text = io::case_toml(choice.c, {io::Comments::none, ""});
    const recordings::WavOptions file{recordings::WavSamples::pcm_24,
                                      {{info.full_scale, info.unit}},
                                      description(info, choice.c),
                                      recordings::case_mark + case_text};
    if (!options.out.empty()) recordings::write_wav(options.out, *sound, file);
    console::print(options.json ? io::listen_json(choice.c, info) + "\n" : console::listening_text(info));
    if (!options.out.empty()) return;
    const storage::PrivateFolder folder;
    const std::string temporary = (folder.path() / "sound.wav").string();
    recordings::write_wav(temporary, *sound, file);
    play(info.player, temporary);
}

}  // namespace

void add_listen(CLI::App& program) {
    auto options = std::make_shared<ListenOptions>();
    CLI::App* command =
        program.add_subcommand("listen", "Make a case or a chart's cell audible: play it, or write a WAV file.");
    add_case_options(*command, options->input);
    command->add_option("--cell", options->cell, "the cell of a chart nearest to these values: \"x=20 N,y=0.6\"")
        ->type_name("x=..,y=..");
    command->add_option("--direction", options->direction, "only the going or the coming phases (default: everything)")
        ->check(CLI::IsMember({"going", "coming"}));
    command->add_flag("--judged", options->judged, "only the steady part the verdict is made from");
    add_output_file(*command, options->out, "write FILE.wav instead of playing");
    command->add_option("--of", options->of, "whose motion")
        ->check(CLI::IsMember({"joint", "plate"}))
        ->capture_default_str();
    command->add_option("--quantity", options->quantity, "what of it")
        ->check(CLI::IsMember({"velocity", "acceleration"}))
        ->capture_default_str();
    command
        ->add_option("--component", options->component,
                     "along (x) or across (y) the contact (default: x of the joint, y of the plate)")
        ->check(CLI::IsMember({"x", "y"}));
    command->add_option("--rate", options->rate, "samples per second")->type_name("FREQUENCY")->capture_default_str();
    command
        ->add_option("--seconds", options->seconds,
                     "how much of the motion (default: run.duration); more than that simulates longer")
        ->type_name("TIME");
    command->add_option("--level", options->level, "normalised: peak at -1 dBFS; absolute: full scale as stated")
        ->check(CLI::IsMember({"normalised", "absolute"}))
        ->capture_default_str();
    command
        ->add_option("--full-scale", options->full_scale,
                     "absolute: what the largest sample stands for (default 10 m/s, 100 km/s^2)")
        ->type_name("VALUE");
    command->add_option("--high-pass", options->high_pass, "what is slower is left out; 0: nothing is")
        ->type_name("FREQUENCY")
        ->capture_default_str();
    command->add_option("--fade", options->fade, "fade at both ends of each stretch")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_flag("--json", options->json, "print what was made as JSON (schema stridor.listen/1)");
    command->footer(
        "The sound is the motion itself, in m/s or m/s^2: no sound pressure. The file says what its full scale is.\n"
        "Examples:\n  stridor listen squeal.toml\n  stridor listen creak.toml -o creak.wav --quantity acceleration\n"
        "  stridor listen pair.toml --cell \"x=20 N,y=0.6\" --direction going --seconds 3\n"
        "  stridor listen squeal.toml --of plate --level absolute --full-scale \"0.5 m/s\" -o plate.wav");
    command->callback([options] { listen(*options); });
}

}  // namespace stridor::app
