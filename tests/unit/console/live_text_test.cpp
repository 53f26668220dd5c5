// What a live ear tells, as lines: the block of a terminal, gaps, stamps.

#include "stridor/console/results/live_text.hpp"

#include "stridor/io/sound/live_events.hpp"
#include "support/error_text.hpp"
#include "support/lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace stridor::console {

namespace {

using classification::Category;
using support::lines_of;

io::LiveInput input_of(std::size_t channels) {
    io::LiveInput input{"arecord hw:1,0", "16 bit, 48000 Hz", {48000.0, {}, {}}};
    for (std::size_t k = 0; k < channels; ++k)
        input.layout.channels.push_back({"", "Pa"});
    return input;
}

// a minute at 54 dB, its last two seconds at 94 dB and a creak
hearing::LiveCourse minute() {
    hearing::LiveCourse course;
    course.now = 1.0;
    course.seconds.assign(60, 1e-4);
    course.categories.assign(60, Category::none);
    for (std::size_t k = 58; k < 60; ++k) {
        course.seconds[k] = 1.0;
        course.categories[k] = Category::creak;
    }
    return course;
}

}  // namespace

TEST(LiveText, ShowsLevelAndNoisesOfTheLastMinute) {
    const std::vector<hearing::LiveCourse> courses{minute()};
    const auto lines = lines_of(live_block(input_of(1), courses, {3661.0, 1, 2, 1, ""}, 120));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_TRUE(lines[0].starts_with("1:01:01  arecord hw:1,0  2 noises, 1 gap")) << lines[0];
    EXPECT_NE(lines[1].find("94.0 dB re 20 uPa"), std::string::npos) << lines[1];
    EXPECT_TRUE(lines[1].ends_with("▁██")) << lines[1];
    EXPECT_EQ(lines[2], std::string(34 + 58, ' ') + "cc");  // below the two seconds
}

TEST(LiveText, SaysWhatSoundsNow) {
    std::vector<hearing::LiveCourse> courses{minute(), minute(), minute()};
    courses[0].guess = {Category::squeak, 0.738};
    courses[1].guess = {Category::creak, 0.0};  // of a motion
    courses[2].guess = {Category::undecided, 0.4};
    const auto lines = lines_of(live_block(input_of(3), courses, {}, 120));
    ASSERT_EQ(lines.size(), 7u);
    EXPECT_EQ(lines[2], "   now squeak 0.74" + std::string(16 + 58, ' ') + "cc");
    EXPECT_EQ(lines[4], "   now creak" + std::string(22 + 58, ' ') + "cc");
    EXPECT_EQ(lines[6], std::string(34 + 58, ' ') + "cc");
}

TEST(LiveText, KeepsTheLatestWhereATerminalIsNarrow) {
    const std::vector<hearing::LiveCourse> courses{minute()};
    const auto lines = lines_of(live_block(input_of(1), courses, {}, 55));
    EXPECT_TRUE(lines[1].ends_with("▁██")) << lines[1];
    EXPECT_EQ(lines[2], std::string(34 + 18, ' ') + "cc");
    for (const std::string& line : lines_of(live_block(input_of(1), courses, {}, 20)))
        EXPECT_LE(line.size(), 20u) << line;
    const std::vector<hearing::LiveCourse> many(11, minute());
    EXPECT_EQ(lines_of(live_block(input_of(11), many, {}, 20)).back(), "and 3 channels more");
}

TEST(LiveText, TellsGapsAndClips) {
    EXPECT_EQ(live_gap_line({1.5, 0.0125, "overrun"}), "gap at 1.500 s: 0.013 s are missing (overrun)");
    EXPECT_EQ(live_gap_line({1.5, {}, "nothing came for 5 s"}), "gap at 1.500 s: nothing came for 5 s");
    hearing::LiveNoise noise;
    noise.number = 2;
    noise.to = 3.0;
    noise.strongest.verdict.category = Category::creak;
    EXPECT_EQ(live_noise_line(noise, {"a.wav", 7, ""}),
              "noise 2: creak, 0.000 to 3.000 s, kept in a.wav, entry 7 of the library");
    EXPECT_EQ(live_noise_line(noise, {"", 0, "full"}), "noise 2: creak, 0.000 to 3.000 s, not kept: full");
}

TEST(LiveStamps, AreMomentsInUtc) {
    EXPECT_EQ(io::stamp_text(0.0), "1970-01-01T00:00:00.000Z");
    EXPECT_EQ(io::stamp_text(951782399.9996), "2000-02-29T00:00:00.000Z");
    for (const char* stamp : {"2026-11-27T15:42:25.123Z", "2024-02-29T23:59:59.999Z", "1999-12-31T00:00:00.500Z"})
        EXPECT_EQ(io::stamp_text(io::seconds_of_stamp(stamp)), stamp);
    EXPECT_EQ(io::stamp_text(io::seconds_of_stamp("2026-11-27T15:42:25Z")), "2026-11-27T15:42:25.000Z");
    for (const char* none : {"", "noon", "2026-02-30T00:00:00Z", "2026-11-27T24:00:00Z", "2026-11-27T15:42:25Z+1"})
        EXPECT_TRUE(support::thrown_by([&] { io::seconds_of_stamp(none); }).says("is no moment")) << none;
}

}  // namespace stridor::console
