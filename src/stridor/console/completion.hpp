#pragma once

#include "stridor/console/command.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

/// What a shell may put where somebody types. The shells ask the program itself: it knows its commands, keys and files,
/// and the words of a noise library.
namespace stridor::console {

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

}  // namespace stridor::console
