#include "stridor/console/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::console {
namespace {

sweep::Progress half_done() {
    sweep::Progress progress;
    progress.done = 50;
    progress.total = 100;
    progress.rate = 2.0;  // [1/s]
    progress.counts.categories[static_cast<std::size_t>(classification::Category::squeal)] = 50;
    return progress;
}

TEST(ProgressLine, TellsShareRateAndTimeLeft) {
    const std::string line = progress_line(half_done(), 200);
    EXPECT_EQ(line, "[==========          ] 50/100 cells  50 %  2 cells/s  0:25 left  squeal 50");
}

TEST(ProgressLine, SaysNoTimeLeftBeforeAnythingIsDone) {
    sweep::Progress progress;
    progress.total = 100;
    EXPECT_EQ(progress_line(progress, 200), "[                    ] 0/100 cells  0 %  ");
}

TEST(ProgressLine, SaysNoTimeLeftThatIsNone) {
    sweep::Progress progress = half_done();
    progress.rate = 1e-300;
    EXPECT_EQ(progress_line(progress, 200).find("left"), std::string::npos);
}

TEST(ProgressLine, LosesItsBarFirstAndIsNeverWiderThanTheTerminal) {
    const std::string whole = progress_line(half_done(), 200);
    const std::string narrow = progress_line(half_done(), static_cast<int>(whole.size()));
    EXPECT_TRUE(narrow.starts_with("50/100 cells"));
    for (const int columns : {1, 2, 20, 60, 80})
        EXPECT_LE(progress_line(half_done(), columns).size(), static_cast<std::size_t>(std::max(1, columns - 1)));
}

TEST(CountsText, TellsLockingCellsApart) {
    sweep::Counts counts;
    counts.categories[static_cast<std::size_t>(classification::Category::none)] = 20;
    counts.locks = 3;
    counts.statuses[static_cast<std::size_t>(sweep::Status::failed)] = 1;
    EXPECT_EQ(counts_text(counts), "none 20  locks 3  failed 1");
}

TEST(TakesLong, IsManyRecordingsOrMuchSound) {
    EXPECT_FALSE(takes_long(19, 59'999'999));
    EXPECT_TRUE(takes_long(20, 0));
    EXPECT_TRUE(takes_long(1, 60'000'000));
}

}  // namespace
}  // namespace stridor::console
