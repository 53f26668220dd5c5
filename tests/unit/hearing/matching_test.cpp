#include "stridor/hearing/sound_search.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/error_text.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

namespace stridor::hearing {
namespace {

using support::thrown_by;

classification::ComparedSound recording_in(const std::string& unit, double rate = 44100.0) {
    classification::ComparedSound sound;
    sound.name = "a.wav";
    sound.rate = rate;
    sound.analysis.unit = unit;
    return sound;
}

TEST(MatchingRate, IsThatOfTheRecordingWithinWhatIsRendered) {
    EXPECT_EQ(matching_rate(recording_in("Pa", 44099.7)), 44100.0);
    EXPECT_EQ(matching_rate(recording_in("Pa", 4000.0)), 8000.0);
    EXPECT_EQ(matching_rate(recording_in("Pa", 1e6)), 192000.0);
}

TEST(Matchable, IsNothingShorterThanAStretch) {
    EXPECT_TRUE(thrown_by([] { require_matchable(recording_in("Pa")); }).says("a.wav is too short to be matched"));
}

TEST(ComparableLevel, IsOneOfTheSameMotion) {
    EXPECT_NO_THROW(require_comparable_level(recording_in("m/s"), signal::MotionQuantity::velocity));
    EXPECT_TRUE(thrown_by([] {
                    require_comparable_level(recording_in("Pa"), signal::MotionQuantity::velocity);
                }).says("a sound pressure would need a model of radiation"));
}

TEST(RuledOut, NeedsAStore) {
    const support::ScratchFolder folder;
    const support::Thrown thrown =
        thrown_by([&] { ruled_out(sweep::figure_8(), folder / "none.sqlite", classification::Category::squeal); });
    EXPECT_EQ(thrown.kind, ErrorKind::io);
}

TEST(SimulatedOf, HearsTheDirectionOfTheCell) {
    SoundMatch match;
    match.cell.index = 0;
    const SimulatedSound sound = simulated_of(sweep::figure_8(), match);
    EXPECT_FALSE(sound.stretches.empty());
    EXPECT_GT(sound.c.drive.velocity, 0.0);
}

}  // namespace
}  // namespace stridor::hearing
