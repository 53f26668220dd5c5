#include "input_options.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"

#include <CLI/CLI.hpp>

namespace stridor::app {

void add_full_scale_option(CLI::App& command, std::vector<std::string>& full_scales) {
    command
        .add_option("--full-scale", full_scales,
                    "what the number 1 in the file stands for: \"2 Pa\"; once, or once per channel")
        ->type_name("QUANTITY")
        ->allow_extra_args(false);
}

void add_input_options(CLI::App& command, InputOptions& options) {
    add_full_scale_option(command, options.full_scales);
    command.add_option("--channel", options.channel, "this channel alone: its name, or its number from 1")
        ->type_name("NAME|NUMBER");
    command.add_option("--dataset", options.dataset, "this time history of a UFF file, counted from 1")
        ->check(CLI::Range(1, 1'000'000));
    command.add_option("--rate", options.rate, "sampling rate of a CSV table or MAT file that does not tell it")
        ->type_name("HZ");
}

recordings::OpenOptions open_options(const InputOptions& options) {
    recordings::OpenOptions open;
    open.full_scales = recordings::parse_full_scales(options.full_scales);
    if (!options.rate.empty()) open.rate = base::parse_quantity(options.rate, "Hz");
    if (open.rate && !(*open.rate > 0.0))
        throw Error(ErrorKind::input, {"\"" + options.rate + "\" is no sampling rate", "it must be positive", ""});
    open.channel_name = options.channel;
    if (options.dataset > 0) open.dataset = options.dataset;
    return open;
}

}  // namespace stridor::app
