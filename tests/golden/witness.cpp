#include "golden/witness.hpp"

#include "stridor/base/hash.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace stridor::golden {

Witness witness_of(std::span<const Result> results, int results_version) {
    Witness witness{results_version, {}};
    for (const Result& result : results)
        witness.lines.push_back({result.name, base::hash_text(result.values), result.extract});
    return witness;
}

Witness read_witness(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("there is no " + file.string());
    Witness witness;
    for (std::string text; std::getline(stream, text);) {
        if (text.empty() || text.front() == '#') continue;
        std::istringstream words(text);
        Witness::Line line;
        words >> line.name >> line.hash;
        std::getline(words >> std::ws, line.extract);
        if (line.hash.empty()) throw std::runtime_error("a line has a name and a hash, in " + file.string());
        if (line.name == "results_version")
            witness.results_version = std::stoi(line.hash);
        else
            witness.lines.push_back(line);
    }
    return witness;
}

void write_witness(const std::filesystem::path& file, const Witness& witness) {
    std::ofstream stream(file);
    stream << "# Results with all their bits: name, hash of the values (tests/golden/results.cpp), what a reader looks "
              "at first.\n"
              "# Written by `golden_test --update-golden`, which wants results_version raised where a hash moves.\n"
           << "results_version " << witness.results_version << '\n';
    for (const Witness::Line& line : witness.lines)
        stream << fmt::format("{} {} {}\n", line.name, line.hash, line.extract);
    if (!stream.flush()) throw std::runtime_error("cannot write " + file.string());
}

std::vector<std::string> contradictions(const Witness& said, const Witness& found) {
    std::vector<std::string> all;
    if (said.results_version != found.results_version)
        all.push_back(fmt::format("results_version is {}, and the hashes are those of {}: run --update-golden",
                                  found.results_version, said.results_version));
    const auto find = [](const Witness& witness, const std::string& name) {
        return std::find_if(witness.lines.begin(), witness.lines.end(),
                            [&](const auto& line) { return line.name == name; });
    };
    for (const Witness::Line& now : found.lines) {
        const auto before = find(said, now.name);
        if (before == said.lines.end())
            all.push_back(now.name + " is new: run --update-golden");
        else if (before->hash != now.hash)
            all.push_back(fmt::format("{} moved: was \"{}\", is \"{}\"", now.name, before->extract, now.extract));
    }
    for (const Witness::Line& before : said.lines)
        if (find(found, before.name) == found.lines.end()) all.push_back(before.name + " is gone");
    return all;
}

bool is_announced(const std::string& changelog, int results_version) {
    const std::string words = fmt::format("results generation {}", results_version);
    std::istringstream stream(changelog);
    bool is_inside = false;
    for (std::string line; std::getline(stream, line);) {
        if (line.starts_with('#')) is_inside = line == "### Results changed";
        if (is_inside && line.find(words) != std::string::npos) return true;
    }
    return false;
}

}  // namespace stridor::golden
