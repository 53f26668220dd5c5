#include "stridor/pictures/time_history.hpp"

#include "pictures_support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor::pictures {
namespace {

// one second of a sine of height 1 with one enormous sample, sampled a thousand times
record::Record example() {
    record::Record result;
    record::Trace& trace = result.trace;
    trace = record::empty_trace(3);
    for (int i = 0; i < 1000; ++i) {
        const double value = i == 500 ? 1e6 : std::sin(0.1 * i);
        trace.time.push_back(i * 1e-3);
        trace.surface_velocity.push_back(std::cos(10.0 * std::numbers::pi * i * 1e-3));
        trace.contacts.front().normal_force.push_back(value);
        trace.contacts.front().friction_force.push_back(value);
        for (auto* motion : {&trace.displacement, &trace.velocity, &trace.acceleration})
            for (std::vector<double>& dof : *motion)
                dof.push_back(value);
    }
    result.histories = {{{model::ContactState::slip, 0.0, 1.0, 0.0, 0.0}}};
    return result;
}

TEST(TimeHistory, HasARowPerCurveAndTheContactStatesBelow) {
    const drawing::Scene scene = time_history({}, example());
    ASSERT_EQ(scene.panels.size(), 5U);
    EXPECT_EQ(drawing::plain_text(scene.panels[0].y.label), "V");
    EXPECT_EQ(drawing::plain_text(scene.panels[1].y.label), "ẍ1");
    EXPECT_EQ(drawing::plain_text(scene.panels[2].y.label), "ÿ1");
    EXPECT_EQ(drawing::plain_text(scene.panels[3].y.label), "ÿ2");
    EXPECT_EQ(scene.panels[3].y.unit, "m/s^2");
    EXPECT_EQ(layers_of<drawing::Strip>(scene.panels[4]).size(), 1U);
    for (const drawing::Panel& panel : scene.panels)
        EXPECT_EQ(panel.x.range, (drawing::Extent{0.0, 1.0}));
}

TEST(TimeHistory, ImpactPeaksDoNotSetTheAxisButAreDrawn) {
    parameters::Case c;
    c.run.engine = parameters::Engine::beta_2;
    record::Record record = example();
    record.histories.front() = {{model::ContactState::slip, 0.0, 0.3, 0.0, 0.0},
                                {model::ContactState::separation, 0.3, 0.5, 0.0, 0.0},
                                {model::ContactState::slip, 0.5, 1.0, 0.0, -0.1}};
    const drawing::Scene scene = time_history(c, record);
    EXPECT_LT(scene.panels[1].y.range.to, 2.0);
    const drawing::Line line = layers_of<drawing::Line>(scene.panels[1]).at(0);
    EXPECT_EQ(*std::max_element(line.y.begin(), line.y.end()), 1e6);
    EXPECT_EQ(scene.caption.size(), 2U) << "the reader is told";
}

TEST(TimeHistory, ARunWithoutImpactsBlamesNone) {
    for (const parameters::Engine engine : {parameters::Engine::beta_2, parameters::Engine::exact}) {
        parameters::Case c;
        c.run.engine = engine;
        const drawing::Scene scene = time_history(c, example());
        EXPECT_GT(scene.panels[1].y.range.to, 1e6) << "a peak that is no impact is a part of the motion";
        EXPECT_EQ(scene.caption.size(), 1U);
    }
}

TEST(TimeHistory, TheExactEngineHasNoPeaksThatFollowFromAStep) {
    record::Record record = example();
    record.histories.front().push_back({model::ContactState::separation, 1.0, 1.0, 0.0, 0.0});
    record.histories.front().push_back({model::ContactState::slip, 1.0, 1.0, 0.0, -0.1});
    parameters::Case c;
    c.run.engine = parameters::Engine::exact;
    EXPECT_EQ(time_history(c, record).caption.size(), 1U);
}

TEST(TimeHistory, SaysWhatTheZoomShows) {
    record::Record record = example();
    TimeHistoryOptions options;
    options.zoom = drawing::Extent{0.2, 0.4};
    EXPECT_EQ(drawing::plain_text(time_history({}, record, options).caption.at(1)),
              "In b) the contact does not change its state.");
    record.histories.front() = {{model::ContactState::slip, 0.0, 0.25, 0.0, 0.0},
                                {model::ContactState::stick, 0.25, 0.3, 0.0, 0.0},
                                {model::ContactState::separation, 0.3, 0.35, 0.0, 0.0},
                                {model::ContactState::stick, 0.35, 1.0, 0.0, 0.0}};
    EXPECT_EQ(drawing::plain_text(time_history({}, record, options).caption.at(1)),
              "In b) the contact separates once and sticks twice.");
}

TEST(TimeHistory, PeaksOfVelocitiesSetTheirAxis) {
    TimeHistoryOptions options;
    options.signals = {ShownSignal::velocity, ShownSignal::displacement};
    const drawing::Scene scene = time_history({}, example(), options);
    ASSERT_EQ(scene.panels.size(), 7U);
    EXPECT_GT(scene.panels[0].y.range.to, 1e6);
    EXPECT_EQ(scene.caption.size(), 1U);
}

TEST(TimeHistory, ZoomStandsBesideAndIsMarked) {
    TimeHistoryOptions options;
    options.zoom = drawing::Extent{0.2, 0.22};
    const drawing::Scene scene = time_history({}, example(), options);
    ASSERT_EQ(scene.panels.size(), 10U);
    EXPECT_EQ(scene.panels[5].x.range, *options.zoom);
    EXPECT_EQ(scene.panels[5].column, 1U);
    const drawing::Line line = layers_of<drawing::Line>(scene.panels[5]).at(0);
    EXPECT_LE(line.x.size(), 23U) << "only its own samples and one at either end";
    EXPECT_LT(line.x.front(), 0.2);
    EXPECT_GT(line.x.back(), 0.22);
    for (std::size_t row = 0; row < 5; ++row)
        EXPECT_EQ(layers_of<drawing::Boxes>(scene.panels[row]).at(0).boxes.at(0).x, *options.zoom);
    EXPECT_EQ(drawing::plain_text(scene.panels[5].title), "b) 0.2 s to 0.22 s (going)");
}

// slips of 1 ms each, one after each stay of these lengths
std::vector<record::ContactHistory> sticks(const std::vector<double>& lengths) {
    record::ContactHistory history;
    double time = 0.0;
    for (const double length : lengths) {
        history.push_back({model::ContactState::stick, time, time + length, 0.0, 0.0});
        history.push_back({model::ContactState::slip, time + length, time + length + 1e-3, 0.0, 0.0});
        time += length + 1e-3;
    }
    return {history};
}

TEST(BusiestStretch, IsWhereTheContactChangesMost) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = 1.0;
    c.run.window = 0.5;
    // slips at 0.6, then four close together from 0.8 s on
    const std::optional<drawing::Extent> stretch = busiest_stretch(c, sticks({0.6, 0.2, 2e-3, 2e-3, 2e-3, 0.1}), 0.02);
    ASSERT_TRUE(stretch);
    EXPECT_LT(stretch->from, 0.801);
    EXPECT_GT(stretch->to, 0.811);
    EXPECT_NEAR(stretch->to - stretch->from, 0.02, 1e-12);
}

TEST(BusiestStretch, PrefersWhatIsJudged) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = 1.0;
    c.run.window = 0.5;
    const std::optional<drawing::Extent> late = busiest_stretch(c, sticks({1e-3, 1e-3, 1e-3, 0.8, 2e-3}), 0.02);
    ASSERT_TRUE(late);
    EXPECT_GT(late->from, 0.5);
    const std::optional<drawing::Extent> early = busiest_stretch(c, sticks({1e-3, 1e-3, 1e-3}), 0.02);
    ASSERT_TRUE(early);
    EXPECT_LT(early->from, 0.5);
}

TEST(BusiestStretch, IsNoneWhereNothingHappens) {
    EXPECT_FALSE(busiest_stretch({}, example().histories, 0.02));
    EXPECT_FALSE(busiest_stretch({}, {}, 0.02));
}

TEST(TellingStretch, LiesInAGoingPhase) {
    const parameters::Case c;
    const drawing::Extent stretch = telling_stretch(c, 0.01);
    EXPECT_NEAR(stretch.to - stretch.from, 0.01, 1e-12);
    for (const double time : {stretch.from, stretch.to})
        EXPECT_GT(std::cos(2.0 * std::numbers::pi * c.drive.frequency * time), 0.0);
}

TEST(TellingStretch, IsTheMiddleOfAConstantDrivesWindow) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    c.run.duration = 2.0;
    c.run.window = 1.0;
    const drawing::Extent stretch = telling_stretch(c, 0.01);
    EXPECT_NEAR(stretch.from, 1.495, 1e-12);
    EXPECT_NEAR(stretch.to, 1.505, 1e-12);
}

TEST(TellingStretch, IsNeverLongerThanTheRun) {
    parameters::Case c;
    c.drive.kind = parameters::DriveKind::constant;
    const drawing::Extent stretch = telling_stretch(c, 10.0);
    EXPECT_GE(stretch.from, 0.0);
    EXPECT_LE(stretch.to, c.run.duration);
}

}  // namespace
}  // namespace stridor::pictures
