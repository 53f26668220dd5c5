#include "stridor/noise_library/listing.hpp"

#include "stridor/noise_library/sensitivity.hpp"
#include "support/error_text.hpp"
#include "unit/noise_library/library_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::noise_library {
namespace {

using support::thrown_by;

EntryExtent extent_of_columns(const std::string& columns) {
    return extent_for(parse_columns(columns));
}

TEST(Listing, ReadsNoMoreThanItsColumnsShow) {
    EXPECT_EQ(extent_of_columns(usual_columns), EntryExtent::summary);
    EXPECT_EQ(extent_of_columns("id,level"), EntryExtent::figures);
    EXPECT_EQ(extent_of_columns("id,case"), EntryExtent::whole);
}

TEST(Listing, NamesTheNearestField) {
    EXPECT_EQ(field_named("preload").name, "preload");
    EXPECT_TRUE(thrown_by([] { field_named("prelaod"); }).says("preload"));
}

TEST_F(LibraryFile, OffersUsualWordsWithoutALibrary) {
    EXPECT_FALSE(words_to_choose(file_, "recorded").empty());
    EXPECT_TRUE(words_to_choose(file_, "id").empty());
    EXPECT_TRUE(figures_in(file_).empty());
}

TEST_F(LibraryFile, KnowsTheUnitOfWhatIsLaidOver) {
    Library library = open();
    EXPECT_EQ(unit_over(library, "preload"), "N");
    EXPECT_TRUE(thrown_by([&] { unit_over(library, "system"); }).says("it is words"));
    EXPECT_TRUE(thrown_by([&] { sensitivity_in(library, {}, {}); }).says("no entry meets the conditions"));
}

TEST(ParsedQuery, SortsFallingBehindAMinus) {
    const std::vector<std::string> conditions{"preload > 10 N and system = brake", "humidity < 50"};
    const Query query = parse_query(conditions, "rubber  glass", "-preload");
    EXPECT_EQ(query.conditions.size(), 3U);
    EXPECT_EQ(query.words, (std::vector<std::string>{"rubber", "glass"}));
    EXPECT_EQ(query.sort, "preload");
    EXPECT_EQ(query.direction, SortOrder::falling);
    EXPECT_EQ(parse_query({}, "", "preload").direction, SortOrder::rising);
}

TEST(EntryTexts, SetAndClearFiguresAndCases) {
    Entry entry;
    set_figure_from_text(entry, "level=62 dB");
    EXPECT_EQ(number_of(entry, "level"), 62.0);
    set_figure_from_text(entry, "level=unknown");
    EXPECT_TRUE(entry.figures.empty());
    set_case(entry, "[contact]\n");
    EXPECT_EQ(entry.recorded, "simulation");
    entry.recorded = "rig";
    set_case(entry, "[contact]\n");
    EXPECT_EQ(entry.recorded, "rig");
}

}  // namespace
}  // namespace stridor::noise_library
