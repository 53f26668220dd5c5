#include "stridor/console/manual.hpp"

#include <array>
#include <iterator>
#include <sstream>
#include <string_view>
#include <utility>

namespace stridor::console {

namespace {

#include "stridor/console/manual_page.inc"

// text as roff shows it, sign by sign; what stands between ` is bold
std::string roff(std::string_view text) {
    constexpr std::string_view signs = "\\-'^~";
    constexpr std::array names{"\\(rs", "\\-", "\\(aq", "\\(ha", "\\(ti"};
    std::string shown;
    bool is_bold = false;
    for (const char c : text)
        if (c == '`')
            shown += (is_bold = !is_bold) ? "\\fB" : "\\fP";
        else if (const std::size_t sign = signs.find(c); sign != std::string_view::npos)
            shown += names.at(sign);
        else
            shown += c;
    return shown.starts_with('.') ? "\\&" + shown : shown;
}

std::string bold(std::string_view text) {
    return "\\fB" + roff(text) + "\\fP";
}

std::string italic(std::string_view text) {
    return "\\fI" + roff(text) + "\\fP";
}

std::string entry(const std::string& tag, std::string_view sentence) {
    return ".TP\n" + tag + "\n" + roff(sentence) + "\n";
}

// "  name  5 Hz  what it is": the last column is a sentence on those before it
std::string table_row(const std::string& line) {
    const std::size_t gap = line.rfind("  ");
    std::string tag;
    std::istringstream columns(line.substr(0, gap));
    for (std::string word; columns >> word;)
        tag += (tag.empty() ? "" : " ") + word;
    return entry(bold(tag), line.substr(gap + 2));
}

std::string footer(const std::string& text) {
    std::string page;
    bool was_example = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line); was_example = is_example(line)) {
        if (was_example && !is_example(line)) page += ".EE\n.RE\n";
        if (line.empty()) continue;
        if (is_example(line))
            page += (was_example ? "" : ".PP\n.RS\n.EX\n") + roff(line.substr(2)) + "\n";
        else
            page += line.starts_with("  ") ? table_row(line) : ".PP\n" + roff(line) + "\n";
    }
    return page + (was_example ? ".EE\n.RE\n" : "");
}

// "-o, --output FILE"
std::string tag_of(const Argument& argument) {
    std::string tag;
    const bool is_option = argument.names.front().starts_with('-');
    for (const std::string& name : argument.names)
        tag += (tag.empty() ? "" : ", ") + (is_option ? bold(name) : italic(name));
    if (is_option && !argument.value.empty()) tag += " " + italic(argument.value);
    return tag + (argument.is_repeated ? " ..." : "");
}

std::string command_section(const Command& command, const std::string& before) {
    const std::string name = before.empty() ? command.name : before + " " + command.name;
    std::string page = ".SS " + roff(name);
    for (const Argument& argument : command.arguments)
        page += argument.is_required ? " " + tag_of(argument) : " \\fR[\\fP" + tag_of(argument) + "\\fR]\\fP";
    page += "\n" + roff(command.sentence) + "\n";
    for (const Argument& argument : command.arguments)
        page += entry(tag_of(argument), full_sentence(argument));
    for (const Argument& option : command.options)
        if (option.names.back() != "--help") page += entry(tag_of(option), full_sentence(option));
    page += footer(command.footer);
    for (const Command& each : command.commands)
        page += command_section(each, name);
    return page;
}

}  // namespace

std::string manual_page(const Command& program, const std::string& version) {
    std::string commands = footer(program.footer.substr(0, program.footer.find("\n\n"))) + ".SH COMMANDS\n";
    for (const Command& command : program.commands)
        commands += command_section(command, "");
    std::string page(std::begin(stridor_1_in), std::end(stridor_1_in));
    for (const auto& [mark, text] : {std::pair(std::string("@VERSION@"), version), {"@COMMANDS@\n", commands}})
        page.replace(page.find(mark), mark.size(), text);
    return page;
}

}  // namespace stridor::console
