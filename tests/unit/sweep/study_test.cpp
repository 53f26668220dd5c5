#include "stridor/sweep/study.hpp"

#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/parameters/rules/check.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"
#include "support/small_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace stridor::sweep {
namespace {

using parameters::Case;
using parameters::Direction;
using parameters::Initial;
using support::number_between;
using support::Thrown;
using support::thrown_by;
using support::whole_between;

// up to 40 octaves or, linear, a thousand units wide
Axis any_axis() {
    Axis axis{"contact.preload", *number_between(1e-3, 10.0), 0.0, *whole_between(2, 60), Scale::linear};
    axis.scale = *rc::gen::element(Scale::linear, Scale::logarithmic);
    axis.to = axis.from + *number_between(1e-6, 1000.0);
    return axis;
}

RC_GTEST_PROP(Axis, HasItsEndsExactly, ()) {
    const Axis axis = any_axis();
    RC_ASSERT(value_at(axis, 0) == axis.from);
    RC_ASSERT(value_at(axis, axis.points - 1) == axis.to);
}

RC_GTEST_PROP(Axis, Rises, ()) {
    const Axis axis = any_axis();
    for (int k = 1; k < axis.points; ++k)
        RC_ASSERT(value_at(axis, k) > value_at(axis, k - 1));
}

RC_GTEST_PROP(Axis, IsSpacedEvenly, ()) {
    Axis axis = any_axis();
    axis.scale = Scale::linear;
    const double width = (axis.to - axis.from) / (axis.points - 1);
    // a value carries the roundings of share, product and sum: 3 * 2^-53 of at most `to`
    for (int k = 1; k < axis.points; ++k)
        RC_ASSERT(std::abs(value_at(axis, k) - value_at(axis, k - 1) - width) <= 8.0 * 0x1p-53 * axis.to);
}

RC_GTEST_PROP(LogarithmicAxis, HasEqualRatios, ()) {
    Axis axis = any_axis();
    axis.scale = Scale::logarithmic;
    const double ratio = std::pow(axis.to / axis.from, 1.0 / (axis.points - 1));
    // the exponent, at most 40, is rounded thrice: relative error 40 ln 2 * 3 * 2^-53 = 1e-14, twice that in a ratio
    for (int k = 1; k < axis.points; ++k)
        RC_ASSERT(std::abs(value_at(axis, k) / value_at(axis, k - 1) / ratio - 1.0) < 3e-14);
}

RC_GTEST_PROP(Place, IsTheInverseOfTheIndex, ()) {
    Study study = small_study();
    study.x.points = *whole_between(2, 9);
    study.y.points = *whole_between(2, 9);
    std::size_t index = 0;
    // the order that files and charts rely on
    for (std::size_t direction = 0; direction < 2; ++direction)
        for (int iy = 0; iy < study.y.points; ++iy)
            for (int ix = 0; ix < study.x.points; ++ix, ++index) {
                const CellPlace place = place_of(study, index);
                RC_ASSERT(place.direction == direction && place.iy == iy && place.ix == ix);
                RC_ASSERT(index_of(study, place) == index);
            }
    RC_ASSERT(cell_count(study) == index);
}

TEST(CaseAt, TakesTheAxesValues) {
    const Study study = small_study();
    const Case c = case_at(study, {0, 2, 1});
    EXPECT_EQ(c.contact().preload, value_at(study.x, 1));
    EXPECT_EQ(c.contact().kinetic_friction, 0.8);
}

TEST(CaseAt, TurnsAConstantDriveByTheDirection) {
    for (const double velocity : {0.1, -0.1}) {
        Study study = small_study();
        study.base.drive.velocity = velocity;
        EXPECT_EQ(case_at(study, {0, 0, 0}).drive.velocity, 0.1);
        EXPECT_EQ(case_at(study, {1, 0, 0}).drive.velocity, -0.1);
    }
}

TEST(CaseAt, TurnsAVelocityAxisToo) {
    Study study = small_study();
    study.y = {"drive.velocity", 0.01, 1.0, 3, Scale::linear};
    EXPECT_EQ(case_at(study, {0, 2, 0}).drive.velocity, 1.0);
    EXPECT_EQ(case_at(study, {1, 2, 0}).drive.velocity, -1.0);
}

TEST(Study, HoldsADesignWithinBothAxesOnly) {
    Study study = small_study();
    study.x = {"contact.preload", 10.0, 30.0, 3, Scale::linear};
    study.y = {"drive.velocity", 0.05, 0.2, 2, Scale::linear};
    const auto holds = [&](double preload, double velocity) {
        study.base.contact().preload = preload;
        study.base.drive.velocity = velocity;
        return holds_design(study);
    };
    EXPECT_TRUE(holds(20.0, 0.1));
    EXPECT_TRUE(holds(10.0, 0.2)) << "a corner";
    EXPECT_TRUE(holds(30.0, -0.05)) << "the axis is of speeds, the sign is the direction";
    EXPECT_FALSE(holds(9.0, 0.1));
    EXPECT_FALSE(holds(31.0, 0.1));
    EXPECT_FALSE(holds(20.0, 0.04));
    EXPECT_FALSE(holds(20.0, 0.21));
}

TEST(CaseAt, LeavesADriveThatGoesBothWaysAlone) {
    Study study = small_study();
    study.base.drive.kind = parameters::DriveKind::sinusoidal;
    EXPECT_EQ(case_at(study, {1, 0, 0}).drive.velocity, study.base.drive.velocity);
    EXPECT_EQ(case_at(study, {1, 0, 0}).drive.amplitude, study.base.drive.amplitude);
}

TEST(CaseAt, TakesTheStart) {
    Study study = small_study();
    study.base.run.initial = Initial::stuck;
    EXPECT_EQ(case_at(study, {0, 0, 0}).run.initial, Initial::stuck);
    study.starts = {Initial::rest, Initial::sliding};
    EXPECT_EQ(case_at(study, {0, 0, 0}).run.initial, Initial::rest);
    EXPECT_EQ(case_at(study, {1, 0, 0, 1}).run.initial, Initial::sliding);
}

TEST(CanonicalText, IsBlindToWhatChangesNoResult) {
    const std::string text = canonical_text(small_study());
    Study study = small_study();
    study.base.title = "another title";
    study.quantities = {"frequency"};
    study.base.contact().preload = 77.0;
    study.base.contact().kinetic_friction = 0.77;
    study.base.drive.velocity = -study.base.drive.velocity;
    EXPECT_EQ(canonical_text(study), text);
}

TEST(CanonicalText, ShowsEveryOtherQuantityOfTheCase) {
    const Study before = small_study();
    for (const parameters::Field& field : parameters::fields()) {
        const bool is_axis =
            parameters::key_of(field) == before.x.parameter || parameters::key_of(field) == before.y.parameter;
        const bool is_quantity = std::holds_alternative<parameters::Quantity>(field.kind);
        if (is_axis || !is_quantity || !field.belongs(before.base)) continue;
        Study study = before;
        parameters::set_quantity(study.base, field, parameters::get_quantity(study.base, field) * (1.0 + 1e-9));
        EXPECT_NE(canonical_text(study), canonical_text(before)) << parameters::key_of(field);
    }
}

TEST(CanonicalText, ShowsAxesAndDirections) {
    const std::string text = canonical_text(small_study());
    EXPECT_NE(text.find("chart.x = contact.preload, 4 points from 2 to 400, log\n"), std::string::npos) << text;
    EXPECT_NE(text.find("chart.y = contact.kinetic_friction, 3 points from 0.1 to 0.8, linear\n"), std::string::npos);
    EXPECT_NE(text.find("chart.directions = going coming\n"), std::string::npos);
    EXPECT_EQ(text.find("contact.preload = "), std::string::npos);
    EXPECT_EQ(text.find("contact.kinetic_friction = "), std::string::npos);
}

TEST(CanonicalText, ShowsRefinementAndStartsWhereThereAreAny) {
    Study study = small_study();
    const std::string before = canonical_text(study);
    EXPECT_EQ(before.find("chart.refine"), std::string::npos);
    EXPECT_EQ(before.find("chart.starts"), std::string::npos);
    study.refine = 2;
    EXPECT_EQ(canonical_text(study), before + "chart.refine = 2\n");
    study.starts = {Initial::sliding, Initial::rest};
    const std::string text = canonical_text(study);
    EXPECT_NE(text.find("\nchart.starts = sliding rest\n"), std::string::npos) << text;
    EXPECT_EQ(text.find("run.initial"), std::string::npos) << text;
    EXPECT_NE(text.find("run.perturbation"), std::string::npos) << "it counts for one of the starts";
    study.base.run.initial = Initial::stuck;
    EXPECT_EQ(canonical_text(study), text) << "the starts replace the case's own";
}

TEST(CanonicalText, LosesAnAxisThatStandsInItsFirstLine) {
    Study study = small_study();
    study.x = {"joint.mass", 0.1, 0.2, 2, Scale::linear};
    const std::string text = canonical_text(study);
    EXPECT_EQ(text.rfind("joint.axial_stiffness = ", 0), 0U) << text;
    EXPECT_NE(text.find("\ncontact.preload = "), std::string::npos);
}

// what a shell would hand to the program, for a command without quotes
Case case_of(const Study& study, std::string command) {
    Case c = study.base;
    const std::string option = " --set ";
    for (std::size_t at = command.find(option); at != std::string::npos; at = command.find(option, at)) {
        at += option.size();
        const std::size_t equals = command.find('=', at);
        const parameters::Field& field = *parameters::find_field(command.substr(at, equals - at));
        parameters::set_from_text(c, field, command.substr(equals + 1, command.find(' ', equals) - equals - 1));
    }
    return c;
}

RC_GTEST_PROP(ReproduceCommand, GivesTheCaseOfItsCellBitForBit, ()) {
    Study study = small_study();
    study.x = any_axis();
    const bool has_velocity_axis = *rc::gen::arbitrary<bool>();
    if (has_velocity_axis) study.y.parameter = "drive.velocity";
    const auto index = static_cast<std::size_t>(*whole_between(0, static_cast<int>(cell_count(study)) - 1));
    const CellPlace place = place_of(study, index);
    const Case expected = case_at(study, place);
    const Case c = case_of(study, reproduce_command(study, place, "chart.toml"));
    for (const std::string& key : {study.x.parameter, study.y.parameter, std::string("drive.velocity")}) {
        const parameters::Field& field = *parameters::find_field(key);
        RC_ASSERT(same_bits(parameters::get_quantity(c, field), parameters::get_quantity(expected, field)));
    }
}

TEST(Preview, AsksForLessAndStaysAStudyThatCanBeComputed) {
    Study study = small_study();
    study.x.points = 200;
    study.refine = 5;
    const Study quick = preview(study);
    EXPECT_EQ(quick.x.points, 64);
    EXPECT_EQ(quick.y.points, 3) << "not more than there were";
    EXPECT_EQ(quick.refine, 5);
    EXPECT_EQ(quick.base.run.duration, 0.25 * study.base.run.duration);
    EXPECT_EQ(quick.base.run.window, 0.5 * quick.base.run.duration);
    EXPECT_NO_THROW(check(quick));
    // of few points none is left out: an island between four corners that agree is not looked for
    study.refine = 0;
    EXPECT_EQ(preview(study).refine, 0);
    study.y.points = 16;
    EXPECT_EQ(preview(study).refine, 1);
    study.y.points = 64;
    EXPECT_EQ(preview(study).refine, 3);
    // a sinusoidal drive keeps two of its five periods: each phase occurs
    study.base = parameters::paper_case(parameters::PaperCase::squeal);
    EXPECT_EQ(preview(study).base.run.duration, 0.4);
    EXPECT_EQ(preview(study).base.run.window, 0.4);
    EXPECT_NO_THROW(check(preview(study)));
}

TEST(ReproduceCommand, NamesTheFileAndEachSettingOnce) {
    Study study = small_study();
    EXPECT_EQ(reproduce_command(study, {1, 2, 0}, "chart.toml"),
              "stridor simulate chart.toml --set contact.preload=2 --set contact.kinetic_friction=0.8 --set "
              "drive.velocity=-0.1");
    study.starts = {Initial::rest, Initial::sliding};
    EXPECT_EQ(reproduce_command(study, {1, 2, 0, 1}, "chart.toml"),
              "stridor simulate chart.toml --set contact.preload=2 --set contact.kinetic_friction=0.8 --set "
              "drive.velocity=-0.1 --set run.initial=sliding");
    study.starts.clear();
    study.base.drive.kind = parameters::DriveKind::sinusoidal;
    EXPECT_EQ(reproduce_command(study, {1, 2, 0}, "my chart's.toml"),
              "stridor simulate 'my chart'\\''s.toml' --set contact.preload=2 --set contact.kinetic_friction=0.8");
}

// what ready_charts.hpp says of them; every cell is a case that can be run
TEST(PaperCharts, HoldTheRangesTheyPromise) {
    EXPECT_EQ(cell_count(figure_8()), 2U * 40U * 40U);
    EXPECT_EQ(cell_count(figure_6(70.0)), 30U * 30U);
    for (const double angle : {70.0, 150.0}) {
        const parameters::Case first = case_at(figure_6(angle), {0, 0, 0, 0});
        const parameters::Case last = case_at(figure_6(angle), {0, 29, 29, 0});
        EXPECT_EQ(first.joint().incidence_angle, angle);
        EXPECT_EQ(last.joint().incidence_angle, angle);
        EXPECT_EQ(first.drive.velocity, 0.01);
        EXPECT_EQ(last.drive.velocity, 1.0);
        EXPECT_EQ(first.contact().preload, 2.0);
        EXPECT_EQ(last.contact().preload, 4000.0);
    }
    for (const Study& study : {figure_8(), figure_6(70.0), figure_6(150.0)})
        for (std::size_t index = 0; index < cell_count(study); ++index) {
            const parameters::Case c = case_at(study, place_of(study, index));
            EXPECT_TRUE(parameters::findings(c).empty()) << study.base.title << " " << index;
            EXPECT_EQ(c.drive.velocity < 0.0, place_of(study, index).direction == 1);
        }
}

// a designer who varies a stiffness means the same material: its damping ratio stays
TEST(Study, KeepsDampingRatiosAlongItsAxes) {
    Study study = figure_8();
    parameters::set_from_text(study.base, *parameters::find_field("plate.damping"), "5 %");
    study.x = {"plate.stiffness", 1e5, 1e7, 3, Scale::logarithmic};
    for (int ix = 0; ix < 3; ++ix) {
        const parameters::Case c = case_at(study, {0, 0, ix, 0});
        EXPECT_EQ(c.plate.damping, 2.0 * 0.05 * std::sqrt(c.plate.stiffness * c.plate.mass));
    }
    EXPECT_NE(canonical_text(study).find("plate.damping = damping ratio 0.05"), std::string::npos);
}

// Table 1's joint twice, over something of the second one
Study study_of_two_joints() {
    Study study = small_study();
    study.base = parameters::two_lips();
    study.x = {"joint.lower.contact.preload", 2.0, 400.0, 4, Scale::logarithmic};
    study.y = {"joint.upper.incidence_angle", 30.0, 80.0, 3, Scale::linear};
    return study;
}

TEST(Study, OfSeveralJointsSetsTheOneThatAnAxisNames) {
    const Study study = study_of_two_joints();
    check(study);
    const Case c = case_at(study, {0, 2, 3});
    EXPECT_EQ(c.joints[1].contact.preload, 400.0);
    EXPECT_EQ(c.contact().preload, 200.0);
    EXPECT_EQ(c.joint().incidence_angle, 80.0);
    EXPECT_EQ(c.joints[1].joint.incidence_angle, 60.0);
    EXPECT_NE(reproduce_command(study, {0, 2, 3}, "two.toml").find("--set joint.lower.contact.preload=400"),
              std::string::npos);
    EXPECT_TRUE(holds_design(study));
}

TEST(Study, OfSeveralJointsSetsAllOfThemByAKeyWithoutAName) {
    Study study = study_of_two_joints();
    study.x.parameter = "contact.preload";
    check(study);
    const Case c = case_at(study, {0, 0, 0});
    EXPECT_EQ(c.contact().preload, 2.0);
    EXPECT_EQ(c.joints[1].contact.preload, 2.0);
    // what the axis sets is no part of what the results belong to
    Study other = study;
    other.base.joints[1].contact.preload = 77.0;
    EXPECT_EQ(canonical_text(other), canonical_text(study));
    EXPECT_FALSE(holds_design(other));
}

TEST(Study, OfSeveralJointsIsOfOtherCasesWithAnotherJointsAxis) {
    const Study study = study_of_two_joints();
    const std::string text = canonical_text(study);
    EXPECT_EQ(text.find("joint.lower.contact.preload = "), std::string::npos);
    EXPECT_NE(text.find("joint.upper.contact.preload = 200 N"), std::string::npos);
    EXPECT_NE(text.find("chart.x = joint.lower.contact.preload, 4 points"), std::string::npos);
}

TEST(Study, OfSeveralJointsOverOneAxisRestsAtTheFirstOnesOwnValue) {
    Study study = study_of_two_joints();
    for (const char* key : {"plate.mass", "contact.preload", "joint.upper.contact.preload"}) {
        study.x = {key, 0.1, 1.0, 3, Scale::linear};
        study.y = resting_axis(study.base, study.x);
        check(study);
        const Case c = case_at(study, {0, 0, 1});
        Case by_hand = study.base;
        parameters::set_quantity(by_hand, key, value_at(study.x, 1));
        by_hand.drive.velocity = 0.1;
        EXPECT_EQ(parameters::canonical_text(c), parameters::canonical_text(by_hand)) << key;
    }
}

TEST(Study, RefusesJointsThatAreNotThereAndAxesThatOverlap) {
    Study missing = study_of_two_joints();
    missing.x.parameter = "joint.lowr.contact.preload";
    EXPECT_TRUE(thrown_by([&] { check(missing); }).says("Did you mean joint.lower?"));
    Study both = study_of_two_joints();
    both.y = {"contact.preload", 1.0, 2.0, 3, Scale::linear};
    EXPECT_TRUE(thrown_by([&] { check(both); }).says("overlap"));
}

}  // namespace
}  // namespace stridor::sweep
