#include "fuzz/targets/targets.hpp"
#include "support/counter_random.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace stridor::fuzz {
namespace {

std::vector<std::string> corpus(std::string_view target) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = std::filesystem::path(STRIDOR_SOURCE_DIR) / "tests/fuzz/corpus" / target;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<std::string> texts;
    for (const std::filesystem::path& file : files) {
        std::ifstream stream(file, std::ios::binary);
        texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
    }
    return texts;
}

// the corpus itself, and what is a few bytes away from it
TEST(FuzzTargets, EndWellOnTheCorpusAndAroundIt) {
    const support::Runs runs = support::runs(300);
    for (const Target& target : targets) {
        const std::vector<std::string> seeds = corpus(target.name);
        ASSERT_FALSE(seeds.empty()) << target.name;
        for (const std::string& seed : seeds)
            target.run(seed);
        for (std::uint64_t run = runs.first; run < runs.first + runs.count; ++run) {
            support::CounterRandom random(run);
            std::string text = seeds[random.below(seeds.size())];
            for (std::size_t edit = 0; edit < 3 && !text.empty(); ++edit) {
                const std::size_t at = random.below(text.size());
                if (random.one_in(3))
                    text.erase(at, random.below(8));
                else
                    text[at] = static_cast<char>(random.next());
            }
            target.run(text);
        }
    }
}

}  // namespace
}  // namespace stridor::fuzz
