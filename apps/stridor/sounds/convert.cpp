#include "arguments.hpp"
#include "commands.hpp"
#include "sounds/sound_options.hpp"
#include "stridor/console/results/sound_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/sound/signal_report.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct ConvertOptions {
    std::string input;
    io::SignalTarget target;  // without a file: only say what the input holds
    InputOptions recording;
    bool json = false;
};

void convert(const ConvertOptions& options) {
    const recordings::OpenOptions open = open_options(options.recording);
    if (!options.target.file.empty()) io::format_of(options.target);  // before hours are read
    const recordings::SignalInput input = recordings::open_input(options.input);
    const io::SignalSummary summary = io::summary_of(*recordings::open_signal(input, open));
    for (const std::string& note : summary.facts.notes)
        console::say("stridor: note: " + note);
    std::optional<io::SignalOutput> output;
    if (!options.target.file.empty()) {
        output = io::write_signal(options.target, summary, *recordings::open_signal(input, open));
        if (output->clipped > 0)
            console::say(fmt::format("stridor: note: {} samples were cut to full scale", output->clipped));
    }
    const std::string text = options.json ? io::convert_json(summary, output) + "\n" : console::signal_text(summary);
    if (options.target.file == "-")
        console::say(text);
    else
        console::print(text);
}

}  // namespace

void add_convert(CLI::App& program) {
    auto options = std::make_shared<ConvertOptions>();
    CLI::App* command = program.add_subcommand(
        "convert", "Read a recording of any format, say what it holds, and write it as another.");
    command
        ->add_option("in", options->input,
                     "WAV, FLAC, Ogg, MP3, AIFF, M4A, CSV, UFF 58 or MAT file; - for standard input")
        ->required();
    command
        ->add_option("out", options->target.file,
                     "file to write (.wav, .csv, .uff); without it only the report is printed")
        ->check(in_a_folder());
    add_input_options(*command, options->recording);
    command->add_option("--format", options->target.format, "of OUT, whatever its name")
        ->check(one_of({"wav", "csv", "uff58", "uff58b"}));
    command->add_option("--bits", options->target.bits, "of a WAV's samples; by default as in IN, or float")
        ->check(one_of({"16", "24", "float"}));
    add_json_option(*command, options->json, "stridor.convert/1");
    command->footer(
        "Without --full-scale the unit comes from NAME.json beside the recording, the text in its header, or its own "
        "units; "
        "without any it is FS.\n"
        "Examples:\n  stridor convert squeak.wav\n  stridor convert squeak.wav squeak.uff --full-scale \"2 Pa\"\n"
        "  stridor convert rig.uff rig.wav --bits 24 --channel 1");
    command->callback([options] { convert(*options); });
}

}  // namespace stridor::app
