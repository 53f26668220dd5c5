#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/ready_files.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace stridor::app {

namespace {

struct InitOptions {
    std::string kind;
    std::string output;
    bool is_forced = false;
};

void init(const InitOptions& options) {
    if (!options.is_forced) io::spare_written(options.output);
    console::write_output(options.output, io::ready_file(options.kind));
}

}  // namespace

void add_init(CLI::App& program) {
    auto options = std::make_shared<InitOptions>();
    CLI::App* command = program.add_subcommand("init", "Write a commented case or chart file to start from.");
    command
        ->add_option("kind", options->kind,
                     "squeal, squeak, creak, quiet: Table 1; noise-chart: Figure 8; rate-map: Figure 6; weatherstrip, "
                     "weatherstrip-shaken, glass-run, clip, wiper, brake-pad: soft parts of a car, each with its "
                     "chart; wiper-wet, weatherstrip-falling: with friction over the slip velocity; seal-lip: with a "
                     "lip that stiffens; two-lips: several joints; chain, string: structures of one's own; "
                     "schema: JSON Schema of case files")
        ->required()
        ->check(one_of(io::ready_file_names()));
    add_output_file(*command, options->output, "file to write (default: stdout)");
    command->add_flag("--force", options->is_forced, "write over a file that was changed by hand");
    command->footer(
        "Examples:\n  stridor init squeal -o squeal.toml\n  stridor init quiet | stridor simulate -\n"
        "  stridor init weatherstrip | stridor chart - --out seal");
    command->callback([options] { init(*options); });
}

}  // namespace stridor::app
