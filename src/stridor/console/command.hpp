#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace stridor::console {

/// An option, or an argument named by its place, as help, manual page and completion describe it.
struct Argument {
    std::vector<std::string> names;      // "-o", "--output"; one without dashes is named by its place
    std::string value{};                 // the value of an option, "FILE"; empty: none
    std::string sentence{};              // its purpose
    std::vector<std::string> choices{};  // the only words allowed; empty: any
    std::vector<std::string> facts{};    // "default: 5", "needs --figure"
    bool is_required = false;
    bool is_repeated = false;  // may be given often, or with several words
};

/// A command of a program, or the program itself.
struct Command {
    std::string name;
    std::string sentence{};             // its purpose
    std::string footer{};               // sentences, and lines behind blanks: examples ("stridor ...") and tables
    std::vector<Argument> arguments{};  // by their place
    std::vector<Argument> options{};
    std::vector<Command> commands{};  // the second words that it needs; empty: none
};

/// Says whether a line of a footer is an example, to be copied: it stays one line.
bool is_example(const std::string& line);

/// Returns the sentence of an argument with its facts and with its choices, if the sentence does not name them all.
std::string full_sentence(const Argument& argument);

// Completions in a shell. The shells ask the program itself: it knows its commands, keys and files, and the words of a
// noise library.

/// The possible words in one place.
struct Completions {
    /// The names that the shell adds by itself.
    enum class Also { nothing, files, folders } also = Also::nothing;
    std::vector<std::pair<std::string, std::string>> words{};  // each with its meaning
};

/// Returns the possible completions of the last of the words behind the program's name.
Completions completions(const Command& program, const std::vector<std::string>& words);

/// Returns completions as the scripts read them: the shell's own additions, then a line "word<TAB>meaning" each.
std::string completion_lines(const Completions& completions);

/// The shells that have a script.
inline constexpr std::array shells{"bash", "zsh", "fish"};

/// Returns the script that lets one of these shells ask the program.
std::string completion_script(const std::string& shell);

/// Returns the manual page stridor(1) in the form of man(7): a section for each command of the program, with all of its
/// help, and the facts about all of them. Equal for equal versions: there is no date on it.
std::string manual_page(const Command& program, const std::string& version);

}  // namespace stridor::console
