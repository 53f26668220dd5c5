#include "arguments.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "stridor/base/error.hpp"
#include "stridor/console/player.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/results/sound_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/rendered_sound.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/recordings/audio/wav.hpp"
#include "stridor/storage/new_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace stridor::app {

namespace {

struct ListenOptions {
    CaseOptions input;
    io::ListeningTexts texts;
    std::string out;
    bool json = false;
};

void require_destination(const ListenOptions& options) {
    if (options.out.empty()) {
        if (console::find_player().empty())
            throw Error(ErrorKind::io, {"no program to play a sound is installed",
                                        "none of " + console::known_players() + " is on the PATH",
                                        "Write a file with -o FILE.wav, or install one (Debian: alsa-utils)."});
    } else if (!options.out.ends_with(".wav")) {
        base::refuse("-o " + options.out + " is no WAV file", "sounds are written as WAV only",
                     "Give it a name that ends in .wav.");
    }
}

void listen(ListenOptions options) {
    require_destination(options);
    const io::ListeningChoice choice =
        io::chosen_case(options.texts, load_source(options.input.file, options.input.overrides));
    const Interrupt interrupt;
    const hearing::HeardMotion motion =
        hearing::heard_motion(choice.c, io::asked_motion(options.texts), interrupt.token());
    const sound::AuralisationSettings settings = io::listening_settings(options.texts, choice.c, motion);
    std::unique_ptr<hearing::RenderedSound> sound;
    {
        console::RenderDisplay display(choice.c.run.duration);
        sound = hearing::render(choice.c, settings, interrupt.token(), [&](double time) { display.show(time); });
    }
    io::SoundInfo info = io::sound_info(options.texts, choice, motion, settings, *sound);
    info.file = options.out;
    info.player = options.out.empty() ? console::find_player() : "";

    std::string history = recordings::case_mark + io::case_toml(choice.c, {io::Comments::none, ""});
    if (history.size() > recordings::longest_history) {
        console::say_note("the sound does not hold its case, whose matrices are too large for it");
        history.clear();
    }
    const recordings::WavOptions file{
        recordings::WavSamples::pcm_24, {{info.full_scale, info.unit}}, io::sound_description(info, choice.c), history};
    if (!options.out.empty()) recordings::write_wav(options.out, *sound, file);
    console::print(options.json ? io::listen_json(choice.c, info) + "\n" : console::listening_text(info));
    if (!options.out.empty()) return;
    const storage::PrivateFolder folder;
    const std::string temporary = (folder.path() / "sound.wav").string();
    recordings::write_wav(temporary, *sound, file);
    console::play(info.player, temporary);
}

}  // namespace

void add_listen(CLI::App& program) {
    auto options = std::make_shared<ListenOptions>();
    CLI::App* command =
        program.add_subcommand("listen", "Make a case or a chart's cell audible: play it, or write a WAV file.");
    add_case_options(*command, options->input);
    command->add_option("--cell", options->texts.cell, "the cell of a chart nearest to these values: \"x=20 N,y=0.6\"")
        ->type_name("x=..,y=..");
    command
        ->add_option("--direction", options->texts.direction,
                     "only the going or the coming phases (default: everything)")
        ->check(one_of({"going", "coming"}));
    command->add_flag("--judged", options->texts.is_judged, "only the steady part the verdict is made from");
    add_output_file(*command, options->out, "write FILE.wav instead of playing");
    command
        ->add_option(
            "--of", options->texts.of,
            "whose motion: joint (of several contacts the strongest), plate, or the name of one of several joints; of "
            "an own structure a contact or a row")
        ->type_name("joint|plate|NAME")
        ->capture_default_str();
    command->add_option("--quantity", options->texts.quantity, "what of it")
        ->check(one_of({"velocity", "acceleration"}))
        ->capture_default_str();
    command
        ->add_option("--component", options->texts.component,
                     "along (x) or across (y) the contact (default: x of the joint, y of the plate)")
        ->check(one_of({"x", "y"}));
    command->add_option("--rate", options->texts.rate, "samples per second")
        ->type_name("FREQUENCY")
        ->capture_default_str();
    command
        ->add_option("--seconds", options->texts.seconds,
                     "how much of the motion (default: run.duration); more than that simulates longer")
        ->type_name("TIME");
    command->add_option("--level", options->texts.level, "normalised: peak at -1 dBFS; absolute: full scale as stated")
        ->check(one_of({"normalised", "absolute"}))
        ->capture_default_str();
    command
        ->add_option("--full-scale", options->texts.full_scale,
                     "absolute: what the largest sample stands for (default 10 m/s, 100 km/s^2)")
        ->type_name("VALUE");
    command->add_option("--high-pass", options->texts.high_pass, "what is slower is left out; 0: nothing is")
        ->type_name("FREQUENCY")
        ->capture_default_str();
    command->add_option("--fade", options->texts.fade, "fade at both ends of each stretch")
        ->type_name("TIME")
        ->capture_default_str();
    command->add_flag("--json", options->json, "print what was made as JSON (schema stridor.listen/1)");
    command->footer(
        "It is played by the first of " + console::known_players() +
        " that is on the PATH. The sound is the motion itself, in m/s or m/s^2: no sound pressure. The file says what "
        "its full scale is.\n"
        "Examples:\n  stridor listen squeal.toml\n  stridor listen creak.toml -o creak.wav --quantity acceleration\n"
        "  stridor listen pair.toml --cell \"x=20 N,y=0.6\" --direction going --seconds 3\n"
        "  stridor listen squeal.toml --of plate --level absolute --full-scale \"0.5 m/s\" -o plate.wav");
    command->callback([options] { listen(*options); });
}

}  // namespace stridor::app
