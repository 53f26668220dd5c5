#include "stridor/base/packed_bytes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace stridor::base {
namespace {

enum class Tone { low, high };

TEST(PackedBytes, GiveBackWhatWasPutIn) {
    const double numbers[] = {
        0.0, -0.0, 0.1, 1e-310, -std::numeric_limits<double>::infinity(), std::bit_cast<double>(0x7ff8000000000123U)};
    Packing packing;
    for (const double number : numbers)
        packing.add(number);
    packing.add(std::uint64_t{18446744073709551615U});
    packing.add("a:b\n7:");
    packing.add(Tone::high);
    packing.add("");
    const std::string bytes = packing.take();
    Unpacking unpacking(bytes);
    for (const double number : numbers)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(unpacking.number()), std::bit_cast<std::uint64_t>(number));
    EXPECT_EQ(unpacking.count(), 18446744073709551615U);
    EXPECT_EQ(unpacking.words(), "a:b\n7:");
    EXPECT_EQ(unpacking.kind<Tone>(2), Tone::high);
    EXPECT_FALSE(unpacking.is_complete());
    EXPECT_EQ(unpacking.words(), "");
    EXPECT_TRUE(unpacking.is_complete());
}

TEST(PackedBytes, ThatEndTooSoonAreNotComplete) {
    Packing packing;
    packing.add(0.5);
    packing.add("words");
    packing.add(Tone::low);
    const std::string bytes = packing.take();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        Unpacking unpacking(std::string_view(bytes).substr(0, size));
        unpacking.number();
        unpacking.words();
        unpacking.kind<Tone>(2);
        EXPECT_FALSE(unpacking.is_complete()) << size;
        EXPECT_FALSE(unpacking.is_good()) << size;
    }
}

TEST(PackedBytes, OfAnotherKindAreNotComplete) {
    Packing packing;
    packing.add(Tone::high);
    const std::string bytes = packing.take();
    Unpacking unpacking(bytes);
    EXPECT_EQ(unpacking.kind<Tone>(1), Tone::low);
    EXPECT_FALSE(unpacking.is_complete());
    // a length beyond all that is there
    const std::string length(8, '\xff');
    Unpacking words(length);
    EXPECT_EQ(words.words(), "");
    EXPECT_FALSE(words.is_good());
}

TEST(Base64, IsAsTheStandardSays) {
    // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

}  // namespace
}  // namespace stridor::base
