#pragma once

#include "golden/results.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace stridor::golden {

/// What a file of golden hashes says.
struct Witness {
    struct Line {
        std::string name;
        std::string hash;
        std::string extract;
    };
    int results_version = 0;
    std::vector<Line> lines{};
};

/// What the file would say of these results.
Witness witness_of(std::span<const Result> results, int results_version);

/// Throws `std::runtime_error` if there is no file, or it is none of ours.
Witness read_witness(const std::filesystem::path& file);
void write_witness(const std::filesystem::path& file, const Witness& witness);

/// What contradicts the file, a sentence each; empty: nothing does.
///
/// A hash that moved while the number stayed is one, a number that moved while the file stayed another, and so is a
/// result that is new or gone.
std::vector<std::string> contradictions(const Witness& said, const Witness& found);

/// Does a changelog have a section "Results changed" that names this generation of results ("results generation 3")?
bool is_announced(const std::string& changelog, int results_version);

}  // namespace stridor::golden
