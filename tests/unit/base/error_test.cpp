#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

#include <string>

namespace stridor::base {
namespace {

TEST(Error, ReadsAsProblemReasonSuggestionPlace) {
    const Error error(ErrorKind::input,
                      {"mu_d = 0.9 exceeds mu_s = 0.8", "kinetic friction may not be larger than static", "Swap them?"},
                      Place{"sweep.toml", 12, 0, ""});
    EXPECT_EQ(std::string(error.what()),
              "mu_d = 0.9 exceeds mu_s = 0.8 (kinetic friction may not be larger than static). Swap them? "
              "[sweep.toml:12]");
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.problem().suggestion, "Swap them?");
    ASSERT_TRUE(error.place().has_value());
    EXPECT_EQ(error.place()->line, 12);
}

TEST(Error, LeavesOutWhatIsEmpty) {
    EXPECT_STREQ(Error(ErrorKind::io, {"the disk is full", "", ""}).what(), "the disk is full");
    EXPECT_STREQ(Error(ErrorKind::io, {"the disk is full", "", "Free some space."}).what(),
                 "the disk is full. Free some space.");
    EXPECT_STREQ(Error(ErrorKind::io, {"the disk is full", "no byte left", ""}).what(),
                 "the disk is full (no byte left)");
    EXPECT_FALSE(Error(ErrorKind::io, {}).place().has_value());
}

TEST(Error, MayCarrySeveralComplaints) {
    const Error error = Error::of(ErrorKind::input, {{{"a is unknown", "", ""}, Place{"case.toml", 3, 1, ""}},
                                                     {{"b is missing", "it has no default", ""}, std::nullopt}});
    EXPECT_STREQ(error.what(), "a is unknown [case.toml:3:1]\nb is missing (it has no default)");
    EXPECT_EQ(error.problem().what, "a is unknown");
    EXPECT_EQ(error.place()->line, 3);
    EXPECT_EQ(error.complaints().size(), 2U);
    EXPECT_EQ(Error(ErrorKind::io, {"the disk is full", "", ""}).complaints().size(), 1U);
}

TEST(Place, IsDescribedAsFarAsItIsKnown) {
    EXPECT_EQ(describe({"case.toml", 3, 7, ""}), "case.toml:3:7");
    EXPECT_EQ(describe({"case.toml", 3, 0, ""}), "case.toml:3");
    EXPECT_EQ(describe({"--set", 0, 0, ""}), "--set");
    EXPECT_EQ(describe({"--set", 0, 4, ""}), "--set");
}

TEST(ExitCode, FollowsFromTheKind) {
    EXPECT_EQ(exit_code(ErrorKind::input), 2);
    EXPECT_EQ(exit_code(ErrorKind::numerical), 3);
    EXPECT_EQ(exit_code(ErrorKind::interrupted), 4);
    EXPECT_EQ(exit_code(ErrorKind::io), 5);
}

}  // namespace
}  // namespace stridor::base
