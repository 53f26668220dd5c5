#include "stridor/base/hash.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace stridor::base {
namespace {

// vectors published with the algorithm (Fowler, Noll, Vo: FNV-1a, 64 bit)
TEST(Fnv1a, GivesThePublishedVectors) {
    EXPECT_EQ(fnv1a(""), 0xcbf29ce484222325U);
    EXPECT_EQ(fnv1a("a"), 0xaf63dc4c8601ec8cU);
    EXPECT_EQ(fnv1a("b"), 0xaf63df4c8601f1a5U);
    EXPECT_EQ(fnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(Fnv1a, TakesBytesAsUnsignedAndZerosAsBytes) {
    EXPECT_EQ(fnv1a("\xff"), (0xcbf29ce484222325U ^ 0xffU) * 0x100000001b3U);
    EXPECT_NE(fnv1a(std::string_view("a\0", 2)), fnv1a("a"));
}

TEST(HashText, IsSixteenDigitsWithLeadingZeros) {
    EXPECT_EQ(hash_text("a"), "af63dc4c8601ec8c");
    EXPECT_EQ(hash_text(""), "cbf29ce484222325");
    EXPECT_EQ(hash_text("10 N"), "0d4beff0f85feb66");
}

}  // namespace
}  // namespace stridor::base
