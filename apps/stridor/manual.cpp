#include "stridor/console/manual.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "help.hpp"
#include "stridor/base/version.hpp"
#include "stridor/console/completion.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

namespace stridor::app {

namespace {

struct CompletionOptions {
    std::string shell = "bash";
    std::vector<std::string> words;  // typed behind `stridor`: a shell asks what may be the last one
    std::string output;
};

}  // namespace

void add_completion(CLI::App& program) {
    auto options = std::make_shared<CompletionOptions>();
    CLI::App* command =
        program.add_subcommand("completion", "Write the script that lets a shell complete commands, options and keys.");
    command->add_option("shell", options->shell, "bash, zsh or fish")
        ->check(one_of({console::shells.begin(), console::shells.end()}))
        ->capture_default_str();
    command->add_option("words", options->words)->group("");
    add_output_file(*command, options->output, "file to write (default: stdout)");
    command->footer(
        "Examples, for zsh with a folder of its fpath:\n"
        "  stridor completion bash -o ~/.local/share/bash-completion/completions/stridor\n"
        "  stridor completion zsh -o ~/.zfunc/_stridor\n"
        "  stridor completion fish -o ~/.config/fish/completions/stridor.fish");
    command->callback([&program, options] {
        if (!options->words.empty())
            console::print_data(console::completion_lines(console::completions(described(program), options->words)));
        else
            console::write_output(options->output, console::completion_script(options->shell));
    });
}

void add_manual(CLI::App& program) {
    auto output = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("manual", "Write the manual page: all commands with their options.");
    add_output_file(*command, *output, "file to write (default: stdout)");
    command->footer("Example:\n  stridor manual -o stridor.1 && man ./stridor.1");
    command->callback([&program, output] {
        console::write_output(*output, console::manual_page(described(program), std::string(base::version())));
    });
}

}  // namespace stridor::app
