#include "commands.hpp"
#include "stridor/parameters/field.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace stridor::app {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

std::vector<std::string> options_of(const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            words.push_back("--" + name);
    return words;
}

// keys of the field table with "=", for --set
std::vector<std::string> settings() {
    std::vector<std::string> words;
    for (const parameters::Field& field : parameters::fields())
        words.push_back(parameters::key_of(field) + "=");
    return words;
}

std::string bash_script(const CLI::App& program) {
    std::vector<std::string> commands;
    std::string cases;
    for (const CLI::App* command : program.get_subcommands({})) {
        commands.push_back(command->get_name());
        cases += "        " + command->get_name() + ") options=\"" + joined(options_of(*command)) + "\" ;;\n";
    }
    return "# bash completion of stridor; made by `stridor completion bash`\n"
           "_stridor() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=\"\"\n"
           "    if ((COMP_CWORD == 1)); then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(commands) +
           " --help --version\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    if [[ $previous == --set ]]; then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(settings()) +
           "\" -- \"$word\"))\n"
           "        compopt -o nospace\n"
           "        return\n"
           "    fi\n"
           "    if [[ ${COMP_WORDS[1]} == init && COMP_CWORD -eq 2 ]]; then\n"
           "        COMPREPLY=($(compgen -W \"squeal squeak creak quiet noise-chart rate-map schema\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases +
           "    esac\n"
           "    if [[ $word == -* ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
           "    else\n"
           "        COMPREPLY=($(compgen -f -- \"$word\"))\n"
           "        compopt -o filenames\n"
           "    fi\n"
           "}\n"
           "complete -F _stridor stridor\n";
}

}  // namespace

void add_completion(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("completion", "Print the shell completion script (bash; zsh through bashcompinit).");
    auto shell = std::make_shared<std::string>("bash");
    command->add_option("shell", *shell, "bash")->check(CLI::IsMember({"bash"}))->capture_default_str();
    command->footer("Example:\n  stridor completion bash > ~/.local/share/bash-completion/completions/stridor");
    command->callback([&program, shell] { print(bash_script(program)); });
}

}  // namespace stridor::app
