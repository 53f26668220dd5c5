#include "stridor/recordings/rig_channels.hpp"

#include "stridor/base/error.hpp"

#include <gtest/gtest.h>

namespace stridor::recordings {
namespace {

using signal::ChannelLayout;

TEST(AudibleChannels, ArePressuresBeforeAnythingElse) {
    EXPECT_EQ(audible_channels({1e4, {{"a", "m/s^2"}, {"b", "Pa"}, {"c", "Pa"}}, {}}),
              (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(audible_channels({1e4, {{"a", "m/s^2"}, {"b", "FS"}}, {}}), (std::vector<std::size_t>{0}));
}

TEST(AudibleChannels, LeaveForcesAndWhatDrivesOut) {
    EXPECT_TRUE(audible_channels({1e4, {{"force", "N"}}, {}}).empty());
    EXPECT_TRUE(audible_channels({1e4, {{"force", "N"}, {"v", "m/s"}}, {}}).empty());
    EXPECT_EQ(audible_channels({1e4, {{"Surface velocity", "m/s"}, {"joint", "m/s"}}, {}}),
              (std::vector<std::size_t>{1}));
}

TEST(FrictionChannels, AreWhatTheySayThemselves) {
    const ChannelLayout layout{1e3, {{"Normal force", "N"}, {"pull", "N"}, {"v", "m/s"}}, {}};
    const FrictionChannels found = friction_channels(layout).value();
    EXPECT_EQ(found.force, 1U);
    EXPECT_EQ(found.velocity, 2U);
    EXPECT_EQ(found.normal, 0U);
    EXPECT_FALSE(friction_channels({1e3, {{"a", "N"}, {"b", "N"}}, {}}).has_value());
}

TEST(FrictionChannels, FollowTheNamesThatAreGiven) {
    const ChannelLayout layout{1e3, {{"a", "N"}, {"b", "N"}, {"v", "m/s"}}, {}};
    EXPECT_EQ(friction_channels(layout, {.force = "b"}).force, 1U);
    EXPECT_EQ(friction_channels(layout, {.force = "1", .normal = "2"}).normal, 1U);
    EXPECT_THROW(friction_channels(layout, {}), Error);              // two may be it
    EXPECT_THROW(friction_channels(layout, {.force = "v"}), Error);  // no force
    EXPECT_THROW(friction_channels(layout, {.force = "4"}), Error);  // not there
}

TEST(UsualSpeed, IsThe95thPercentileWhateverTheSense) {
    std::vector<double> velocity;
    for (int k = 0; k <= 100; ++k)
        velocity.push_back(k % 2 == 0 ? k : -k);
    EXPECT_EQ(usual_speed(velocity), 95.0);
}

TEST(PickedChannels, PassOnThoseWantedInTheirOrder) {
    const auto source = signal::source_of({{10.0, "N", {1, 2, 3}}, {10.0, "N", {4, 5, 6}}, {10.0, "N", {7, 8, 9}}});
    PickedChannels picked(*source, {2, 0});
    EXPECT_EQ(picked.layout().channels.size(), 2U);
    std::vector<double> block(4);
    EXPECT_EQ(picked.read(block), 2U);
    EXPECT_EQ(block, (std::vector<double>{7, 1, 8, 2}));
    EXPECT_EQ(picked.read(block), 1U);
    EXPECT_EQ(block[0], 9.0);
}

}  // namespace
}  // namespace stridor::recordings
