#include "stridor/hearing/heard_recordings.hpp"

#include "stridor/recordings/audio/wav.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

namespace stridor::hearing {
namespace {

using classification::Category;

// half a second of a pure tone of 1 kHz
Expectation tone_in(const support::ScratchFolder& folder) {
    signal::Signal tone{16000.0, "Pa", std::vector<double>(8000)};
    for (std::size_t k = 0; k < tone.samples.size(); ++k)
        tone.samples[k] = 0.5 * std::sin(2.0 * std::numbers::pi * 1000.0 * static_cast<double>(k) / tone.rate);
    const std::string file = (folder / "tone.wav").string();
    recordings::write_wav(file, *signal::source_of({tone}), {});
    return {file, "squeal", {Category::squeal}};
}

TEST(HeardRecordings, AreRightWhereAnExpectedCategoryIsHeard) {
    const HeardRecording heard{{"a.wav", "squeak or creak", {Category::squeak, Category::creak}}, Category::creak, ""};
    EXPECT_TRUE(is_right(heard));
    EXPECT_FALSE(is_right({heard.expectation, Category::squeal, ""}));
}

TEST(HeardRecordings, AreHeardToTheirEnd) {
    const support::ScratchFolder folder;
    std::vector<std::string> begun;
    std::size_t ended = 0;
    RecordingHearing hearing;
    hearing.begin = [&](const std::string& file) { begun.push_back(file); };
    hearing.end = [&] { ++ended; };
    const std::vector<Expectation> expected{tone_in(folder)};
    const std::vector<HeardRecording> heard = hear(expected, hearing);
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard.front().heard, Category::squeal) << heard.front().reason;
    EXPECT_EQ(begun, std::vector<std::string>{expected.front().file});
    EXPECT_EQ(ended, 1U);
}

TEST(HeardRecordings, AreNotHeardAgainWhereTheyAreKept) {
    const support::ScratchFolder folder;
    const std::vector<Expectation> expected{tone_in(folder)};
    const std::filesystem::path file = folder / "kept.sqlite";
    storage::KeptResults(file, heard_text(expected, {}), "test").keep(0, "creak 0.5 as it was kept");
    storage::KeptResults kept(file, heard_text(expected, {}), "test");
    RecordingHearing hearing;
    hearing.kept = &kept;
    const std::vector<HeardRecording> heard = hear(expected, hearing);
    EXPECT_EQ(heard.front().heard, Category::creak);
    EXPECT_EQ(heard.front().reason, "as it was kept");
    EXPECT_EQ(heard.front().probability, 0.5);
}

TEST(HeardRecordings, AreOthersWithAnotherThreshold) {
    const support::ScratchFolder folder;
    const std::vector<Expectation> expected{tone_in(folder)};
    parameters::SoundThresholds other;
    other.creak_rest = 0.6;
    EXPECT_EQ(heard_text(expected, {}), heard_text(expected, {}));
    EXPECT_NE(heard_text(expected, {}), heard_text(expected, other));
}

TEST(HeardRecordings, StopOnRequest) {
    const support::ScratchFolder folder;
    std::stop_source source;
    source.request_stop();
    RecordingHearing hearing;
    hearing.stop = source.get_token();
    const std::vector<Expectation> expected{tone_in(folder)};
    EXPECT_EQ(support::thrown_by([&] { hear(expected, hearing); }).kind, ErrorKind::interrupted);
}

}  // namespace
}  // namespace stridor::hearing
