#include "stridor/sweep/diagram.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/keeper.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace stridor::sweep {
namespace {

// the squeal of Table 1 under a constant drive, over the friction
Study over_friction() {
    Study study;
    study.base = parameters::paper_case(parameters::PaperCase::squeal);
    study.base.drive = {};
    study.base.drive.kind = parameters::DriveKind::constant;
    study.base.drive.velocity = 0.1;
    study.base.run.duration = 0.4;
    study.base.run.window = 0.2;
    study.x = {"contact.kinetic_friction", 0.1, 0.7, 4, Scale::linear};
    study.y = resting_axis(study.base, study.x);
    study.directions = {parameters::Direction::going};
    return study;
}

SweepResult swept(const Study& study) {
    check(study);
    const auto keeper = std::make_shared<MemoryKeeper>(study);
    run(study, *keeper);
    return load(study, keeper);
}

TEST(OneAxis, ComputesEveryCellOfItsRow) {
    const Study study = over_friction();
    EXPECT_EQ(cell_count(study), 4U);
    const SweepResult result = swept(study);
    EXPECT_EQ(computed_count(result), 4U);
    EXPECT_EQ(result.cells.front().category, classification::Category::none);
    EXPECT_EQ(result.cells.back().category, classification::Category::squeal);
}

TEST(OneAxis, ItsBoundariesAreChangesAlongX) {
    const SweepResult result = swept(over_friction());
    const std::vector<Boundary> lines = boundaries(result);
    ASSERT_FALSE(lines.empty());
    for (const Boundary& line : lines) {
        ASSERT_EQ(line.vertices.size(), 1U);
        EXPECT_NEAR(line.vertices.front().x_resolution, 0.1, 1e-12);
        EXPECT_EQ(line.vertices.front().y, 20.0) << "the preload, which rests";
    }
}

TEST(OneAxis, RefusesToRefineAndToRestElsewhere) {
    Study study = over_friction();
    study.refine = 2;
    EXPECT_THROW(check(study), Error);
    study = over_friction();
    study.y.from = study.y.to = 10.0;
    EXPECT_THROW(check(study), Error);
}

TEST(Diagram, ASquealMovesFarAndBeatsASteadySlideDoesNeither) {
    const SweepResult result = swept(over_friction());
    const std::vector<DiagramCell> cells = diagram(result, {});
    ASSERT_EQ(cells.size(), 4U);
    const auto span = [](const DiagramCell& cell) { return cell.extremes.back() - cell.extremes.front(); };
    ASSERT_GE(cells.front().extremes.size(), 2U);
    EXPECT_LT(span(cells.front()), 0.01 * span(cells.back()));
    EXPECT_TRUE(cells.front().intervals.empty());
    ASSERT_FALSE(cells.back().intervals.empty());
    const Cell squeal = computed_cell(result, 3);
    EXPECT_LE(cells.back().intervals.front(), 1.0 / figure_of(squeal, "frequency"));
    EXPECT_GE(cells.back().intervals.back(), 1.0 / figure_of(squeal, "frequency"));
    for (const DiagramCell& cell : cells) {
        EXPECT_TRUE(std::is_sorted(cell.extremes.begin(), cell.extremes.end()));
        EXPECT_LE(cell.extremes.size(), static_cast<std::size_t>(1.0 / diagram_resolution) + 2U);
    }
}

TEST(Diagram, IsTheSameForAnyNumberOfThreadsAndAsText) {
    const SweepResult result = swept(over_friction());
    const std::vector<DiagramCell> one = diagram(result, {.crew = crew::thread_crews(1)});
    const std::vector<DiagramCell> three = diagram(result, {.crew = crew::thread_crews(3)});
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].extremes, three[k].extremes);
        EXPECT_EQ(one[k].intervals, three[k].intervals);
        const std::optional<DiagramCell> back = unpacked_diagram_cell(packed(one[k]));
        ASSERT_TRUE(back);
        EXPECT_EQ(back->extremes, one[k].extremes);
        EXPECT_EQ(back->intervals, one[k].intervals);
    }
    EXPECT_FALSE(unpacked_diagram_cell("1:9"));
    EXPECT_FALSE(unpacked_diagram_cell(""));
}

}  // namespace
}  // namespace stridor::sweep
