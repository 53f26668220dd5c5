#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/explorer/first_answers.hpp"
#include "stridor/explorer/page_file.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace stridor::app {

namespace {

struct PageOptions {
    CaseOptions input;
    std::string output;
};

void page(const PageOptions& options) {
    std::string text = explorer::one_file_page(std::filesystem::read_symlink("/proc/self/exe"));
    std::optional<explorer::StandingCase> standing;
    if (!options.input.file.empty()) {
        standing = explorer::standing_alone(load_source(options.input.file, options.input.overrides));
        text = explorer::page_with_case(std::move(text), *standing);
    }
    text = explorer::page_with_first_answers(std::move(text), standing ? &*standing : nullptr);
    console::write_output(options.output, text);
}

}  // namespace

void add_page(CLI::App& program) {
    auto options = std::make_shared<PageOptions>();
    CLI::App* command = program.add_subcommand(
        "page", "Write the explorer as one HTML file, which opens on any machine without Stridor or a network.");
    command->add_option("file", options->input.file, "case or chart file (TOML; default: the paper's four cases)");
    command->add_option("--set", options->input.overrides, "override a key of the file (repeatable)")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    add_output_file(*command, options->output, "file to write (default: stdout)");
    command->footer(
        "All of the explorer is inside but the noise library and reports; it sends nothing anywhere. The verdict is in "
        "the file, and the chart if it takes no longer than some seconds.\n"
        "Examples:\n  stridor page -o stridor.html\n  stridor page door-seal.toml -o seal.html");
    command->callback([options] { page(*options); });
}

}  // namespace stridor::app
