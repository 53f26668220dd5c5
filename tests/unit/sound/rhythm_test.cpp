#include "stridor/sound/rhythm.hpp"

#include "support/made_sounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace stridor::sound {
namespace {

constexpr double pace_part = 0.002;  // [s]

// mean squares of a hiss whose amplitude follows a function of time
template <typename Amplitude>
std::vector<double> hiss_squares(double duration, const Amplitude& amplitude) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> draw;
    std::vector<double> squares(static_cast<std::size_t>(duration / pace_part));
    for (std::size_t k = 0; k < squares.size(); ++k) {
        for (int n = 0; n < 96; ++n)
            squares[k] += std::pow(draw(random), 2.0) / 96.0;
        squares[k] *= std::pow(amplitude(pace_part * static_cast<double>(k)), 2.0);
    }
    return squares;
}

double steady_amplitude(double) {
    return 1.0;
}

TEST(Rhythm, OfOnePaceStandsOut) {
    const auto beating = [](double t) { return 1.0 + 0.5 * support::sine(11.0 * t); };
    EXPECT_GT(rhythm_of(hiss_squares(3.0, beating), pace_part),
              rhythm_of(hiss_squares(3.0, steady_amplitude), pace_part) + 10.0);
}

// from 10 to 20 Hz within the passage: no pace lasts
TEST(Rhythm, OfAGlidingPaceStandsOutLess) {
    const auto even = [](double t) { return 1.0 + 0.5 * support::sine(15.0 * t); };
    const auto gliding = [](double t) { return 1.0 + 0.5 * support::sine(10.0 * t + 5.0 / 3.0 * t * t); };
    EXPECT_GT(rhythm_of(hiss_squares(3.0, even), pace_part), rhythm_of(hiss_squares(3.0, gliding), pace_part) + 5.0);
}

TEST(Rhythm, IsThatOfTheSoundAtAnyGain) {
    std::vector<double> squares = hiss_squares(1.0, steady_amplitude);
    const double before = rhythm_of(squares, pace_part);
    for (double& square : squares)
        square *= 1.0 / 1024.0;
    EXPECT_NEAR(rhythm_of(squares, pace_part), before, 1e-9);
}

TEST(Rhythm, IsNoneWhereNothingSounds) {
    EXPECT_EQ(rhythm_of(std::vector<double>(500), pace_part), 0.0);
    EXPECT_EQ(rhythm_of(std::vector<double>(7, 1.0), pace_part), 0.0);
}

}  // namespace
}  // namespace stridor::sound
