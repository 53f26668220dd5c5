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

HeardRecording heard(const char* source, std::vector<Category> expected, Category category, double probability) {
    HeardRecording recording;
    recording.expectation.file = std::string(source) + ".wav";
    recording.expectation.source = source;
    recording.expectation.categories = std::move(expected);
    recording.expectation.words = recording.expectation.categories.size() > 1 ? "squeal|squeak" : "one";
    recording.heard = category;
    recording.probability = probability;
    return recording;
}

const RightShare& share(const RecordingScore& score, std::string_view what) {
    for (const RightShare& each : score.shares)
        if (each.what == what) return each;
    ADD_FAILURE() << what;
    return score.shares.front();
}

TEST(RecordingScore, CountsByKind) {
    std::vector<HeardRecording> recordings{
        heard("a", {Category::creak}, Category::creak, 0.9), heard("a", {Category::creak}, Category::none, 0.55),
        heard("b", {Category::squeal, Category::squeak}, Category::squeak, 0.7),
        heard("c", {Category::none}, Category::squeal, 0.45), heard("c", {Category::squeal}, Category::squeak, 0.95)};
    recordings.back().expectation.is_sure = false;
    const RecordingScore score = score_of(recordings);
    EXPECT_EQ(share(score, "all").right, 2U);
    EXPECT_EQ(share(score, "all").count, 5U);
    EXPECT_EQ(share(score, "sure of the label").count, 4U);
    EXPECT_EQ(share(score, "creaks, sure").right, 1U);
    EXPECT_EQ(share(score, "creaks, sure").count, 2U);
    EXPECT_EQ(share(score, "tones, sure").right, 1U);
    EXPECT_EQ(share(score, "none, sure").right, 0U);
    EXPECT_EQ(share(score, "squeal or squeak, of those heard as tones").count, 1U);
    ASSERT_EQ(score.rows.size(), 2U);
    EXPECT_EQ(score.rows[0].heard[static_cast<std::size_t>(Category::squeak)], 1U);
    ASSERT_EQ(score.decided.front().decided, 5U);
    EXPECT_EQ(score.decided.back().probability, 0.9);
    EXPECT_EQ(score.decided.back().decided, 2U);
    EXPECT_EQ(score.decided.back().right, 1U);
    EXPECT_EQ(score.bins.front().count, 1U);
    EXPECT_DOUBLE_EQ(score.bins.front().probability, 0.45);
    // each recording lies in one bin, and the surer the fewer
    std::size_t binned = 0;
    for (const CalibrationBin& bin : score.bins) {
        EXPECT_LT(bin.from, bin.to);
        binned += bin.count;
    }
    EXPECT_EQ(binned, 5U);
    for (std::size_t k = 1; k < score.decided.size(); ++k) {
        EXPECT_GT(score.decided[k].probability, score.decided[k - 1].probability);
        EXPECT_LE(score.decided[k].decided, score.decided[k - 1].decided);
    }
}

TEST(RecordingScore, DrawsSourcesAndNotRecordings) {
    std::vector<HeardRecording> one_source;
    std::vector<HeardRecording> many_sources;
    for (int k = 0; k < 40; ++k) {
        const Category category = k % 2 == 0 ? Category::creak : Category::none;
        one_source.push_back(heard("a", {Category::creak}, category, 0.5));
        many_sources.push_back(heard(std::to_string(k).c_str(), {Category::creak}, category, 0.5));
    }
    const RightShare together = score_of(one_source).shares.front();
    EXPECT_EQ(together.low, 0.5);
    EXPECT_EQ(together.high, 0.5);
    const RightShare apart = score_of(many_sources).shares.front();
    EXPECT_NEAR(apart.low, 0.35, 0.05);  // 0.5 - 1.96 sqrt(0.25 / 40)
    EXPECT_NEAR(apart.high, 0.65, 0.05);
    EXPECT_EQ(score_of(many_sources).shares.front().low, apart.low);
}

TEST(RecordingScore, SaysNothingOfProbabilitiesWithoutAnEar) {
    const std::vector<HeardRecording> by_rules{heard("a", {Category::creak}, Category::creak, 0.0)};
    EXPECT_TRUE(score_of(by_rules).bins.empty());
    EXPECT_TRUE(score_of(by_rules).decided.empty());
}

}  // namespace
}  // namespace stridor::hearing
