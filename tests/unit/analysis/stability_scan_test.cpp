#include "stridor/analysis/stability_scan.hpp"

#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/verification/table_1.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace stridor::analysis {
namespace {

// stable below 1/3, flutter up to 2/3, divergence above
SlidingStability by_thirds(double value) {
    SlidingStability stability;
    stability.kind = value < 1.0 / 3.0   ? StabilityKind::stable
                     : value < 2.0 / 3.0 ? StabilityKind::flutter
                                         : StabilityKind::divergence;
    stability.frequency = value;
    return stability;
}

TEST(StabilityPath, BisectsEachChangeOfKind) {
    const StabilityPath path = stability_path(by_thirds, 0.0, 1.0, 11);
    ASSERT_EQ(path.boundaries.size(), 2U);
    EXPECT_NEAR(path.boundaries[0].value, 1.0 / 3.0, 1e-12);
    EXPECT_EQ(path.boundaries[0].below, StabilityKind::stable);
    EXPECT_EQ(path.boundaries[0].above, StabilityKind::flutter);
    EXPECT_NEAR(path.boundaries[0].frequency, 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(path.boundaries[1].value, 2.0 / 3.0, 1e-12);
    EXPECT_EQ(path.boundaries[1].above, StabilityKind::divergence);
}

TEST(StabilityPath, IncludesBothEnds) {
    const StabilityPath path = stability_path(by_thirds, 0.1, 0.3, 3);
    ASSERT_EQ(path.points.size(), 3U);
    EXPECT_EQ(path.points.front().value, 0.1);
    EXPECT_EQ(path.points.back().value, 0.3);
    EXPECT_TRUE(path.boundaries.empty());
}

TEST(StabilityPath, FindsTheBoundariesOfTable1) {
    const auto at = [](double mu) {
        parameters::Case c;
        c.contact().kinetic_friction = mu;
        return sliding_stability(model::rubbing_system(c), parameters::Direction::going);
    };
    const StabilityPath path = stability_path(at, 0.0, 5.0, 51);
    ASSERT_EQ(path.boundaries.size(), 3U);
    EXPECT_NEAR(path.boundaries[0].value, verification::damped_flutter_onset, 5e-6);
    EXPECT_EQ(path.boundaries[0].above, StabilityKind::flutter);
    EXPECT_NEAR(path.boundaries[1].value, verification::undamped_divergence_onset,
                5e-3);  // undamped; damping shifts it by some 1e-3
    EXPECT_EQ(path.boundaries[1].above, StabilityKind::divergence);
    EXPECT_NEAR(path.boundaries[2].value, verification::locking_onset, 5e-4);
    EXPECT_EQ(path.boundaries[2].above, StabilityKind::locked);
}

using parameters::Direction;
using support::thrown_by;

const parameters::Case squeal = parameters::paper_case(parameters::PaperCase::squeal);

TEST(StabilityScan, IsOfTheCaseInBothDirections) {
    const StabilityScan scan = scan_stability(squeal, std::nullopt);
    EXPECT_TRUE(scan.key.empty());
    ASSERT_EQ(scan.directions.size(), 2U);
    EXPECT_EQ(scan.directions[0].direction, Direction::going);
    EXPECT_EQ(scan.directions[1].direction, Direction::coming);
    for (const DirectionScan& each : scan.directions) {
        EXPECT_TRUE(each.path.points.empty());
        EXPECT_EQ(each.here.growth, sliding_stability(model::rubbing_system(squeal), each.direction).growth);
    }
}

TEST(StabilityScan, FollowsAQuantityByAnyOfItsNames) {
    const StabilityScan scan = scan_stability(squeal, ScanRange{"mu_d", 0.1, 0.5, 5});
    EXPECT_EQ(scan.key, "contact.kinetic_friction");
    EXPECT_EQ(scan.unit, "1");
    parameters::Case last = squeal;
    last.contact().kinetic_friction = 0.5;
    for (const DirectionScan& each : scan.directions) {
        ASSERT_EQ(each.path.points.size(), 5U);
        EXPECT_EQ(each.path.points.front().value, 0.1);
        EXPECT_EQ(each.path.points.back().value, 0.5);
        EXPECT_EQ(each.path.points.back().stability.growth,
                  sliding_stability(model::rubbing_system(last), each.direction).growth);
    }
}

TEST(StabilityScan, RefusesRangesThatAreNone) {
    const auto refusal = [](const ScanRange& range) {
        const auto thrown = thrown_by([&] { scan_stability(squeal, range); });
        EXPECT_EQ(thrown.kind, ErrorKind::input);
        return thrown;
    };
    EXPECT_TRUE(refusal({"mu_d", 0.5, 0.1, 5}).says("Swap the ends?"));
    EXPECT_FALSE(refusal({"mu_d", 0.5, 0.5, 5}).says("Swap the ends?"));
    EXPECT_TRUE(refusal({"mu_d", 0.1, 0.5, 1}).says("at 1 points"));
    EXPECT_TRUE(refusal({"mu_d", 0.1, 0.5, most_scan_points + 1}).says("100000 points do"));
    EXPECT_TRUE(refusal({"drive.velocity", 0.1, 0.5, 5}).says("changes nothing")) << "the drive is sinusoidal";
    EXPECT_TRUE(refusal({"joint.mass", -1.0, 0.5, 5}).says("mass"));
    EXPECT_NO_THROW(scan_stability(squeal, ScanRange{"mu_d", 0.1, 0.5, 2}));
}

TEST(StabilityScan, FollowsAKeyOfOneOfSeveralJoints) {
    const parameters::Case c = parameters::two_lips();
    const StabilityScan scan = scan_stability(c, ScanRange{"joint.lower.alpha", 40.0, 80.0, 3});
    EXPECT_EQ(scan.key, "joint.lower.incidence_angle");
    EXPECT_EQ(scan.unit, "deg");
    parameters::Case last = c;
    last.joints[1].joint.incidence_angle = 80.0;
    for (const DirectionScan& each : scan.directions)
        EXPECT_EQ(each.path.points.back().stability.growth,
                  sliding_stability(model::rubbing_system(last), each.direction).growth);
    const auto thrown = thrown_by([&] { scan_stability(c, ScanRange{"joint.lowr.alpha", 40.0, 80.0, 3}); });
    EXPECT_TRUE(thrown.says("Did you mean joint.lower?"));
}

// a mass on two springs: its frequency follows the root of the stiffness
TEST(StabilityScan, FollowsAnOwnStructure) {
    parameters::OwnStructure own{.row = {"x", "y"}, .mass = {4, 0, 0, 1}, .stiffness = {100, 0, 0, 50}};
    own.contacts.push_back({.name = "foot", .normal = {0, 1}, .tangent = {1, 0}, .preload_share = 1.0});
    parameters::Case c;
    c.own_structure = std::make_shared<const parameters::OwnStructure>(own);
    const StabilityScan scan = scan_stability(c, ScanRange{"structure.stiffness_scale", 1.0, 4.0, 2});
    for (const DirectionScan& each : scan.directions) {
        ASSERT_EQ(each.here.modes.size(), 1U);
        EXPECT_NEAR(each.here.frequency, 5.0 / 6.283185307179586, 1e-12);
        EXPECT_NEAR(each.path.points.back().stability.frequency, 10.0 / 6.283185307179586, 1e-12);
    }
}

}  // namespace
}  // namespace stridor::analysis
