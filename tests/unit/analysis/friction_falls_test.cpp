#include "stridor/analysis/friction/falls.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace stridor::analysis {
namespace {

constexpr int climb = 200;
constexpr double slope = 0.005;  // per sample: from 0 to 1

// climbs evenly from 0 to 1, falls back within `length` samples, and climbs again
std::vector<double> climb_and_fall(int length) {
    std::vector<double> r;
    for (int k = 0; k <= climb; ++k)
        r.push_back(slope * k);
    for (int k = 1; k <= length; ++k)
        r.push_back(1.0 - static_cast<double>(k) / length);
    for (int k = 1; k <= climb / 2; ++k)
        r.push_back(slope * k);
    return r;
}

TEST(Falls, GoFromThePeakToTheValley) {
    const std::vector<Fall> found = falls(climb_and_fall(10), {0.2, 0.0, 20});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].rise_from, 0U);
    EXPECT_EQ(found[0].peak, 200U);
    EXPECT_EQ(found[0].valley, 210U);
    // the samples within a tenth of the fall below the peak are still high
    EXPECT_EQ(found[0].onset, 201U);
}

TEST(Falls, AreAsLargeAsTheThresholdAndAsQuickAsTheLimit) {
    EXPECT_TRUE(falls(climb_and_fall(10), {1.01, 0.0, 20}).empty());
    // from 90 to 10 % of the way down 80 % of the samples
    EXPECT_EQ(falls(climb_and_fall(10), {0.2, 0.0, 8}).size(), 1U);
    EXPECT_TRUE(falls(climb_and_fall(10), {0.2, 0.0, 7}).empty());
    EXPECT_EQ(falls(climb_and_fall(100), {0.2, 0.0, 80}).size(), 1U);
    EXPECT_TRUE(falls(climb_and_fall(100), {0.2, 0.0, 79}).empty());
}

TEST(Falls, PassOverWhatIsNoNumber) {
    std::vector<double> r = climb_and_fall(10);
    r[0] = r[100] = r[205] = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Fall> found = falls(r, {0.2, 0.0, 20});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].peak, 200U);
    EXPECT_EQ(found[0].valley, 210U);
}

// it let go between the last high sample and the next
TEST(Release, IsHalfASampleOfTheClimbAboveTheLastHighSample) {
    std::vector<double> r = climb_and_fall(10);
    const Release release = release_of({0, 200, 200, 210}, r);
    EXPECT_NEAR(release.resolution, slope, 1e-12);
    EXPECT_NEAR(release.peak, 1.0 + 0.5 * slope, 1e-12);
    EXPECT_NEAR(release.kinetic, 0.5, 1e-12) << "the middle of an even fall";
    // a line needs neither all samples nor exact ones: noise that is symmetric about it leaves it
    r[190] = std::numeric_limits<double>::quiet_NaN();
    const Release with_gap = release_of({0, 200, 200, 210}, r);
    EXPECT_NEAR(with_gap.peak, 1.0 + 0.5 * slope, 1e-12);
    EXPECT_NEAR(with_gap.resolution, slope, 1e-12);
}

TEST(Release, OfAShortClimbIsThatOfItsLastTwoSamples) {
    const std::vector<double> r{0.0, 0.5, 0.7, 1.0, 0.2, 0.0, 0.3};
    const Release release = release_of({0, 3, 3, 5}, r);
    EXPECT_NEAR(release.resolution, 0.3, 1e-12);
    EXPECT_NEAR(release.peak, 1.15, 1e-12);
}

TEST(Release, OfAFallWithinOneSampleIsHalfwayDown) {
    const std::vector<double> r{0.0, 0.5, 1.0, 0.0, 0.5};
    const Release release = release_of({0, 2, 2, 3}, r);
    EXPECT_NEAR(release.kinetic, 0.5 * release.peak, 1e-12);
}

}  // namespace
}  // namespace stridor::analysis
