#include "stridor/base/packed_text.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

namespace stridor::base {
namespace {

TEST(PackedText, GivesBackWhatWasPutIn) {
    const double numbers[] = {0.0, -0.0, 0.1, 1e-310, -std::numeric_limits<double>::infinity(), 12345.678901234567};
    Packing packing;
    for (const double number : numbers)
        packing.add(number);
    packing.add(std::numeric_limits<double>::quiet_NaN());
    packing.add(std::uint64_t{18446744073709551615U});
    packing.add("a:b\n7:");
    packing.add("");
    const std::string text = packing.take();
    Unpacking unpacking(text);
    for (const double number : numbers)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(unpacking.number()), std::bit_cast<std::uint64_t>(number));
    EXPECT_TRUE(std::isnan(unpacking.number()));
    EXPECT_EQ(unpacking.count(), 18446744073709551615U);
    EXPECT_EQ(unpacking.words(), "a:b\n7:");
    EXPECT_FALSE(unpacking.is_complete());
    EXPECT_EQ(unpacking.words(), "");
    EXPECT_TRUE(unpacking.is_complete());
}

TEST(PackedText, OfAnotherKindIsNotComplete) {
    for (const char* text : {"", "3:abc", "1:7", "9:1", ":", "7", "18446744073709551615:1", "-1:5", "1:11:11:1"}) {
        Unpacking unpacking(text);
        unpacking.number();
        unpacking.number();
        EXPECT_FALSE(unpacking.is_complete()) << text;
    }
}

}  // namespace
}  // namespace stridor::base
