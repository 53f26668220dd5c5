#include "stridor/storage/kept_results.hpp"

#include "stridor/base/error.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace stridor::storage {
namespace {

class KeptResultsFile : public testing::Test {
protected:
    std::filesystem::path file() const { return folder_ / "kept.sqlite"; }

    ErrorKind refusal(const std::string& what) const {
        try {
            const KeptResults kept(file(), what, "cache");
        } catch (const Error& error) {
            return error.kind();
        }
        ADD_FAILURE() << "was opened";
        return ErrorKind::input;
    }

    support::ScratchFolder folder_;
};

TEST_F(KeptResultsFile, GivesBackWhatWasKept) {
    {
        KeptResults kept(file(), "study", "cache");
        EXPECT_EQ(kept.found(), 0U);
        kept.keep(7, "seven:\n7");
        kept.keep(0, "");
        EXPECT_FALSE(kept.find(7)) << "only what was there when it was opened";
    }
    const KeptResults again(file(), "study", "cache");
    EXPECT_EQ(again.found(), 2U);
    EXPECT_EQ(again.find(7), "seven:\n7");
    EXPECT_EQ(again.find(0), "");
    EXPECT_FALSE(again.find(1));
}

TEST_F(KeptResultsFile, IsRefusedForAnotherComputation) {
    { const KeptResults kept(file(), "study", "cache"); }
    EXPECT_EQ(refusal("another study"), ErrorKind::input);
}

TEST_F(KeptResultsFile, IsRefusedWhileAnotherHasIt) {
    const KeptResults kept(file(), "study", "cache");
    EXPECT_EQ(refusal("study"), ErrorKind::io);
}

TEST_F(KeptResultsFile, IsRefusedWhereItIsDamagedOrSomethingElse) {
    {
        KeptResults kept(file(), "study", "cache");
        for (std::uint64_t k = 0; k < 500; ++k)
            kept.keep(k, std::string(40, 'x'));
    }
    {
        std::fstream stream(file(), std::ios::in | std::ios::out | std::ios::binary);
        stream.seekp(9000);
        stream.put('y');
    }
    EXPECT_EQ(refusal("study"), ErrorKind::io);
    std::ofstream(file(), std::ios::trunc) << "this is no database, but it is long enough to be looked at as one";
    EXPECT_EQ(refusal("study"), ErrorKind::input);
}

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
