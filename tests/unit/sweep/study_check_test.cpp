#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/study.hpp"
#include "support/error_text.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

// Which studies can be computed, and what is said of the others.
namespace stridor::sweep {
namespace {

using parameters::Case;
using parameters::Direction;
using parameters::Initial;
using support::Thrown;
using support::thrown_by;

TEST(Check, AcceptsAStudyThatCanBeComputed) {
    EXPECT_NO_THROW(check(small_study()));
}

struct Wrong {
    std::string name;
    std::function<void(Study&)> spoil;
    std::string says;
};

class CheckRefuses : public testing::TestWithParam<Wrong> {};

TEST_P(CheckRefuses, WithAMessageThatNamesTheProblem) {
    Study study = small_study();
    GetParam().spoil(study);
    const Thrown thrown = thrown_by([&] { check(study); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    EXPECT_EQ(thrown.message, GetParam().says);
}

const Wrong wrongs[] = {
    {"AMisspeltAxis", [](Study& s) { s.x.parameter = "contact.preloat"; },
     "chart.x.parameter = \"contact.preloat\" is no quantity (a case has no such key). Did you mean "
     "\"contact.preload\"?"},
    {"AnAxisOfWords", [](Study& s) { s.y.parameter = "run.initial"; },
     "chart.y.parameter = \"run.initial\" is no quantity (it has no numbers an axis could run through)"},
    {"AnAxisTheCaseDoesNotUse", [](Study& s) { s.x.parameter = "drive.amplitude"; },
     "chart.x.parameter = \"drive.amplitude\" changes nothing (this case, with its kind of drive and start, does not "
     "use it). Choose another quantity."},
    {"AnEndOutOfRange", [](Study& s) { s.y.from = -0.1; },
     "chart.y.from: contact.kinetic_friction = -0.1 is out of range (it must be at least 0)"},
    {"AnEndThatIsNoNumber", [](Study& s) { s.x.to = std::nan(""); },
     "chart.x.to: contact.preload = nan is out of range (it must be finite)"},
    {"AnEndBeyondWhatACaseHolds", [](Study& s) { s.x.to = 1e300; },
     "chart.x.to = 1e+300 is beyond 1e75 (products of such numbers leave double precision). Check its unit."},
    {"ASinglePoint", [](Study& s) { s.x.points = 1; },
     "chart.x.points = 1 makes no axis (both ends belong to it, so it has two at least)"},
    {"AMillionPoints", [](Study& s) { s.x.points = 1000000; },
     "chart.x.points = 1000000 is too many (an axis has at most 65536 points)"},
    {"MoreCellsThanCanBeCounted", [](Study& s) { s.x.points = s.y.points = 65536; },
     "a chart of 8589934592 cells is too large (it has at most 4000000000). Cut it into several charts."},
    {"AFallingAxis", [](Study& s) { std::swap(s.x.from, s.x.to); },
     "chart.x.from = 400 is not below chart.x.to = 2 (an axis rises). Swap them?"},
    {"AnAxisWithoutLength", [](Study& s) { s.x.to = s.x.from; },
     "chart.x.from = 2 is not below chart.x.to = 2 (an axis rises)"},
    {"ALogarithmOfZero",
     [](Study& s) {
         s.y.from = 0.0;
         s.y.scale = Scale::logarithmic;
     },
     "chart.y.from = 0 has no logarithm (a logarithmic axis holds positive values only). Set chart.y.scale = "
     "\"linear\"?"},
    {"AThousandOctaves",
     [](Study& s) {
         s.x.from = 1e-300;
         s.x.to = 1e75;
     },
     "chart.x runs from 1e-300 to 1e+75 (a logarithmic axis spans less than 1000 octaves)"},
    {"EqualAxes", [](Study& s) { s.y = s.x; },
     "chart.x and chart.y are both contact.preload (a chart needs two different quantities)"},
    {"NoDirection", [](Study& s) { s.directions.clear(); },
     "chart.directions is empty (there would be nothing to compute). Write directions = [\"going\", \"coming\"]?"},
    {"ADirectionTwice",
     [](Study& s) {
         s.directions = {Direction::coming, Direction::coming};
     },
     "chart.directions names \"coming\" twice (each is computed once)"},
    {"AnUnknownQuantityToDraw",
     [](Study& s) {
         s.quantities = {"category", "joint_levels"};
     },
     "chart.quantities names \"joint_levels\" (a cell has no such figure). Did you mean \"joint_level\"?"},
    {"AStartTwice",
     [](Study& s) {
         s.starts = {Initial::stuck, Initial::stuck};
     },
     "chart.starts names \"stuck\" twice (each is computed once)"},
    {"AFinerRefinementThanThereIs", [](Study& s) { s.refine = 7; },
     "chart.refine = 7 is out of range (the base grid has every 2^refine-th point, and refine is from 0 to 6)"},
    {"AStartThatIsWrongInEveryCell",
     [](Study& s) {
         s.base.drive.kind = parameters::DriveKind::sampled;
         s.base.drive.times = {0.0, 0.02};
         s.base.drive.velocities = {0.0, 0.1};
         s.starts = {Initial::rest, Initial::sliding};
     },
     "run.initial = \"sliding\" has no direction (the drive stands still at the start). Start with \"rest\"."},
    {"ACaseThatIsWrongInEveryCell", [](Study& s) { s.base.run.window = 1.0; },
     "run.window = 1 s is longer than run.duration = 0.02 s (the window is the last part of the simulated time). "
     "Make it at most the duration."},
};

INSTANTIATE_TEST_SUITE_P(Study, CheckRefuses, testing::ValuesIn(wrongs),
                         [](const testing::TestParamInfo<Wrong>& wrong) { return wrong.param.name; });

TEST(Check, AcceptsCellsThatContradictThemselvesInPartOfTheChart) {
    Study study = small_study();
    study.base.contact().static_friction = 0.5;
    EXPECT_NO_THROW(check(study));
}

TEST(Check, LetsAnAxisBeWhatOneOfTheStartsNeeds) {
    Study study = small_study();
    study.y = {"run.perturbation", 1e-4, 1e-2, 3, Scale::logarithmic};
    EXPECT_THROW(check(study), Error);
    study.starts = {Initial::rest, Initial::sliding};
    EXPECT_NO_THROW(check(study));
}

}  // namespace
}  // namespace stridor::sweep
