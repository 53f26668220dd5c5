#include "stridor/console/results/text_table.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace stridor::console;

TEST(TextTable, AlignsTextsToTheLeftAndNumbersToTheRight) {
    TextTable table{{left("phase", 8), right("slip", 8)}, "  "};
    add_row(table, "going", "38.9 %");
    add_row(table, "coming", 100);
    EXPECT_EQ(text_of(table), "  phase       slip\n  going     38.9 %\n  coming       100\n");
}

TEST(TextTable, GrowsWithItsWidestCellAndEndsNoLineInBlanks) {
    TextTable table{{left("name"), right("N"), left("note")}};
    add_row(table, "a long name", 7, "");
    add_row(table, "b", 12345, "x");
    add_row(table, "c");
    EXPECT_EQ(text_of(table), "name             N  note\na long name      7\nb            12345  x\nc\n");
}

TEST(TextTable, HasNoFirstLineWithoutHeadings) {
    TextTable table{{left("", 4), right("", 4)}};
    add_row(table, "a", 1);
    EXPECT_EQ(text_of(table), "a      1\n");
}

TEST(TextTable, CountsColumnsOfATerminal) {
    EXPECT_EQ(width_of("\u00b5m"), 2U);
    EXPECT_EQ(width_of("\u96d1\u97f3"), 4U);
    EXPECT_EQ(width_of("\033[1msqueal\033[0m"), 6U);
    EXPECT_EQ(width_of("\xff\033["), 3U);
    EXPECT_EQ(width_of(""), 0U);
}

TEST(TextTable, ShowsADashForWhatIsUnknown) {
    EXPECT_EQ(number_or_dash(428.5, "{:.1f} Hz"), "428.5 Hz");
    EXPECT_EQ(number_or_dash(std::numeric_limits<double>::quiet_NaN(), "{:.1f} Hz"), "-");
    EXPECT_EQ(number_or_dash(-std::numeric_limits<double>::infinity(), "{:.1f} dB"), "-");
}

}  // namespace
