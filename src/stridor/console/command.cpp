#include "stridor/console/command.hpp"

#include "stridor/base/text.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/listing.hpp"
#include "stridor/parameters/fields/field.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <string_view>
#include <variant>

namespace stridor::console {

namespace {

#include "stridor/console/completion_scripts.inc"

using Meanings = std::vector<std::pair<std::string, std::string>>;

const Argument* find_option(const Command& command, const std::string& name) {
    for (const Argument& option : command.options)
        if (std::find(option.names.begin(), option.names.end(), name) != option.names.end()) return &option;
    return nullptr;
}

// bash parts words at "="
std::vector<std::string> whole_words(const std::vector<std::string>& words) {
    std::vector<std::string> whole;
    bool is_open = false;
    for (const std::string& word : words) {
        if (whole.empty() || !(is_open || word == "="))
            whole.push_back(word);
        else
            whole.back() += word;
        is_open = word == "=";
    }
    return whole.empty() ? std::vector<std::string>{""} : whole;
}

// the words that came behind a command, by what they are
struct Typed {
    std::size_t by_place = 0;          // how many words by their place
    std::vector<std::string> options;  // those that are there already
    const Argument* last = nullptr;    // the option that the next word belongs to; null: none
    std::string library;               // behind --library
};

Typed typed(const Command& command, const std::vector<std::string>& words, std::size_t from) {
    Typed typed;
    for (std::size_t k = from; k + 1 < words.size(); ++k) {
        const std::string& word = words[k];
        if (typed.last != nullptr) {
            if (typed.last->names.back() == "--library") typed.library = word;
            typed.last = nullptr;
        } else if (!word.starts_with('-') || word == "-") {
            ++typed.by_place;
        } else if (const Argument* option = find_option(command, word)) {
            if (!option->is_repeated) typed.options.push_back(option->names.back());
            if (!option->value.empty()) typed.last = option;
        }
    }
    return typed;
}

// keys with their sentences; of all fields for --set, else those of quantities
Meanings keys(bool is_setting) {
    Meanings words;
    for (const parameters::Field& field : parameters::fields())
        if (is_setting || std::holds_alternative<parameters::Quantity>(field.kind))
            words.emplace_back(parameters::key_of(field) + "=", field.sentence);
    return words;
}

Meanings library_words(const std::string& library, const std::string& field) {
    Meanings words;
    for (const std::string& word : noise_library::words_to_choose(library, field))
        words.emplace_back(word, "");
    return words;
}

// what may be the value of an option, or an argument by its place
Completions values(const Argument& argument, bool is_of_library, const std::string& library) {
    Completions found;
    for (const std::string& choice : argument.choices)
        found.words.emplace_back(choice, "");
    if (!found.words.empty()) return found;
    if (argument.value.starts_with("KEY")) return {.words = keys(argument.value == "KEY=VALUE")};
    if (is_of_library && argument.names.front() == "ids") return {.words = library_words(library, "id")};
    for (const noise_library::EntryField& field : noise_library::fields())
        if (is_of_library && argument.value == "TEXT" && argument.names.back() == noise_library::option_of(field))
            return {.words = library_words(library, std::string(field.name))};
    for (const char* folder : {"DIR", "FOLDER"})
        if (argument.value == folder) found.also = Completions::Also::folders;
    for (const char* file : {"FILE", "FILE.inp", "PATH", "CASE"})
        if (argument.value == file) found.also = Completions::Also::files;
    if (!argument.names.front().starts_with('-') && argument.value == "TEXT") found.also = Completions::Also::files;
    return found;
}

Completions options_of(const Command& command, const Typed& typed) {
    Completions found;
    for (const Argument& option : command.options)
        if (std::find(typed.options.begin(), typed.options.end(), option.names.back()) == typed.options.end())
            found.words.emplace_back(option.names.back(), option.sentence);
    return found;
}

// what may stand there, whatever its beginning
Completions all_completions(const Command& program, const std::vector<std::string>& words) {
    const bool is_help = words.size() > 1 && words.front() == "help";
    const Command* command = &program;
    std::size_t from = is_help ? 1 : 0;
    for (; from + 1 < words.size(); ++from) {
        const auto named = std::find_if(command->commands.begin(), command->commands.end(),
                                        [&](const Command& each) { return each.name == words[from]; });
        if (named == command->commands.end()) break;
        command = &*named;
    }
    const Typed before = typed(*command, words, from);
    const std::string& begun = words.back();
    const bool is_of_library = words.front() == "library";
    if (before.last != nullptr) return values(*before.last, is_of_library, before.library);
    if (const std::size_t sign = begun.find('='); begun.starts_with("--") && sign != std::string::npos) {
        Completions found;
        if (const Argument* option = find_option(*command, begun.substr(0, sign)))
            found = values(*option, is_of_library, before.library);
        for (auto& [word, meaning] : found.words)
            word.insert(0, begun.substr(0, sign + 1));
        return found;
    }
    if (begun.starts_with('-')) return options_of(*command, before);
    Completions found;
    for (const Command& each : command->commands)
        found.words.emplace_back(each.name, each.sentence);
    if (command == &program && !is_help) found.words.emplace_back("help", "Print the help of a command.");
    if (!found.words.empty() || command->arguments.empty() || is_help) return found;
    const std::size_t place = std::min(before.by_place, command->arguments.size() - 1);
    if (place < before.by_place && !command->arguments[place].is_repeated) return found;
    return values(command->arguments[place], is_of_library, before.library);
}

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

bool is_example(const std::string& line) {
    return line.starts_with("  ") && line.find("stridor ") != std::string::npos;
}

std::string full_sentence(const Argument& argument) {
    std::vector<std::string> parts{argument.sentence};
    const bool names_all = std::all_of(argument.choices.begin(), argument.choices.end(), [&](const std::string& word) {
        return argument.sentence.find(word) != std::string::npos;
    });
    if (!names_all) parts.push_back(base::listed(argument.choices));
    parts.insert(parts.end(), argument.facts.begin(), argument.facts.end());
    std::string text;
    for (const std::string& part : parts)
        text += (text.empty() ? "" : "; ") + part;
    return text;
}

Completions completions(const Command& program, const std::vector<std::string>& words) {
    const std::vector<std::string> whole = whole_words(words);
    Completions found = all_completions(program, whole);
    std::erase_if(found.words, [&](const auto& each) { return !each.first.starts_with(whole.back()); });
    return found;
}

std::string completion_lines(const Completions& completions) {
    constexpr std::array names{"nothing\n", "files\n", "folders\n"};
    std::string lines = names.at(static_cast<std::size_t>(completions.also));
    for (const auto& [word, meaning] : completions.words)
        if (word.find_first_of("\n\t") == std::string::npos) lines += word + "\t" + meaning + "\n";
    return lines;
}

std::string completion_script(const std::string& shell) {
    const auto text = [](const auto& bytes) { return std::string(std::begin(bytes), std::end(bytes)); };
    return shell == "zsh" ? text(stridor_zsh) : shell == "fish" ? text(stridor_fish) : text(stridor_bash);
}

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
