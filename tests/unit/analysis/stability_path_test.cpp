#include "stridor/analysis/stability_path.hpp"

#include "stridor/model/rubbing_system.hpp"
#include "stridor/verification/sliding.hpp"

#include <gtest/gtest.h>

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
        c.contact.kinetic_friction = mu;
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

}  // namespace
}  // namespace stridor::analysis
