#include "stridor/signal/source.hpp"

#include "stridor/base/error.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace stridor::signal {
namespace {

std::vector<Signal> counted(std::size_t channels, std::size_t frames) {
    std::vector<Signal> result(channels, Signal{48000.0, "Pa", std::vector<double>(frames)});
    for (std::size_t k = 0; k < channels; ++k)
        std::iota(result[k].samples.begin(), result[k].samples.end(), 1000.0 * static_cast<double>(k));
    return result;
}

TEST(Source, GivesItsChannelsBack) {
    for (const std::size_t frames : {std::size_t{0}, std::size_t{1}, std::size_t{40000}}) {
        const std::vector<Signal> channels = counted(3, frames);
        const std::unique_ptr<Source> source = source_of(channels);
        EXPECT_EQ(source->layout().frames, frames);
        const std::vector<Signal> back = read_all(*source);
        ASSERT_EQ(back.size(), channels.size());
        for (std::size_t k = 0; k < channels.size(); ++k) {
            EXPECT_EQ(back[k].samples, channels[k].samples);
            EXPECT_EQ(back[k].unit, "Pa");
            EXPECT_EQ(back[k].rate, 48000.0);
        }
    }
}

TEST(Source, FillsBlocksFrameByFrame) {
    const std::unique_ptr<Source> source = source_of(counted(2, 5));
    std::vector<double> block(6);
    EXPECT_EQ(source->read(block), 3U);
    EXPECT_EQ(block, (std::vector<double>{0, 1000, 1, 1001, 2, 1002}));
    EXPECT_EQ(source->read(block), 2U);
    EXPECT_EQ(block[0], 3.0);
    EXPECT_EQ(source->read(block), 0U);
}

TEST(Source, RefusesToHoldMoreThanTheLimit) {
    EXPECT_THROW(read_all(*source_of(counted(2, 6)), 11), Error);
    EXPECT_NO_THROW(read_all(*source_of(counted(2, 6)), 12));
}

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
