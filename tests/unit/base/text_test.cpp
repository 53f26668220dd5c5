#include "stridor/base/text.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace stridor::base {
namespace {

constexpr std::array<std::string_view, 5> keys{"preload", "static_friction", "kinetic_friction", "mass", "step"};

TEST(NearestName, MendsOneOrTwoEdits) {
    EXPECT_EQ(nearest_name("preload", keys), "preload");
    EXPECT_EQ(nearest_name("perload", keys), "preload");  // neighbours swapped: one edit
    EXPECT_EQ(nearest_name("preloads", keys), "preload");
    EXPECT_EQ(nearest_name("reload", keys), "preload");
    EXPECT_EQ(nearest_name("preluad", keys), "preload");
    EXPECT_EQ(nearest_name("kinetic_fricton", keys), "kinetic_friction");
    EXPECT_EQ(nearest_name("statc_frction", keys), "static_friction");
}

TEST(NearestName, IsEmptyBeyondTwoEdits) {
    EXPECT_EQ(nearest_name("force", keys), "");
    EXPECT_EQ(nearest_name("prl", keys), "");
    EXPECT_EQ(nearest_name("", keys), "");
    EXPECT_EQ(nearest_name("preload", {}), "");
}

TEST(NearestName, NeverReplacesAWholeShortName) {
    constexpr std::array<std::string_view, 2> units{"m", "Hz"};
    EXPECT_EQ(nearest_name("q", units), "");
    EXPECT_EQ(nearest_name("hz", units), "Hz");
    EXPECT_EQ(nearest_name("qq", units), "");
}

TEST(NearestName, PrefersFewerEditsAndThenTheFirst) {
    constexpr std::array<std::string_view, 3> names{"slide", "slice", "slip"};
    EXPECT_EQ(nearest_name("slipp", names), "slip");
    EXPECT_EQ(nearest_name("slixe", names), "slide");
}

TEST(Shortest, IsWhatAPersonWouldWrite) {
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(1e-7), "1e-07");
    EXPECT_EQ(shortest(20.0), "20");
    EXPECT_EQ(shortest(-0.5), "-0.5");
    EXPECT_EQ(shortest(std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(shortest(-std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(shortest(std::numeric_limits<double>::infinity()), "inf");
}

RC_GTEST_PROP(Shortest, ReadsBackAsTheSameDouble, ()) {
    const double x = *support::signed_fraction();
    RC_ASSERT(std::strtod(shortest(x).c_str(), nullptr) == x);
    const double wide = std::ldexp(x, *support::whole_between(-900, 900));
    RC_ASSERT(std::strtod(shortest(wide).c_str(), nullptr) == wide);
}

TEST(Nesting, CountsBracketsOutsideOfQuotes) {
    EXPECT_EQ(nesting(""), 0U);
    EXPECT_EQ(nesting("7"), 0U);
    EXPECT_EQ(nesting("[]"), 1U);
    EXPECT_EQ(nesting(R"({"a": [1, {"b": []}], "c": [[2]]})"), 4U);
    EXPECT_EQ(nesting(R"(["[[[", "\"[[", "\\", [1]])"), 2U);
    EXPECT_EQ(nesting("]]][["), 2U);
    EXPECT_EQ(nesting(std::string(100000, '[')), 100000U);
}

TEST(Trimmed, DropsBlanksAtBothEndsOnly) {
    EXPECT_EQ(trimmed("  4 mm\t\r\n"), "4 mm");
    EXPECT_EQ(trimmed("4"), "4");
    EXPECT_EQ(trimmed(" \t "), "");
    EXPECT_EQ(trimmed(""), "");
}

TEST(Wrapped, BreaksAtBlanksOnly) {
    EXPECT_EQ(wrapped("one two three", {.columns = 8}), "one two\nthree");
    EXPECT_EQ(wrapped("one two three", {.columns = 7}), "one two\nthree");
    EXPECT_EQ(wrapped("one two three", {.columns = 6}), "one\ntwo\nthree");
    EXPECT_EQ(wrapped("contact.kinetic_friction is long", {.columns = 10}), "contact.kinetic_friction\nis long");
    EXPECT_EQ(wrapped("", {.columns = 10}), "");
}

TEST(Wrapped, BeginsAndIndentsWhereItIsTold) {
    EXPECT_EQ(wrapped("one two three", {.columns = 12, .first = 6, .indent = 2}), "one\n  two three");
    EXPECT_EQ(wrapped("one\ntwo", {.columns = 80, .first = 0, .indent = 2}), "one\n  two");
}

TEST(Wrapped, CountsCharactersAndNotBytes) {
    EXPECT_EQ(character_count("20 °C µm"), 8U);
    EXPECT_EQ(wrapped("°°°° °°°°", {.columns = 9}), "°°°° °°°°");
}

}  // namespace
}  // namespace stridor::base
