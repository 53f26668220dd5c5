#include "stridor/analysis/stability_scan.hpp"

#include "stridor/model/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::analysis {
namespace {

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
    last.contact.kinetic_friction = 0.5;
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

}  // namespace
}  // namespace stridor::analysis
