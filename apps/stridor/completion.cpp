#include "commands.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/ready_files.hpp"
#include "stridor/parameters/field.hpp"

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
            if (!option->get_group().empty()) words.push_back("--" + name);  // without a group: another spelling
    return words;
}

// keys of the field table with "=", for --set
std::vector<std::string> settings() {
    std::vector<std::string> words;
    for (const parameters::Field& field : parameters::fields())
        words.push_back(parameters::key_of(field) + "=");
    return words;
}

// keys of quantities with "=", for --over and --tolerance
std::vector<std::string> quantities() {
    std::vector<std::string> words = parameters::quantity_keys();
    for (std::string& word : words)
        word += "=";
    return words;
}

// options of each subcommand of a command that has them, as cases of the second word
std::string subcommand_cases(const CLI::App& command) {
    std::string cases;
    for (const CLI::App* each : command.get_subcommands({}))
        cases += "            " + each->get_name() + ") options=\"" + joined(options_of(*each)) + "\" ;;\n";
    return cases;
}

std::vector<std::string> names_of(const std::vector<const CLI::App*>& commands) {
    std::vector<std::string> names;
    for (const CLI::App* command : commands)
        names.push_back(command->get_name());
    return names;
}

// commands of two words; and what only the library itself knows, asked when it is needed
std::string nested_commands(const CLI::App& program) {
    std::string text;
    for (const CLI::App* command : program.get_subcommands({})) {
        if (command->get_subcommands({}).empty()) continue;
        text += "    if [[ ${COMP_WORDS[1]} == " + command->get_name() +
                " ]]; then\n"
                "        if ((COMP_CWORD == 2)); then\n"
                "            COMPREPLY=($(compgen -W \"" +
                joined(names_of(command->get_subcommands({}))) +
                " --help\" -- \"$word\"))\n"
                "            return\n"
                "        fi\n"
                "        case ${COMP_WORDS[2]} in\n" +
                subcommand_cases(*command) +
                "        esac\n"
                "    fi\n";
    }
    return text;
}

constexpr const char* library_words =
    "    if [[ ${COMP_WORDS[1]} == library && $word != -* ]]; then\n"
    "        local field=\"\" line place library=()\n"
    "        for ((place = 2; place < COMP_CWORD; place++)); do\n"
    "            [[ ${COMP_WORDS[place]} == --library ]] && library=(--library \"${COMP_WORDS[place+1]}\")\n"
    "        done\n"
    "        case $previous in\n"
    "            --system|--parts|--materials|--operation|--recorded|--denomination|--sensor|--author|--licence) "
    "field=${previous#--} ;;\n"
    "            --*) ;;\n"
    "            *) [[ ${COMP_WORDS[2]} == @(show|edit|judge|remove) ]] && field=id ;;\n"
    "        esac\n"
    "        if [[ -n $field ]]; then\n"
    "            COMPREPLY=()\n"
    "            while IFS= read -r line; do\n"
    "                [[ $line == \"$word\"* ]] && COMPREPLY+=(\"$(printf '%q' \"$line\")\")\n"
    "            done < <(\"${COMP_WORDS[0]}\" library words \"$field\" \"${library[@]}\" 2>/dev/null)\n"
    "            return\n"
    "        fi\n"
    "    fi\n";

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
           " help --help --version\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    if [[ $previous == --set ]]; then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(settings()) +
           "\" -- \"$word\"))\n"
           "        compopt -o nospace\n"
           "        return\n"
           "    fi\n"
           "    if [[ $previous == @(--over|--tolerance) && ${COMP_WORDS[1]} == @(advise|stability) ]]; then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(quantities()) +
           "\" -- \"$word\"))\n"
           "        compopt -o nospace\n"
           "        return\n"
           "    fi\n"
           "    if [[ ${COMP_WORDS[1]} == init && COMP_CWORD -eq 2 ]]; then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(io::ready_file_names()) +
           "\" -- \"$word\"))\n"
           "        return\n"
           "    fi\n"
           "    case ${COMP_WORDS[1]} in\n" +
           cases + "    esac\n" + nested_commands(program) + library_words +
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
    command->callback([&program, shell] { console::print(bash_script(program)); });
}

}  // namespace stridor::app
