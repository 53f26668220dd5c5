#include "stridor/sweep/starts.hpp"

#include "stridor/sweep/evaluate.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

namespace stridor::sweep {
namespace {

using classification::Category;
using parameters::Initial;

constexpr StartVerdict none{Status::done, Category::none, classification::Quiet::slides};
constexpr StartVerdict sticks{Status::done, Category::none, classification::Quiet::sticks};
constexpr StartVerdict undecided{Status::done, Category::undecided};
constexpr StartVerdict locks{Status::done, Category::none, classification::Quiet::locks};
constexpr StartVerdict creak{Status::done, Category::creak};
constexpr StartVerdict squeak{Status::done, Category::squeak};
constexpr StartVerdict squeal{Status::done, Category::squeal};
constexpr StartVerdict failed{Status::failed, Category::none};

TEST(Starts, HaveTheNamesOfTheCaseFile) {
    EXPECT_EQ(start_names()[static_cast<std::size_t>(Initial::stuck)], "stuck");
    EXPECT_EQ(start_names()[static_cast<std::size_t>(Initial::sliding)], "sliding");
}

TEST(Verdicts, AreKnownByTheirWords) {
    EXPECT_EQ(word(squeal), "squeal");
    EXPECT_EQ(word(failed), "failed");
    EXPECT_EQ(word(locks), "locks");
    for (std::size_t number = 0; number < verdict_words.size(); ++number) {
        EXPECT_EQ(number_of(verdict_of(number)), number);
        EXPECT_EQ(word(verdict_of(number)), verdict_words[number]);
    }
}

TEST(Starts, ShowTheWorst) {
    const std::vector<StartVerdict> rising{none, sticks, locks, failed, undecided, creak, squeak, squeal};
    for (std::size_t louder = 1; louder < rising.size(); ++louder)
        for (std::size_t quieter = 0; quieter < louder; ++quieter) {
            EXPECT_EQ(worst(std::vector{rising[quieter], rising[louder]}), 1U) << word(rising[louder]);
            EXPECT_EQ(worst(std::vector{rising[louder], rising[quieter]}), 0U) << word(rising[louder]);
        }
}

TEST(Starts, ShowTheFirstOfEquallyBadOnes) {
    EXPECT_EQ(worst(std::vector{none, squeal, squeal}), 1U);
}

TEST(Agreement, IsQuietUnlessDisturbedWhereOneStartIsNoneAndAnotherNoisy) {
    EXPECT_EQ(agreement(std::vector{none, squeal}), Agreement::quiet_unless_disturbed);
    EXPECT_EQ(agreement(std::vector{creak, failed, none}), Agreement::quiet_unless_disturbed);
}

TEST(Agreement, DiffersWhereTheVerdictsDoOtherwise) {
    EXPECT_EQ(agreement(std::vector{squeak, squeal}), Agreement::differ);
    EXPECT_EQ(agreement(std::vector{none, undecided}), Agreement::differ);
    EXPECT_EQ(agreement(std::vector{none, failed}), Agreement::differ);
    EXPECT_EQ(agreement(std::vector{none, locks}), Agreement::differ);
    EXPECT_EQ(agreement(std::vector{locks, squeal}), Agreement::differ) << "what locks is no silence to disturb";
}

TEST(Agreement, IsBlindToTheCategoryOfWhatFailed) {
    EXPECT_EQ(agreement(std::vector{failed, StartVerdict{Status::failed, Category::squeal}}), Agreement::agree);
    EXPECT_EQ(agreement(std::vector{squeal, squeal, squeal}), Agreement::agree);
    EXPECT_EQ(agreement({}), Agreement::agree);
}

TEST(Joined, HasTheFiguresOfTheLoudestStart) {
    std::vector<Cell> cells(3);
    for (std::size_t k = 0; k < cells.size(); ++k) {
        cells[k].status = Status::done;
        cells[k].category = k == 1 ? Category::creak : Category::none;
        if (k != 1) cells[k].quiet = classification::Quiet::slides;
        set_figure(cells[k], cell_figure("slip"), 0.1 * static_cast<double>(k));
    }
    const Cell cell = joined(cells);
    EXPECT_EQ(cell.category, Category::creak);
    EXPECT_EQ(figure_of(cell, "slip"), 0.1);
    EXPECT_EQ(shown_start(cell), 1U);
    EXPECT_EQ(cell.starts, (std::vector{none, creak, none}));
    EXPECT_EQ(cell.agreement, Agreement::quiet_unless_disturbed);
}

TEST(Joined, ShowsThatItLocksFromOneStart) {
    std::vector<Cell> cells(3);
    for (Cell& cell : cells) {
        cell.status = Status::done;
        cell.category = Category::none;
        cell.quiet = classification::Quiet::slides;
    }
    cells[1].quiet = classification::Quiet::locks;
    const Cell cell = joined(cells);
    EXPECT_EQ(cell.quiet, classification::Quiet::locks);
    EXPECT_EQ(shown_start(cell), 1U);
    EXPECT_EQ(cell.agreement, Agreement::differ);
}

TEST(EvaluateFromSeveralStarts, KeepsTheVerdictThatEachStartHasAlone) {
    Study study = small_study();
    study.starts = {Initial::rest, Initial::sliding};
    for (const int ix : {0, 3}) {
        const std::vector<Cell> together = evaluate(study, ix, 2);
        ASSERT_EQ(together.size(), 2U);
        for (std::size_t start = 0; start < study.starts.size(); ++start) {
            Study alone = small_study();
            alone.base.run.initial = study.starts[start];
            const std::vector<Cell> cells = evaluate(alone, ix, 2);
            for (std::size_t direction = 0; direction < 2; ++direction) {
                const StartVerdict expected{cells[direction].status, cells[direction].category, cells[direction].quiet};
                EXPECT_EQ(word(together[direction].starts.at(start)), word(expected));
                if (shown_start(together[direction]) != start) continue;
                EXPECT_TRUE(same_bits(figure_of(together[direction], "slip"), figure_of(cells[direction], "slip")));
                EXPECT_TRUE(
                    same_bits(figure_of(together[direction], "joint_rms"), figure_of(cells[direction], "joint_rms")));
            }
        }
    }
}

TEST(EvaluateFromSeveralStarts, FindsAMotionThatAStartAtRestMisses) {
    Study study = small_study();
    study.starts = {Initial::rest, Initial::stuck, Initial::sliding};
    study.base.run.duration = 0.2;
    study.base.run.window = 0.1;
    int disagreeing = 0;
    for (int ix = 0; ix < study.x.points; ++ix)
        for (int iy = 0; iy < study.y.points; ++iy)
            for (const Cell& cell : evaluate(study, ix, iy))
                disagreeing += cell.agreement == Agreement::agree ? 0 : 1;
    EXPECT_GT(disagreeing, 0);
}

TEST(EvaluateFromSeveralStarts, GivesNoCellWhenStopped) {
    Study study = small_study();
    study.starts = {Initial::rest, Initial::stuck};
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(evaluate(study, 0, 0, source.get_token()).empty());
}

}  // namespace
}  // namespace stridor::sweep
