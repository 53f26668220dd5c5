#include "stridor/base/error.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::storage {
namespace {

TEST(FileEnding, IsOneOfThoseKnownOrNone) {
    for (const char* file : {"motion.csv", "a.b/motion.nc", "/dev/stdout", "-", "motion"})
        EXPECT_NO_THROW(expect_ending("--trace", file, {".csv", ".nc"})) << file;
}

TEST(FileEnding, ThatSaysNothingIsRefusedWithOneThatDoes) {
    const auto thrown = support::thrown_by([] { expect_ending("--trace", "motion.txt", {".csv", ".nc"}); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_TRUE(thrown.says("--trace motion.txt has an ending that says nothing")) << thrown.message;
    EXPECT_TRUE(thrown.says(".csv or .nc")) << thrown.message;
    EXPECT_TRUE(thrown.says("Name it motion.csv")) << thrown.message;
}

}  // namespace
}  // namespace stridor::storage
