#include "stridor/io/chart/range_text.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

TEST(RangeText, IsAKeyAndWhatStandsBetweenColons) {
    const auto text = split_range(" mu_d = 0.2 : 0.8 : 30 ");
    ASSERT_TRUE(text.has_value());
    EXPECT_EQ(text->key, "mu_d");
    EXPECT_EQ(text->parts, (std::vector<std::string_view>{"0.2", "0.8", "30"}));
}

TEST(RangeText, KeepsEmptyParts) {
    EXPECT_EQ(split_range("mu_d=")->parts, std::vector<std::string_view>{""});
    EXPECT_EQ(split_range("mu_d=:1:")->parts, (std::vector<std::string_view>{"", "1", ""}));
}

TEST(RangeText, IsNoneWithoutAnEqualsSign) {
    EXPECT_FALSE(split_range("mu_d").has_value());
    EXPECT_FALSE(split_range("").has_value());
}

TEST(RangeEnds, TakeTheUnitOfTheLastEnd) {
    const RangeEnds ends = read_range_ends("1", "40 kN", "N");
    EXPECT_EQ(ends.from, 1000.0);
    EXPECT_EQ(ends.to, 40000.0);
}

TEST(RangeEnds, MayEachHaveTheirOwn) {
    const RangeEnds ends = read_range_ends("+500 mN", "2 N", "N");
    EXPECT_EQ(ends.from, 0.5);
    EXPECT_EQ(ends.to, 2.0);
}

TEST(RangeEnds, WithoutUnitsAreInTheOneAskedFor) {
    const RangeEnds ends = read_range_ends("-30", "80", "degC");
    EXPECT_EQ(ends.from, -30.0);
    EXPECT_EQ(ends.to, 80.0);
}

TEST(RangeEnds, RefuseWhatIsNoQuantity) {
    EXPECT_THROW(read_range_ends("", "40 N", "N"), Error);
    EXPECT_THROW(read_range_ends("1", "", "N"), Error);
    EXPECT_THROW(read_range_ends("1", "40 mm", "N"), Error);
}

TEST(RangePoints, AreWholeAndWithinBounds) {
    EXPECT_EQ(read_points("2", 100), 2);
    EXPECT_EQ(read_points("100", 100), 100);
    for (const char* text : {"1", "101", "-3", "3.5", "3 ", "", "many", "99999999999"})
        EXPECT_FALSE(read_points(text, 100).has_value()) << text;
}

}  // namespace
}  // namespace stridor::io
