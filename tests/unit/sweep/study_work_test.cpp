#include "stridor/sweep/study_work.hpp"

#include "stridor/sweep/evaluate.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stridor::sweep {
namespace {

using Runs = std::vector<std::size_t>;

TEST(Agenda, GivesTheLowestFirstWhateverTheOrderTheyCameIn) {
    Agenda agenda(100);
    for (const std::size_t run : {7U, 3U, 99U, 0U})
        agenda.add(run);
    EXPECT_EQ(agenda.next(2), (Runs{0, 3}));
    agenda.add(1);
    EXPECT_EQ(agenda.left(), 3U);
    EXPECT_EQ(agenda.next(10), (Runs{1, 7, 99}));
    EXPECT_EQ(agenda.left(), 0U);
    EXPECT_TRUE(agenda.next(10).empty());
}

TEST(Agenda, TakesARunOnce) {
    Agenda agenda(10);
    agenda.add(4);
    agenda.add(4);
    EXPECT_EQ(agenda.next(10), Runs{4});
    agenda.add(4);
    EXPECT_EQ(agenda.left(), 0U) << "it is out, or done";
}

using support::thrown_by;

std::vector<Cell> two_cells() {
    Cell done;
    done.status = Status::done;
    done.category = classification::Category::none;
    done.quiet = classification::Quiet::sticks;
    done.starts = {{Status::done, classification::Category::creak}, {Status::failed, {}}};
    done.agreement = Agreement::quiet_unless_disturbed;
    for (const CellFigure& figure : cell_figures())
        set_figure(done, figure, 0.1 * static_cast<double>(figure.place));
    set_figure(done, cell_figures()[2], -0.0);
    set_figure(done, cell_figures()[3], std::numeric_limits<double>::quiet_NaN());
    Cell failed;
    failed.status = Status::diverged;
    failed.message = "a number left double precision";
    return {done, failed};
}

TEST(PackedCells, ComeBackBitForBit) {
    const std::vector<Cell> cells = two_cells();
    const std::vector<Cell> back = unpacked_cells(packed(cells));
    ASSERT_EQ(back.size(), cells.size());
    for (std::size_t k = 0; k < cells.size(); ++k)
        EXPECT_TRUE(same_cell(back[k], cells[k])) << k;
}

TEST(PackedCells, AreRefusedWhereTheyAreTornOrOfOtherFigures) {
    const std::string bytes = packed(two_cells());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_TRUE(thrown_by([&] { unpacked_cells(bytes.substr(0, size)); }).says("damaged")) << size;
    EXPECT_TRUE(thrown_by([&] { unpacked_cells(bytes + "x"); }).says("damaged"));
    std::vector<Cell> short_of_one = two_cells();
    short_of_one[0].figures.pop_back();
    EXPECT_TRUE(thrown_by([&] { unpacked_cells(packed(short_of_one)); }).says("damaged"));
}

TEST(StudyWork, GivesTheCellsOfARun) {
    const Study study = small_study();
    const crew::Worker worker = work_of(study).worker();
    integration::Workspace workspace;
    const std::vector<Cell> expected = evaluate_run(study, 5, {}, workspace);
    const std::vector<Cell> cells = unpacked_cells(worker({5}, {}).value());
    ASSERT_EQ(cells.size(), expected.size());
    EXPECT_TRUE(same_cell(cells[0], expected[0]));
}

TEST(StudyWork, OfAnotherStudyHasAnotherText) {
    Study other = small_study();
    other.x.points += 1;
    EXPECT_NE(work_of(small_study()).text, work_of(other).text);
}

TEST(StudyWork, GivesNothingOfAStoppedRun) {
    const Study study = small_study();
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(work_of(study).worker()({5}, stop.get_token()).has_value());
}

}  // namespace
}  // namespace stridor::sweep
