#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace stridor::console {

/// An option, or an argument that its place names, as help, manual page and completion tell it.
struct Argument {
    std::vector<std::string> names;      // "-o", "--output"; one without dashes is named by its place
    std::string value{};                 // what an option takes, "FILE"; empty: nothing
    std::string sentence{};              // what it is for
    std::vector<std::string> choices{};  // the only words that it may be; empty: any
    std::vector<std::string> facts{};    // "default: 5", "needs --figure"
    bool is_required = false;
    bool is_repeated = false;  // may be given often, or with several words
};

/// A command of a program, or the program itself.
struct Command {
    std::string name;
    std::string sentence{};             // what it does
    std::string footer{};               // sentences, and lines behind blanks: examples ("stridor ...") and tables
    std::vector<Argument> arguments{};  // by their place
    std::vector<Argument> options{};
    std::vector<Command> commands{};  // the second words that it wants; empty: none
};

/// Is a line of a footer an example? It is there to be copied, and stays one line.
bool is_example(const std::string& line);

/// Returns the sentence of an argument with its facts and, where it does not name them all, its choices.
std::string full_sentence(const Argument& argument);

// What a shell may put where somebody types. The shells ask the program itself: it knows its commands, keys and files,
// and the words of a noise library.

/// What may stand in one place.
struct Completions {
    /// What the shell adds of its own.
    enum class Also { nothing, files, folders } also = Also::nothing;
    std::vector<std::pair<std::string, std::string>> words{};  // each with what it means
};

/// Returns what may stand in place of the last of the words behind the program's name, of which it is the beginning.
Completions completions(const Command& program, const std::vector<std::string>& words);

/// Returns completions as the scripts read them: what the shell adds, then a line "word<TAB>meaning" each.
std::string completion_lines(const Completions& completions);

/// The shells that have a script.
inline constexpr std::array shells{"bash", "zsh", "fish"};

/// Returns the script that lets one of these shells ask the program.
std::string completion_script(const std::string& shell);

/// Returns the manual page stridor(1) as man(7) describes it: a section for each command of the program, with all that
/// its help says, and what holds for all of them. Equal for equal versions: there is no date on it.
std::string manual_page(const Command& program, const std::string& version);

}  // namespace stridor::console
