#pragma once

#include <string>
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

}  // namespace stridor::console
