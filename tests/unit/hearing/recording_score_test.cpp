#include "stridor/hearing/recording_score.hpp"

#include <gtest/gtest.h>

namespace stridor::hearing {
namespace {

using classification::Category;

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
