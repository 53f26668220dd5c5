#include "stridor/signal/channel_name.hpp"

#include "support/error_text.hpp"

#include <gtest/gtest.h>

namespace stridor::signal {
namespace {

ChannelLayout three_channels() {
    ChannelLayout layout;
    layout.channels = {{"force", "N"}, {"", "Pa"}, {"2", "m/s"}};
    return layout;
}

TEST(ChannelName, IsANameFirstAndANumberThen) {
    EXPECT_EQ(channel_named(three_channels(), "force"), 0U);
    EXPECT_EQ(channel_named(three_channels(), "1"), 0U);
    EXPECT_EQ(channel_named(three_channels(), "2"), 2U);
    EXPECT_EQ(channel_named(three_channels(), "3"), 2U);
}

TEST(ChannelName, ThatNoneHasIsAnsweredWithThoseThereAre) {
    for (const char* name : {"0", "4", "-1", "1.0", "Force", "", "99999999999999999999"})
        EXPECT_TRUE(support::thrown_by([&] {
                        channel_named(three_channels(), name);
                    }).says("the recording has 1 \"force\" [N], 2 [Pa], 3 \"2\" [m/s]"))
            << name;
}

}  // namespace
}  // namespace stridor::signal
