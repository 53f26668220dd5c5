#include "stridor/storage/command_cache.hpp"

#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace stridor::storage {
namespace {

TEST(CommandCache, GoesOnUntilItIsFinished) {
    const support::ScratchFolder folder;
    ::setenv("XDG_CACHE_HOME", folder.path().c_str(), 1);
    std::string told;
    const auto note = [&](const std::string& sentence) { told += sentence + "\n"; };
    {
        CommandCache cache("hear", "this", note);
        ASSERT_NE(cache.results(), nullptr);
        cache.results()->keep(3, "creak");
    }
    EXPECT_EQ(told, "");
    {
        CommandCache other("hear", "that", note);  // other work is not mixed with it
        EXPECT_EQ(other.results()->found(), 0U);
        other.finish();
    }
    CommandCache again("hear", "this", note);
    EXPECT_EQ(again.results()->find(3), "creak");
    EXPECT_EQ(told, "goes on from 1 results of a run that was stopped\n");
    again.finish();
    EXPECT_TRUE(std::filesystem::is_empty(folder.path() / "stridor"));
}

TEST(CommandCache, IsDoneWithoutWhereNothingCanBeKept) {
    ::setenv("XDG_CACHE_HOME", "/dev/null", 1);
    std::string told;
    CommandCache cache("hear", "this", [&](const std::string& sentence) { told = sentence; });
    EXPECT_EQ(cache.results(), nullptr);
    EXPECT_NE(told.find("nothing is kept"), std::string::npos);
    cache.finish();
}

}  // namespace
}  // namespace stridor::storage
