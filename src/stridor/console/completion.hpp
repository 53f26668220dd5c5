#pragma once

#include <string>
#include <vector>

namespace stridor::console {

/// What can be typed after a command.
struct CommandWords {
    std::string name;
    std::vector<std::string> options{};  // "--json"
    std::vector<CommandWords> subcommands{};
};

/// The completion script for bash of a program with these commands. Keys, quantities and ready files come from their
/// tables; words of a noise library are asked of the program when they are needed.
std::string bash_completion(const std::vector<CommandWords>& commands);

}  // namespace stridor::console
