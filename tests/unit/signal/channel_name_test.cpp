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

TEST(ChannelNamed, TellsALongNameInPart) {
    const ChannelLayout layout{1000.0, {{"left", "Pa"}}, 0};
    try {
        channel_named(layout, std::string(300, '9'));
        FAIL() << "there is no such channel";
    } catch (const Error& error) {
        EXPECT_LT(error.problem().what.size(), 100U);
        EXPECT_NE(error.problem().what.find("999..."), std::string::npos);
    }
    try {
        channel_named(layout, std::string(59, 'x') + "\u00E9\u00E9\u00E9");
        FAIL() << "there is no such channel";
    } catch (const Error& error) {
        EXPECT_NE(error.problem().what.find("x..."), std::string::npos) << "no half of a character";
    }
}

}  // namespace
}  // namespace stridor::signal
