#include "stridor/hearing/sound_comparison.hpp"

#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/paper_cases.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "support/error_text.hpp"

#include <gtest/gtest.h>

#include <array>

namespace stridor::hearing {
namespace {

using support::thrown_by;

NamedSound recording(double rate) {
    return {"a.wav", "a", "recording", RecordedSound{{}, {}, rate}};
}

NamedSound simulated_squeal() {
    parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    c.run.duration = 0.3;
    c.run.window = 0.3;
    return {"squeal.toml", "squeal", "simulation", SimulatedSound{c}};
}

TEST(CommonRate, IsTheLowestOfAllRecordings) {
    const std::array sounds{recording(44100.0), simulated_squeal(), recording(16000.0)};
    EXPECT_EQ(common_rate(sounds), 16000.0);
    EXPECT_TRUE(is_resampled(sounds[0], 16000.0));
    EXPECT_FALSE(is_resampled(sounds[1], 16000.0));
    EXPECT_FALSE(is_resampled(sounds[2], 16000.0));
}

TEST(CommonRate, IsThatOfSimulationsWhereNothingIsRecorded) {
    const std::array sounds{simulated_squeal(), simulated_squeal()};
    EXPECT_EQ(common_rate(sounds), 48000.0);
}

TEST(Comparable, AreTwoToEightSounds) {
    for (const std::size_t number : {0U, 1U, 9U})
        EXPECT_TRUE(thrown_by([&] { require_comparable(number); }).says("it takes 2 to 8")) << number;
    EXPECT_NO_THROW(require_comparable(2));
    EXPECT_NO_THROW(require_comparable(8));
}

TEST(Compared, KnowsTheContactOfASimulationWithinItsDetail) {
    ComparisonSettings settings;
    settings.rate = 16000.0;
    settings.detail = 0.02;
    const classification::ComparedSound sound = compared(simulated_squeal(), settings);
    EXPECT_EQ(sound.name, "squeal.toml");
    EXPECT_EQ(sound.what, "joint velocity along x");
    EXPECT_EQ(sound.rate, 16000.0);
    EXPECT_EQ(sound.detail.signal.samples.size(), 320U);  // 0.02 s at 16 kHz
    EXPECT_EQ(sound.contact.verdicts.size(), 2U);
    ASSERT_EQ(sound.contact.histories.size(), 1U);
    for (const record::ContactInterval& interval : sound.contact.histories.front()) {
        EXPECT_GE(interval.from, sound.detail.from);
        EXPECT_LE(interval.to, sound.detail.from + 0.02 + 1e-12);
    }
}

TEST(Compared, IsSilenceWhereNothingMovesButByRounding) {
    parameters::Case c = sweep::figure_8().base;
    c.contact().kinetic_friction = 0.0;
    c.contact().preload = 20.0;
    const NamedSound still{"still", "still", "simulation",
                           SimulatedSound{c, heard_stretches(c, parameters::Direction::going)}};
    ComparisonSettings settings;
    settings.rate = 8000.0;
    const classification::ComparedSound sound = compared(still, settings);
    EXPECT_EQ(sound.heard.category, classification::Category::none);
    EXPECT_TRUE(is_silent(sound.profile));
}

}  // namespace
}  // namespace stridor::hearing
