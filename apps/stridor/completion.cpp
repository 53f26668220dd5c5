#include "stridor/console/completion.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/console/terminal.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace stridor::app {

namespace {

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            if (!option->get_group().empty()) words.push_back("--" + name);  // without a group: another spelling
    return words;
}

console::CommandWords words_of(const CLI::App& command) {
    console::CommandWords words{command.get_name(), options_of(command), {}};
    for (const CLI::App* each : command.get_subcommands({}))
        words.subcommands.push_back(words_of(*each));
    return words;
}

}  // namespace

void add_completion(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("completion", "Print the shell completion script (bash; zsh through bashcompinit).");
    auto shell = std::make_shared<std::string>("bash");
    command->add_option("shell", *shell, "bash")->check(one_of({"bash"}))->capture_default_str();
    command->footer("Example:\n  stridor completion bash > ~/.local/share/bash-completion/completions/stridor");
    command->callback([&program, shell] { console::print(console::bash_completion(words_of(program).subcommands)); });
}

}  // namespace stridor::app
