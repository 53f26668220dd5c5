#include "stridor/advice/design_space.hpp"

#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"
#include "support/property.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace stridor::advice {
namespace {

using parameters::Case;
using parameters::DriveKind;
using support::Thrown;
using support::thrown_by;

const Case squeal_case = parameters::paper_case(parameters::PaperCase::squeal);

Case constant_drive(double velocity) {
    Case c = squeal_case;
    c.drive.kind = DriveKind::constant;
    c.drive.velocity = velocity;
    return c;
}

DesignParameter only_parameter(const Case& c, const AskedRange& asked) {
    return design_space(c, std::span(&asked, 1)).parameters.front();
}

Thrown refusal(const Case& c, const std::vector<AskedRange>& asked) {
    const Thrown thrown = thrown_by([&] { design_space(c, asked); });
    EXPECT_EQ(thrown.kind, ErrorKind::input);
    return thrown;
}

RC_GTEST_PROP(DesignParameter, TurnsSharesIntoValuesAndBack, ()) {
    const double low = *support::number_between(0.001, 10.0);
    const double factor = *support::number_between(1.5, 1000.0);
    const bool is_logarithmic = *rc::gen::arbitrary<bool>();
    const bool is_negative = *rc::gen::arbitrary<bool>();
    DesignParameter parameter{"contact.preload", low, low * factor,
                              is_logarithmic ? sweep::Scale::logarithmic : sweep::Scale::linear};
    if (is_negative) {
        parameter.from = -low * factor;
        parameter.to = -low;
    }
    const double share = *support::number_between(0.0, 1.0);
    const double value = value_at(parameter, share);
    RC_ASSERT(value >= parameter.from && value <= parameter.to);
    RC_ASSERT(std::abs(share_of(parameter, value) - share) < 1e-9);
    RC_ASSERT(value_at(parameter, 0.0) == parameter.from);
    RC_ASSERT(value_at(parameter, 1.0) == parameter.to);
}

TEST(DesignParameter, HasEqualRatiosOnALogarithmicScale) {
    const DesignParameter parameter{"contact.preload", 1.0, 10000.0, sweep::Scale::logarithmic};
    EXPECT_NEAR(value_at(parameter, 0.25), 10.0, 1e-12);
    EXPECT_NEAR(value_at(parameter, 0.5), 100.0, 1e-11);
    EXPECT_NEAR(share_of(parameter, 1000.0), 0.75, 1e-15);
}

TEST(DesignSpace, HoldsWhatADesignerVaries) {
    const DesignSpace space = design_space(squeal_case);
    std::vector<std::string> keys;
    for (const DesignParameter& parameter : space.parameters)
        keys.push_back(parameter.key);
    EXPECT_NE(std::find(keys.begin(), keys.end(), "joint.incidence_angle"), keys.end());
    EXPECT_NE(std::find(keys.begin(), keys.end(), "drive.amplitude"), keys.end());
    EXPECT_EQ(std::find(keys.begin(), keys.end(), "drive.velocity"), keys.end());
    EXPECT_EQ(std::find(keys.begin(), keys.end(), "run.duration"), keys.end());
    EXPECT_EQ(space.origin.size(), keys.size());
    EXPECT_EQ(space.phases, (std::vector{record::Phase::going, record::Phase::coming}));
}

// whoever uses a part moves it both ways, and nobody knows how that begins
TEST(DesignSpace, IsJudgedBothWaysAndFromEveryStart) {
    const std::vector both{record::Phase::going, record::Phase::coming};
    for (const double velocity : {0.1, -0.1}) {
        const DesignSpace space = design_space(constant_drive(velocity));
        EXPECT_EQ(space.phases, both);
        ASSERT_EQ(space.runs.size(), 6U);
        double going = 0.0, coming = 0.0;
        for (const DesignRun& run : space.runs) {
            const Case c = case_of(space.base, run);
            EXPECT_EQ(c.run.initial, run.start);
            (c.drive.velocity > 0.0 ? going : coming) += c.drive.velocity;
        }
        EXPECT_DOUBLE_EQ(going, 0.3);
        EXPECT_DOUBLE_EQ(coming, -0.3);
    }
    EXPECT_EQ(design_space(squeal_case).runs.size(), 3U) << "one run goes and comes";
    EXPECT_FALSE(design_space(squeal_case).runs.front().direction);
}

TEST(DesignSpace, BeginsWithTheCasesOwnStartAndLeavesOutWhatItDoesNotHave) {
    Case c = constant_drive(0.1);
    c.run.initial = parameters::Initial::stuck;
    EXPECT_EQ(starts_of(design_space(c)).front(), parameters::Initial::stuck);
    EXPECT_EQ(starts_of(design_space(c)).size(), 3U);
    c.drive.kind = DriveKind::trapezoidal;
    const std::vector<parameters::Initial> starts = starts_of(design_space(c));
    EXPECT_EQ(starts, (std::vector{parameters::Initial::stuck, parameters::Initial::rest})) << "it begins at V = 0";
}

TEST(DesignSpace, IsJudgedByWhatIsAskedForAlone) {
    const AskedRuns asked{{parameters::Direction::coming}, {parameters::Initial::rest}};
    const DesignSpace space = design_space(constant_drive(0.1), {}, asked);
    EXPECT_EQ(space.phases, std::vector{record::Phase::coming});
    ASSERT_EQ(space.runs.size(), 1U);
    EXPECT_LT(case_of(space.base, space.runs.front()).drive.velocity, 0.0);
    EXPECT_EQ(design_space(squeal_case, {}, asked).phases, std::vector{record::Phase::coming});
    Case still = constant_drive(0.1);
    still.drive.kind = DriveKind::trapezoidal;
    EXPECT_EQ(thrown_by([&] { design_space(still, {}, {{}, {parameters::Initial::sliding}}); }).kind, ErrorKind::input);
}

TEST(DesignSpace, LeavesTheDriveAloneUnlessAskedForIt) {
    const DesignSpace space = design_space(squeal_case);
    for (const std::size_t k : space.free)
        EXPECT_FALSE(space.parameters[k].key.starts_with("drive.")) << space.parameters[k].key;
    const std::vector<AskedRange> asked{{"drive.amplitude"}};
    EXPECT_EQ(design_space(squeal_case, asked).free, std::vector<std::size_t>{0});
}

TEST(DesignSpace, KeepsTheBitsOfWhatStays) {
    const DesignSpace space = design_space(squeal_case);
    EXPECT_EQ(parameters::canonical_text(case_of(space, design_at(space, space.origin))),
              parameters::canonical_text(squeal_case));
    Shares shares = space.origin;
    shares.front() = 0.0;
    const Case changed = case_of(space, design_at(space, shares));
    EXPECT_EQ(changed.joint().mass, space.parameters.front().from);
    EXPECT_EQ(changed.contact().preload, squeal_case.contact().preload);
}

TEST(DesignSpace, IsWidenedToHoldTheCase) {
    Case c = squeal_case;
    c.contact().preload = 9000.0;
    EXPECT_EQ(only_parameter(c, {"contact.preload"}).to, 90000.0);
    EXPECT_EQ(only_parameter(c, {"contact.preload", 1.0, 2.0}).to, 9000.0);
    c.plate.damping = 0.0;
    const DesignParameter damping = only_parameter(c, {"plate.damping"});
    EXPECT_EQ(damping.from, 0.0);
    EXPECT_EQ(damping.scale, sweep::Scale::linear);  // zero has no logarithm
}

// a lip a thousand times softer than Table 1 is looked at below its own stiffness, too
TEST(DesignSpace, LiesAroundTheCase) {
    Case c = squeal_case;
    c.joint().flexural_stiffness = 1500.0;
    const DesignParameter stiffness = only_parameter(c, {"joint.flexural_stiffness"});
    EXPECT_DOUBLE_EQ(stiffness.from, 150.0);
    EXPECT_DOUBLE_EQ(stiffness.to, 15000.0);
    EXPECT_NEAR(share_of(stiffness, 1500.0), 0.5, 1e-12);
}

TEST(DesignSpace, KeepsTheSignOfAVelocity) {
    const DesignParameter velocity = only_parameter(constant_drive(-0.1), {"drive.velocity"});
    EXPECT_EQ(velocity.from, -1.0);
    EXPECT_EQ(velocity.to, -0.01);
    EXPECT_NEAR(value_at(velocity, 0.5), -0.1, 1e-15);
    EXPECT_LT(value_at(velocity, 0.3), value_at(velocity, 0.4));
}

TEST(DesignSpace, AcceptsRangesOfSettings) {
    const DesignParameter slip = only_parameter(squeal_case, {"verdict.quiet_slip", 0.9, 0.99});
    EXPECT_EQ(slip.from, 0.9);
    EXPECT_EQ(slip.to, 0.99);
    EXPECT_TRUE(refusal(squeal_case, {{"verdict.quiet_slip"}}).says("has no usual range"));
}

TEST(QuantityNamed, TakesShortNamesAndSymbolsThatMeanOneThing) {
    EXPECT_EQ(quantity_key_called(squeal_case, "preload"), "contact.preload");
    EXPECT_EQ(quantity_key_called(squeal_case, "mu_d"), "contact.kinetic_friction");
    EXPECT_EQ(quantity_key_called(squeal_case, "amplitude"), "drive.amplitude");
    EXPECT_EQ(quantity_key_called(constant_drive(0.1), "velocity"), "drive.velocity");
}

TEST(QuantityNamed, SaysWhatItCannotTake) {
    EXPECT_TRUE(refusal(squeal_case, {{"mass"}}).says("joint.mass or plate.mass"));
    EXPECT_TRUE(refusal(squeal_case, {{"prelod"}}).says("Did you mean contact.preload?"));
    EXPECT_TRUE(refusal(squeal_case, {{"drive.velocity"}}).says("changes nothing"));
    EXPECT_TRUE(refusal(squeal_case, {{"velocity"}}).says("changes nothing"));
    EXPECT_TRUE(refusal(squeal_case, {{"drive.kind"}}).says("is no quantity"));
    EXPECT_TRUE(refusal(squeal_case, {{""}}).says("is no key of a case"));
}

TEST(DesignSpace, RefusesRangesThatAreNone) {
    EXPECT_TRUE(refusal(squeal_case, {{"preload", 50.0, 5.0}}).says("Swap them?"));
    EXPECT_TRUE(refusal(squeal_case, {{"preload", 5.0, 5.0}}).says("is no range"));
    EXPECT_TRUE(refusal(squeal_case, {{"preload", -5.0, 5.0}}).says("above 0 N"));
    EXPECT_TRUE(refusal(squeal_case, {{"preload"}, {"contact.preload"}}).says("asked for twice"));
    Case c = squeal_case;
    c.contact().kinetic_friction = 0.9;
    EXPECT_TRUE(refusal(c, {}).says("exceeds mu_s"));
}

TEST(DesignSpace, OfSeveralJointsHasEachWithItsOwnQuantities) {
    const DesignSpace space = design_space(parameters::two_lips());
    const auto has = [&](const char* key) {
        return std::any_of(space.parameters.begin(), space.parameters.end(),
                           [&](const DesignParameter& parameter) { return parameter.key == key; });
    };
    EXPECT_TRUE(has("joint.upper.incidence_angle"));
    EXPECT_TRUE(has("joint.lower.contact.preload"));
    EXPECT_TRUE(has("plate.mass"));
    EXPECT_FALSE(has("contact.preload"));
    EXPECT_EQ(parameters::canonical_text(case_of(space, design_at(space, space.origin))),
              parameters::canonical_text(parameters::two_lips()));
}

TEST(DesignSpace, OfSeveralJointsChangesTheJointThatIsNamed) {
    const std::vector<AskedRange> asked{{"joint.lower.F", 20.0, 400.0}, {"joint.upper.alpha", 30.0, 80.0}};
    const DesignSpace space = design_space(parameters::two_lips(), asked);
    const Case c = case_of(space, design_at(space, {1.0, 0.0}));
    EXPECT_EQ(c.joints[1].contact.preload, 400.0);
    EXPECT_EQ(c.contact().preload, 200.0);
    EXPECT_EQ(c.joint().incidence_angle, 30.0);
}

TEST(DesignSpace, OfSeveralJointsChangesAllThatAreAlikeAtOnce) {
    const std::vector<AskedRange> asked{{"preload", 20.0, 400.0}};
    const DesignSpace space = design_space(parameters::two_lips(), asked);
    const Case c = case_of(space, design_at(space, {1.0}));
    EXPECT_EQ(c.contact().preload, 400.0);
    EXPECT_EQ(c.joints[1].contact.preload, 400.0);
    // 70 and 60 degrees are no one design
    const Thrown differ = refusal(parameters::two_lips(), {{"incidence_angle"}});
    EXPECT_TRUE(differ.says("joint.incidence_angle is not the same for all joints: 70 deg, 60 deg"));
    EXPECT_TRUE(differ.says("joint.upper.incidence_angle, joint.lower.incidence_angle"));
    EXPECT_TRUE(refusal(parameters::two_lips(), {{"preload"}, {"joint.lower.preload"}}).says("asked for twice"));
    EXPECT_TRUE(refusal(parameters::two_lips(), {{"joint.third.preload"}}).says("there is no joint \"third\""));
}

}  // namespace
}  // namespace stridor::advice
