// Results keep their bits: in every build, by every instruction set.
// `golden_test --update-golden` writes the file anew.

#include "golden/results.hpp"
#include "golden/witness.hpp"
#include "stridor/integration/kernels/exact_kernel.hpp"
#include "stridor/sweep/results_version.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace stridor::golden {
namespace {

const std::filesystem::path source = STRIDOR_SOURCE_DIR;
const std::filesystem::path golden_file = source / "tests/golden/golden.txt";

Witness found(integration::InstructionSet set) {
    return witness_of(results(set), sweep::results_version);
}

class Golden : public testing::TestWithParam<integration::InstructionSet> {};

TEST_P(Golden, ResultsKeepTheirBits) {
    for (const std::string& sentence : contradictions(read_witness(golden_file), found(GetParam())))
        ADD_FAILURE() << sentence;
}

std::string name_of(const testing::TestParamInfo<integration::InstructionSet>& set) {
    constexpr std::array names{"Baseline", "Avx2", "Avx512"};
    return names.at(static_cast<std::size_t>(set.param));
}

INSTANTIATE_TEST_SUITE_P(By, Golden, testing::ValuesIn(integration::available_instruction_sets()), name_of);

TEST(GoldenVersion, IsAnnouncedInTheChangelog) {
    std::ifstream stream(source / "CHANGELOG.md");
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    EXPECT_TRUE(is_announced(text, sweep::results_version));
    EXPECT_FALSE(is_announced(text, sweep::results_version + 1));
    EXPECT_FALSE(is_announced("### Added\n- results generation 7\n", 7));
}

TEST(Witness, NoticesWhatMovedWithoutTheNumberAndTheOtherWayRound) {
    const Result one{"one", "a 0x1p+0\n", "1"};
    const Result other{"one", "a 0x1.0000000000001p+0\n", "1"};
    const Witness said = witness_of({{one}}, 3);
    EXPECT_TRUE(contradictions(said, said).empty());
    EXPECT_EQ(contradictions(said, witness_of({{other}}, 3)).size(), 1U);
    EXPECT_EQ(contradictions(said, witness_of({{one}}, 4)).size(), 1U);
    EXPECT_EQ(contradictions(said, witness_of({}, 3)).size(), 1U);
    EXPECT_EQ(contradictions(witness_of({}, 3), said).size(), 1U);
}

TEST(Witness, IsReadAsItWasWritten) {
    const support::ScratchFolder folder;
    const Witness said = witness_of({{Result{"one", "a 0x1p+0\n", "1 of 2"}}}, 3);
    write_witness(folder / "golden.txt", said);
    EXPECT_TRUE(contradictions(read_witness(folder / "golden.txt"), said).empty());
    EXPECT_EQ(read_witness(folder / "golden.txt").lines.at(0).extract, "1 of 2");
}

// a hash may move only together with the number
int update() {
    const Witness now = found(integration::InstructionSet::baseline);
    if (std::filesystem::exists(golden_file)) {
        const Witness said = read_witness(golden_file);
        const bool moved = std::any_of(now.lines.begin(), now.lines.end(), [&](const Witness::Line& line) {
            return std::any_of(said.lines.begin(), said.lines.end(), [&](const Witness::Line& before) {
                return before.name == line.name && before.hash != line.hash;
            });
        });
        if (moved && said.results_version == now.results_version) {
            for (const std::string& sentence : contradictions(said, now))
                std::cerr << sentence << '\n';
            std::cerr
                << "results moved: raise results_version (src/stridor/sweep/results_version.hpp) and say what and "
                   "why in CHANGELOG.md under \"Results changed\"\n";
            return 1;
        }
    }
    write_witness(golden_file, now);
    return 0;
}

}  // namespace
}  // namespace stridor::golden

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (argc > 1 && std::string(argv[1]) == "--update-golden") return stridor::golden::update();
    return RUN_ALL_TESTS();
}
