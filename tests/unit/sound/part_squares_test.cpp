#include "stridor/sound/part_squares.hpp"

#include "stridor/signal/level.hpp"
#include "stridor/signal/side_by_side.hpp"
#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <span>

namespace stridor::sound {
namespace {

// three figures of a channel, as the finders of `analyse` have them
struct Figures {
    explicit Figures(double rate)
        : sections(rate, 100.0, 0.01, PartSquares::Samples::kept),
          stretches(rate, 40.0, 0.005),
          meter(rate, 1.0) {}

    PartSquares sections;
    PartSquares stretches;
    signal::LevelMeter meter;
};

TEST(SideBySide, EachFigureIsAsAloneWhateverTheBlocks) {
    const signal::Signal hiss = support::hiss(0.777);
    const std::span<const double> samples = hiss.samples;
    Figures alone(hiss.rate);
    signal::push_side_by_side(samples, alone.sections);
    signal::push_side_by_side(samples, alone.stretches);
    signal::push_side_by_side(samples, alone.meter);
    ASSERT_EQ(alone.sections.squares.size(), 77U);
    ASSERT_EQ(alone.sections.sample_squares.size(), samples.size());
    for (const std::size_t block : {std::size_t{1}, std::size_t{777}, samples.size()}) {
        Figures together(hiss.rate);
        for (std::size_t first = 0; first < samples.size(); first += block)
            signal::push_side_by_side(samples.subspan(first, std::min(block, samples.size() - first)),
                                      together.sections, together.stretches, together.meter);
        EXPECT_EQ(together.sections.squares, alone.sections.squares);
        EXPECT_EQ(together.sections.sample_squares, alone.sections.sample_squares);
        EXPECT_EQ(together.stretches.squares, alone.stretches.squares);
        EXPECT_TRUE(together.stretches.sample_squares.empty());
        EXPECT_EQ(together.meter.history().decibels, alone.meter.history().decibels);
        EXPECT_EQ(together.meter.squares(), alone.meter.squares());
    }
}

}  // namespace
}  // namespace stridor::sound
