#include "stridor/console/command.hpp"

#include "stridor/base/text.hpp"

#include <algorithm>

namespace stridor::console {

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

}  // namespace stridor::console
