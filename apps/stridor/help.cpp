#include "help.hpp"

#include "stridor/base/text.hpp"
#include "stridor/console/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <sstream>
#include <string_view>

namespace stridor::app {

namespace {

constexpr int widest = 100;  // longer lines are hard to read

// "{a,b}" and "INT in [0 - 9]" behind the name of a type, in words
std::string constraint_text(std::string_view constraint) {
    if (constraint.starts_with('{')) {
        std::string choices;
        for (const char c : constraint.substr(1, constraint.size() - 2))
            choices += c == ',' ? std::string(", ") : std::string(1, c);
        return choices;
    }
    const std::size_t from = constraint.find("in [");
    const std::size_t dash = constraint.find(" - ");
    if (from == std::string_view::npos || dash == std::string_view::npos) return std::string(constraint);
    const std::string_view low = constraint.substr(from + 4, dash - from - 4);
    const std::string_view high = constraint.substr(dash + 3, constraint.size() - dash - 4);
    return std::string(low) + " to " + std::string(high);
}

// a line of a table: what is too long of its last column goes on below it
std::string table_line(const std::string& line, std::size_t columns) {
    const std::size_t gap = line.rfind("  ");
    const std::size_t column = gap == std::string::npos ? 0 : gap + 2;
    if (line.size() <= columns || column < 4) return line;
    const std::size_t indent = std::min(column, columns / 2);
    return line.substr(0, column) + base::wrapped(line.substr(column), {columns, column, indent});
}

// an example is one line, whatever its length: it is there to be copied
bool is_example(const std::string& line) {
    return line.find("stridor ") != std::string::npos;
}

std::string names_of(const std::set<CLI::Option*>& options) {
    std::string names;
    for (const CLI::Option* option : options)
        names += (names.empty() ? "" : ", ") + option->get_name();
    return names;
}

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
        text += (is_example(line) && line.starts_with("  ") ? line
                 : line.starts_with("  ")                   ? table_line(line, columns_)
                                                            : base::wrapped(line, {columns_, 0, 0})) +
                "\n";
    return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
    return entry(command->get_name(), command->get_description());
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
    std::string name = option->get_name(is_positional, !is_positional);
    std::string sentence = option->get_description();
    const auto add = [&](const std::string& fact) { sentence += (sentence.empty() ? "" : "; ") + fact; };
    if (option->get_type_size() != 0) {
        const std::string type = option->get_type_name();
        // "TEXT:{a,b}" and "INT:INT in [0 - 9]", but FROM:TO is a name
        const std::size_t constraint = type.find_first_of(':');
        const std::string_view behind =
            constraint == std::string::npos ? "" : std::string_view(type).substr(constraint + 1);
        const std::size_t colon =
            behind.starts_with('{') || behind.find(" in [") != std::string_view::npos ? constraint : std::string::npos;
        if (!is_positional) name += " " + type.substr(0, colon);
        if (option->get_expected_max() >= CLI::detail::expected_max_vector_size) name += " ...";
        if (colon != std::string::npos) add(constraint_text(std::string_view(type).substr(colon + 1)));
        if (!option->get_default_str().empty()) add("default: " + option->get_default_str());
        if (option->get_required() && !is_positional) add("required");
    }
    if (!option->get_needs().empty()) add("needs " + names_of(option->get_needs()));
    if (!option->get_excludes().empty()) add("not with " + names_of(option->get_excludes()));
    return entry(name, sentence);
}

}  // namespace stridor::app
