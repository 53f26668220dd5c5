#include "stridor/sweep/evaluate.hpp"

#include "stridor/analysis/evidence.hpp"
#include "stridor/analysis/sliding_stability.hpp"
#include "stridor/base/error.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/integration/failure.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/case_structure.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/joints.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stridor::sweep {
namespace {

using parameters::Direction;
using parameters::DriveKind;

// 100 Hz: one and a half periods fill the window of 15 ms
Study sinusoidal_study() {
    Study study = small_study();
    study.base.drive.kind = DriveKind::sinusoidal;
    study.base.drive.frequency = 100.0;
    study.base.drive.amplitude = 1e-4;
    study.base.run.window = 0.015;
    return study;
}

void expect_no_figures(const Cell& cell) {
    for (const CellFigure& figure : cell_figures())
        EXPECT_TRUE(std::isnan(figure_of(cell, figure))) << figure.name;
}

TEST(Evaluate, GivesWhatARunOfTheCellsCaseGives) {
    const Study study = small_study();
    const std::vector<Cell> cells = evaluate(study, 2, 1);
    ASSERT_EQ(cells.size(), 2U);
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const parameters::Case c = case_at(study, {direction, 1, 2});
        const integration::Motion motion = integration::simulate(c);
        const analysis::Evidence evidence = analysis::evidence(motion.record.phases.front(), 0);
        const Cell& cell = cells[direction];
        EXPECT_EQ(cell.status, Status::done);
        EXPECT_EQ(cell.category, classification::classify(evidence, c.verdict).category);
        EXPECT_TRUE(same_bits(figure_of(cell, "slip"), evidence.rates.slip));
        EXPECT_TRUE(same_bits(figure_of(cell, "regularity"), evidence.alternation.regularity));
        EXPECT_TRUE(same_bits(figure_of(cell, "joint_level"), evidence.levels.joint.decibels));
        EXPECT_TRUE(same_bits(figure_of(cell, "energy_residual"), motion.energy.relative_residual()));
        const analysis::SlidingStability stability =
            analysis::sliding_stability(model::rubbing_system(c), study.directions[direction]);
        EXPECT_TRUE(same_bits(figure_of(cell, "growth_rate"), stability.growth));
        EXPECT_TRUE(same_bits(figure_of(cell, "mode_frequency"), stability.frequency));
    }
}

TEST(Evaluate, KeepsTheOrderOfTheStudysDirections) {
    Study study = small_study();
    const std::vector<Cell> both = evaluate(study, 1, 2);
    study.directions = {Direction::coming, Direction::going};
    const std::vector<Cell> turned = evaluate(study, 1, 2);
    EXPECT_TRUE(same_cell(both[0], turned[1]));
    EXPECT_TRUE(same_cell(both[1], turned[0]));
    study.directions = {Direction::coming};
    const std::vector<Cell> single = evaluate(study, 1, 2);
    ASSERT_EQ(single.size(), 1U);
    EXPECT_TRUE(same_cell(single[0], both[1]));
}

TEST(Evaluate, TakesBothDirectionsOfADriveThatTurnsFromOneRun) {
    const Study study = sinusoidal_study();
    const std::vector<Cell> cells = evaluate(study, 3, 1);
    const integration::Motion motion = integration::simulate(case_at(study, {0, 1, 3}));
    ASSERT_EQ(cells.size(), 2U);
    ASSERT_EQ(motion.record.phases.size(), 2U);
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const analysis::Evidence evidence = analysis::evidence(motion.record.phases[direction], 0);
        EXPECT_EQ(cells[direction].status, Status::done);
        EXPECT_TRUE(same_bits(figure_of(cells[direction], "judged_stick"), evidence.judged_rates.stick));
        EXPECT_TRUE(same_bits(figure_of(cells[direction], "energy_residual"), motion.energy.relative_residual()));
    }
}

TEST(EvaluateRun, GivesOneCellWithAConstantDriveAndAllDirectionsOtherwise) {
    Study study = small_study();
    integration::Workspace workspace;  // what one run leaves in it changes nothing in the next
    const std::vector<Cell> all = evaluate(study, 2, 1);
    for (std::size_t direction = 0; direction < 2; ++direction) {
        const std::vector<Cell> one = evaluate_run(study, index_of(study, {direction, 1, 2}), {}, workspace);
        ASSERT_EQ(one.size(), 1U);
        EXPECT_TRUE(same_cell(one[0], all[direction]));
    }
    study = sinusoidal_study();
    EXPECT_TRUE(same_cells(evaluate_run(study, index_of(study, {0, 1, 3}), {}, workspace), evaluate(study, 3, 1)));
}

TEST(Evaluate, LeavesADirectionUndecidedThatTheDriveNeverTakes) {
    Study study = small_study();
    study.base.drive.kind = DriveKind::sampled;
    study.base.drive.times = {0.0, 0.02};
    study.base.drive.velocities = {0.1, 0.1};
    const std::vector<Cell> cells = evaluate(study, 0, 0);
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells[1].status, Status::done);
    EXPECT_EQ(cells[1].category, classification::Category::undecided);
    EXPECT_EQ(cells[1].message, "no complete phase lies in the window");
    EXPECT_TRUE(std::isnan(figure_of(cells[1], "slip")));
}

TEST(Evaluate, CallsACellInvalidWhoseValuesContradictEachOther) {
    Study study = small_study();
    study.base.contact().static_friction = 0.5;
    const std::vector<Cell> cells = evaluate(study, 0, 2);
    ASSERT_EQ(cells.size(), 2U);
    for (const Cell& cell : cells) {
        EXPECT_EQ(cell.status, Status::invalid);
        EXPECT_EQ(cell.message,
                  "mu_d = 0.8 exceeds mu_s = 0.5 (kinetic friction may not be larger than static). Swap them?");
        expect_no_figures(cell);
    }
}

TEST(Evaluate, SaysWhatStepWouldBeStable) {
    Study study = small_study();
    study.base.run.engine = parameters::Engine::beta_2;
    study.base.run.step = 1e-3;
    const std::string sentence = integration::beyond_step_limit(case_at(study, {0, 0, 0})).what();
    for (const Cell& cell : evaluate(study, 0, 0)) {
        EXPECT_EQ(cell.status, Status::step_limit);
        EXPECT_EQ(cell.message, sentence);
        expect_no_figures(cell);
    }
}

// what products of would leave double precision is refused before it runs
TEST(Evaluate, CallsACellInvalidWhoseNumbersWouldOverflow) {
    Study study = small_study();
    study.x.to = 1e308;
    for (const Cell& cell : evaluate(study, study.x.points - 1, 0)) {
        EXPECT_EQ(cell.status, Status::invalid);
        EXPECT_NE(cell.message.find("double precision"), std::string::npos) << cell.message;
        expect_no_figures(cell);
    }
}

TEST(Evaluate, CallsACellFailedWhoseSlidingStartDigsIn) {
    Study study = small_study();
    study.base.run.initial = parameters::Initial::sliding;
    study.base.contact().static_friction = 5.0;
    // at 70 degrees the normal force of steady sliding grows without bound towards mu_d = 4.2 going, never coming
    study.y.to = 5.0;
    const std::vector<Cell> cells = evaluate(study, 0, study.y.points - 1);
    ASSERT_EQ(cells.size(), 2U);
    EXPECT_EQ(cells[0].status, Status::failed);
    EXPECT_NE(cells[0].message.find("sprag-slip"), std::string::npos) << cells[0].message;
    expect_no_figures(cells[0]);
    EXPECT_EQ(cells[1].status, Status::done) << cells[1].message;
}

TEST(Evaluate, ThrowsWhatConcernsEveryCell) {
    Study study = small_study();
    study.base.run.initial = parameters::Initial::sliding;
    study.base.drive.kind = DriveKind::sampled;
    // V = 0 at t = 0, between two samples: nothing before the run sees it
    study.base.drive.times = {-0.02, 0.02};
    study.base.drive.velocities = {-0.1, 0.1};
    EXPECT_EQ(support::thrown_by([&] { evaluate(study, 0, 0); }).kind, ErrorKind::input);
}

TEST(Evaluate, GivesNoCellWhenStopped) {
    std::stop_source source;
    source.request_stop();
    EXPECT_TRUE(evaluate(small_study(), 0, 0, source.get_token()).empty());
}

TEST(Evaluate, OfSeveralJointsJudgesTheLoudestContact) {
    Study study = small_study();
    study.base = parameters::two_lips();
    study.base.run.duration = 0.05;
    study.base.run.window = 0.05;
    study.x = {"joint.lower.contact.preload", 100.0, 200.0, 2, Scale::linear};
    const std::vector<Cell> cells = evaluate(study, 1, 1);
    ASSERT_EQ(cells.size(), 2U);
    const parameters::Case c = case_at(study, {1, 1, 1});
    const auto verdict = classification::classify_phase(integration::simulate(c).record.phases[0], c.verdict);
    ASSERT_EQ(cells[1].status, Status::done) << cells[1].message;
    EXPECT_EQ(cells[1].category, verdict.category);
    EXPECT_EQ(figure_of(cells[1], "stick"), verdict.evidence.rates.stick);
    const analysis::SlidingStability stability =
        analysis::sliding_stability(model::structure_of(c), study.directions[1]);
    EXPECT_EQ(figure_of(cells[1], "growth_rate"), stability.growth);
    EXPECT_EQ(figure_of(cells[1], "mode_frequency"), stability.frequency);
}

}  // namespace
}  // namespace stridor::sweep
