#include "stridor/base/hash.hpp"

#include "support/property.hpp"

#include <gtest/gtest.h>

#include <string>
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

// FIPS 180-4's examples, and the million letters of its predecessor
TEST(Sha256, GivesThePublishedDigests) {
    EXPECT_EQ(sha256_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(sha256_text(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// coreutils' sha256sum of so many zero bytes: around the ends of a block and of its length field
TEST(Sha256, PadsEveryLengthRight) {
    EXPECT_EQ(sha256_text(std::string(55, '\0')), "02779466cdec163811d078815c633f21901413081449002f24aa3e80f0b88ef7");
    EXPECT_EQ(sha256_text(std::string(56, '\0')), "d4817aa5497628e7c77e6b606107042bbba3130888c5f47a375e6179be789fbb");
    EXPECT_EQ(sha256_text(std::string(64, '\0')), "f5a5fd42d16a20302798ef6ed309979b43003d2320d9f0e8ea9831a92759fb4b");
    EXPECT_EQ(sha256_text(std::string(65, '\0')), "98ce42deef51d40269d542f5314bef2c7468d401ad5d85168bfab4c0108f75f7");
}

RC_GTEST_PROP(Sha256, IsTheSameHoweverTheBytesArrive, (const std::string& head, const std::string& middle)) {
    const std::string tail(static_cast<std::size_t>(*support::whole_between(0, 200)), 'z');
    Sha256 hash;
    hash.add(head);
    hash.add(middle);
    hash.add(tail);
    RC_ASSERT(hash.text() == sha256_text(head + middle + tail));
}

}  // namespace
}  // namespace stridor::base
