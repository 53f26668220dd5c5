#include "stridor/console/completion.hpp"

#include "stridor/io/case/ready_files.hpp"
#include "stridor/parameters/field.hpp"

namespace stridor::console {

namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
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
std::string subcommand_cases(const CommandWords& command) {
    std::string cases;
    for (const CommandWords& each : command.subcommands)
        cases += "            " + each.name + ") options=\"" + joined(each.options) + "\" ;;\n";
    return cases;
}

std::vector<std::string> names_of(const std::vector<CommandWords>& commands) {
    std::vector<std::string> names;
    for (const CommandWords& command : commands)
        names.push_back(command.name);
    return names;
}

// commands of two words; and what only the library itself knows, asked when it is needed
std::string nested_commands(const std::vector<CommandWords>& commands) {
    std::string text;
    for (const CommandWords& command : commands) {
        if (command.subcommands.empty()) continue;
        text += "    if [[ ${COMP_WORDS[1]} == " + command.name +
                " ]]; then\n"
                "        if ((COMP_CWORD == 2)); then\n"
                "            COMPREPLY=($(compgen -W \"" +
                joined(names_of(command.subcommands)) +
                " --help\" -- \"$word\"))\n"
                "            return\n"
                "        fi\n"
                "        case ${COMP_WORDS[2]} in\n" +
                subcommand_cases(command) +
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

}  // namespace

std::string bash_completion(const std::vector<CommandWords>& commands) {
    std::string cases;
    for (const CommandWords& command : commands)
        cases += "        " + command.name + ") options=\"" + joined(command.options) + "\" ;;\n";
    return "# bash completion of stridor; made by `stridor completion bash`\n"
           "_stridor() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} options=\"\"\n"
           "    if ((COMP_CWORD == 1)); then\n"
           "        COMPREPLY=($(compgen -W \"" +
           joined(names_of(commands)) +
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
           cases + "    esac\n" + nested_commands(commands) + library_words +
           "    if [[ $word == -* ]]; then\n"
           "        COMPREPLY=($(compgen -W \"$options\" -- \"$word\"))\n"
           "    else\n"
           "        COMPREPLY=($(compgen -f -- \"$word\"))\n"
           "        compopt -o filenames\n"
           "    fi\n"
           "}\n"
           "complete -F _stridor stridor\n";
}

}  // namespace stridor::console
