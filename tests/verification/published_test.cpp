// Results that others published: each agrees within the precision of theirs.

#include "stridor/verification/published.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace stridor::verification {
namespace {

class Published : public testing::TestWithParam<std::size_t> {};

TEST_P(Published, AgreesWithinTheirPrecision) {
    const PublishedSystem& system = published_systems().at(GetParam());
    for (const HeldNumber& held : held(system).numbers)
        EXPECT_TRUE(held.agrees()) << system.source << ": " << held.published->quantity << ": theirs "
                                   << number_text(*held.published, held.published->theirs) << ", ours "
                                   << number_text(*held.published, held.ours);
}

INSTANTIATE_TEST_SUITE_P(Systems, Published, testing::Range(std::size_t{0}, published_systems().size()));

TEST(PublishedTable, SaysWhereEachToleranceComesFrom) {
    std::set<std::string> names;
    std::size_t rows = 0, measured = 0;
    for (const PublishedSystem& system : published_systems()) {
        EXPECT_FALSE(system.source.empty());
        for (const PublishedNumber& number : system.numbers) {
            ++rows;
            measured += system.origin == Origin::measurement ? 1U : 0U;
            EXPECT_FALSE(number.precision.empty()) << number.quantity;
            EXPECT_EQ(number.tolerance > 0.0, !is_word(number)) << number.quantity;
            EXPECT_TRUE(names.insert(std::string(system.file) + number.quantity).second) << number.quantity;
        }
    }
    EXPECT_GE(rows, 15U);
    EXPECT_GE(measured, 4U);
    for (const NotReproduced& each : not_reproduced())
        EXPECT_FALSE(each.why.empty()) << each.source;
}

TEST(PublishedTable, UsesEachCaseFileOfTheProject) {
    std::set<std::string> used;
    for (const PublishedSystem& system : published_systems())
        used.emplace(system.file);
    for (const auto& entry : std::filesystem::directory_iterator(STRIDOR_SOURCE_DIR "/cases/published"))
        EXPECT_EQ(used.count(entry.path().filename().string()), 1U) << entry.path();
}

TEST(PublishedTable, RefusesACaseThatIsNotThere) {
    EXPECT_THROW(case_text({.source = "", .system = "", .file = "none.toml", .assumed = "", .numbers = {}}), Error);
}

// a difference is judged, not only told
TEST(PublishedTable, TellsWhatDiffers) {
    PublishedNumber number = published_systems().front().numbers.front();
    number.theirs += 3.0 * number.tolerance;
    EXPECT_FALSE((HeldNumber{&number, published_systems().front().numbers.front().theirs}.agrees()));
    EXPECT_FALSE((HeldNumber{&number, std::nan("")}.agrees()));
}

}  // namespace
}  // namespace stridor::verification
