#include "stridor/io/csv_opening.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

namespace stridor::io {

using base::csv_text::Facts;

void add_lines(Facts& facts, const std::string& canonical) {
    std::istringstream lines(canonical);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = std::min(line.find(" = "), line.size());
        facts.emplace_back(line.substr(0, equals), line.substr(std::min(equals + 3, line.size())));
    }
}

Facts csv_opening(std::string_view what, const parameters::Case& c) {
    Facts facts = base::csv_text::origin(what);
    if (!c.title.empty()) facts.emplace_back("title", c.title);
    return facts;
}

}  // namespace stridor::io
