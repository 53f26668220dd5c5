#include "help.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "stridor/base/text.hpp"
#include "stridor/base/version.hpp"
#include "stridor/console/command.hpp"
#include "stridor/console/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <memory>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

namespace stridor::app {

namespace {

constexpr int widest = 100;  // longer lines are hard to read

// a line of a table: what is too long of its last column goes on below it
std::string table_line(const std::string& line, std::size_t columns) {
    const std::size_t gap = line.rfind("  ");
    const std::size_t column = gap == std::string::npos ? 0 : gap + 2;
    if (line.size() <= columns || column < 4) return line;
    const std::size_t indent = std::min(column, columns / 2);
    return line.substr(0, column) + base::wrapped(line.substr(column), {columns, column, indent});
}

// names of the options in a set that its command shows
std::vector<std::string> names_of(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options)
        names.push_back(option->get_name());
    return names;
}

// what stands behind the name of a type in words: of "{a,b}" the choices, of "INT in [0 - 9]" the range
void add_constraint(std::string_view constraint, console::Argument& argument) {
    if (constraint.starts_with('{')) {
        argument.choices = CLI::detail::split(std::string(constraint.substr(1, constraint.size() - 2)), ',');
        return;
    }
    const std::size_t from = constraint.find("in [") + 4;
    const std::size_t dash = constraint.find(" - ");
    argument.facts.push_back(std::string(constraint.substr(from, dash - from)) + " to " +
                             std::string(constraint.substr(dash + 3, constraint.size() - dash - 4)));
}

void add_value(const CLI::Option& option, console::Argument& argument) {
    const std::string type = option.get_type_name();
    // "TEXT:{a,b}" and "INT:INT in [0 - 9]", but FROM:TO is a name
    const std::size_t colon = type.find(':');
    const std::string_view behind = colon == std::string::npos ? "" : std::string_view(type).substr(colon + 1);
    const bool is_constraint = behind.starts_with('{') || behind.find(" in [") != std::string_view::npos;
    argument.value = type.substr(0, is_constraint ? colon : std::string::npos);
    if (is_constraint) add_constraint(behind, argument);
    if (!option.get_default_str().empty()) argument.facts.push_back("default: " + option.get_default_str());
    argument.is_repeated = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

console::Argument described(const CLI::Option& option) {
    console::Argument argument;
    for (const std::string& name : option.get_snames())
        argument.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames())
        argument.names.push_back("--" + name);
    if (option.get_positional()) argument.names = {option.get_name(true)};
    argument.sentence = option.get_description();
    argument.is_required = option.get_required();
    if (option.get_type_size() != 0) add_value(option, argument);
    if (option.get_required() && !option.get_positional()) argument.facts.emplace_back("required");
    if (!option.get_needs().empty()) argument.facts.push_back("needs " + base::listed(names_of(option.get_needs())));
    if (!option.get_excludes().empty())
        argument.facts.push_back("not with " + base::listed(names_of(option.get_excludes())));
    return argument;
}

struct CompletionOptions {
    std::string shell = "bash";
    std::vector<std::string> words;  // typed behind `stridor`: a shell asks what may be the last one
    std::string output;
};

}  // namespace

HelpFormatter::HelpFormatter()
    : columns_(static_cast<std::size_t>(std::min(widest, console::terminal_columns(STDOUT_FILENO)))) {}

std::string HelpFormatter::entry(const std::string& name, const std::string& sentence) const {
    const std::size_t column = columns_ < 60 ? 4 : 30;
    std::string text = "  " + name;
    if (text.size() + 1 < column)
        text.resize(column, ' ');
    else
        text = base::wrapped(name, {columns_, 2, 6}).insert(0, "  ") + "\n" + std::string(column, ' ');
    return text + base::wrapped(sentence, {columns_, column, column}) + "\n";
}

std::string HelpFormatter::make_usage(const CLI::App* command, std::string name) const {
    const std::string usage = Formatter::make_usage(command, std::move(name));
    return base::wrapped(base::trimmed(usage), {columns_, 0, 4}) + "\n";
}

std::string HelpFormatter::make_description(const CLI::App* command) const {
    return base::wrapped(command->get_description(), {columns_, 0, 0}) + "\n";
}

std::string HelpFormatter::make_footer(const CLI::App* command) const {
    std::string text;
    std::istringstream lines(command->get_footer());
    for (std::string line; std::getline(lines, line);)
        text += (console::is_example(line) ? line
                 : line.starts_with("  ")  ? table_line(line, columns_)
                                           : base::wrapped(line, {columns_, 0, 0})) +
                "\n";
    return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
    return entry(command->get_name(), command->get_description());
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
    const console::Argument argument = described(*option);
    std::string name = CLI::detail::join(argument.names, ",");
    if (!is_positional && !argument.value.empty()) name += " " + argument.value;
    return entry(name + (argument.is_repeated ? " ..." : ""), console::full_sentence(argument));
}

console::Command described(const CLI::App& app) {
    console::Command command{app.get_name(), app.get_description(), app.get_footer()};
    for (const CLI::Option* option : app.get_options())
        if (!option->get_group().empty())  // without a group: another spelling
            (option->get_positional() ? command.arguments : command.options).push_back(described(*option));
    for (const CLI::App* each : app.get_subcommands({}))
        command.commands.push_back(described(*each));
    return command;
}

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
