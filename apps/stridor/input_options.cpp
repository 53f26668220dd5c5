#include "input_options.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"

#include <CLI/CLI.hpp>

namespace stridor::app {

void add_input_options(CLI::App& command, InputOptions& options) {
    command
        .add_option("--full-scale", options.full_scales,
                    "what the number 1 in the file stands for: \"2 Pa\"; once, or once per channel")
        ->type_name("QUANTITY")
        ->allow_extra_args(false);
    command.add_option("--channel", options.channel, "this channel alone, counted from 1")->check(CLI::PositiveNumber);
    command.add_option("--dataset", options.dataset, "this time history of a UFF file, counted from 1")
        ->check(CLI::PositiveNumber);
    command.add_option("--rate", options.rate, "sampling rate of a CSV table that does not tell it")->type_name("HZ");
}

io::OpenOptions open_options(const InputOptions& options) {
    io::OpenOptions open;
    for (const std::string& text : options.full_scales)
        open.full_scales.push_back(io::parse_full_scale(text));
    if (!options.rate.empty()) open.rate = base::parse_quantity(options.rate, "Hz");
    if (open.rate && !(*open.rate > 0.0))
        throw Error(ErrorKind::input, {"\"" + options.rate + "\" is no sampling rate", "it must be positive", ""});
    if (options.channel > 0) open.channel = options.channel;
    if (options.dataset > 0) open.dataset = options.dataset;
    return open;
}

}  // namespace stridor::app
