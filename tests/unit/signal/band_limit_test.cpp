#include "stridor/signal/band_limit.hpp"

#include "stridor/base/elementary.hpp"
#include "support/counter_random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stridor::signal {
namespace {

constexpr double rate = 48000.0;
constexpr std::size_t edge = 1000;  // output samples that the ends of the signal reach

struct Motion {
    std::vector<double> u, v, a;
    double interval = 0.0;

    MotionSamples part(std::size_t from, std::size_t count) const {
        return {std::span(u).subspan(from, count), std::span(v).subspan(from, count),
                std::span(a).subspan(from, count)};
    }
};

std::vector<double> limited(const Motion& motion, MotionQuantity quantity) {
    BandLimiter limiter(motion.interval, rate, quantity);
    std::vector<double> output = limiter.push(motion.part(0, motion.u.size()));
    const std::vector<double> rest = limiter.finish();
    output.insert(output.end(), rest.begin(), rest.end());
    return output;
}

// A sawtooth of velocity that jumps by 1 m/s `frequency` times a second: the acceleration is a train of pulses
struct Sawtooth {
    double frequency;
    double phase = 0.37;

    Motion sampled(int density, double seconds) const {
        Motion motion;
        motion.interval = 1.0 / (rate * density);
        const auto count = static_cast<std::size_t>(seconds / motion.interval);
        for (std::size_t k = 0; k < count; ++k) {
            const double turns = frequency * motion.interval * static_cast<double>(k) + phase;
            const double s = turns - std::floor(turns);
            motion.u.push_back((s - s * s) / (2.0 * frequency));
            motion.v.push_back(0.5 - s);
            motion.a.push_back(-frequency);
        }
        return motion;
    }

    double fundamental(MotionQuantity quantity) const {
        return quantity == MotionQuantity::velocity ? 1.0 / std::numbers::pi : 2.0 * frequency;
    }

    // the harmonics below the band's end; none may lie in the transition, 0.45 to 0.5 of the rate
    double harmonics(MotionQuantity quantity, double time) const {
        double sum = 0.0;
        for (int n = 1; n * frequency < 0.45 * rate; ++n) {
            const base::SineCosine at = base::sine_cosine_of_turns(n * (frequency * time + phase));
            sum +=
                quantity == MotionQuantity::velocity ? at.sine / (std::numbers::pi * n) : 2.0 * frequency * at.cosine;
        }
        return sum;
    }
};

// largest error as a share of the fundamental
double error_of(const Sawtooth& saw, const std::vector<double>& output, MotionQuantity quantity) {
    double most = 0.0;
    for (std::size_t n = edge; n + edge < output.size(); ++n)
        most = std::max(most, std::abs(output[n] - saw.harmonics(quantity, static_cast<double>(n) / rate)));
    return most / saw.fundamental(quantity);
}

// lines of the output that are no harmonics but fold back from the image about the input's rate,
// as a share of the fundamental
double largest_alias(const Sawtooth& saw, const std::vector<double>& output, int density, MotionQuantity quantity) {
    double largest = 0.0;
    const std::size_t count = output.size() - 2 * edge;
    const int first = static_cast<int>((density - 0.45) * rate / saw.frequency);
    for (int n = first; n * saw.frequency < (density + 0.45) * rate; ++n) {
        const double frequency = std::abs(n * saw.frequency - density * rate);
        const double off = frequency / saw.frequency - std::round(frequency / saw.frequency);
        if (std::abs(off) < 0.1 || frequency < 100.0) continue;
        double sine = 0.0, cosine = 0.0, weights = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            const double w =
                base::sine_cosine_of_turns(0.5 * (static_cast<double>(k) + 0.5) / static_cast<double>(count)).sine;
            const base::SineCosine at = base::sine_cosine_of_turns(frequency / rate * static_cast<double>(k));
            const double weight = w * w * w * w;  // side lobes below -90 dB from the sixth bin on
            const double rest = output[edge + k] - saw.harmonics(quantity, static_cast<double>(edge + k) / rate);
            sine += weight * rest * at.sine;
            cosine += weight * rest * at.cosine;
            weights += weight;
        }
        largest = std::max(largest, 2.0 * std::hypot(sine, cosine) / weights);
    }
    return largest / saw.fundamental(quantity);
}

constexpr double squeal_like = 2690.123;  // [Hz] has no harmonic in the transition band of 48 kHz

TEST(BandLimiter, MakesTheHarmonicsOfARepeatedJump) {
    const Sawtooth saw{squeal_like};
    // measured 1.8e-5 and 1.1e-4: all that folds back together, and the fall of the band's end
    EXPECT_LT(error_of(saw, limited(saw.sampled(16, 0.25), MotionQuantity::velocity), MotionQuantity::velocity),
              2.5e-5);
    EXPECT_LT(error_of(saw, limited(saw.sampled(16, 0.25), MotionQuantity::acceleration), MotionQuantity::acceleration),
              1.5e-4);
}

TEST(BandLimiter, LetsNothingFoldBackAboveMinus90Decibels) {
    const Sawtooth saw{squeal_like};
    for (const auto& [quantity, bound] :
         {std::pair{MotionQuantity::velocity, -105.0}, {MotionQuantity::acceleration, -90.0}}) {
        const double alias = largest_alias(saw, limited(saw.sampled(16, 0.25), quantity), 16, quantity);
        EXPECT_LT(20.0 * std::log10(alias), bound);
        EXPECT_GT(20.0 * std::log10(alias), -140.0) << "the measurement sees nothing";
    }
}

TEST(BandLimiter, IsOfThirdOrderInTheInterval) {
    const Sawtooth saw{squeal_like};
    for (const MotionQuantity quantity : {MotionQuantity::velocity, MotionQuantity::acceleration}) {
        const double coarse = error_of(saw, limited(saw.sampled(8, 0.15), quantity), quantity);
        const double fine = error_of(saw, limited(saw.sampled(16, 0.15), quantity), quantity);
        EXPECT_GT(coarse / fine, 6.5);  // 8 in the limit
    }
}

// what the moments are for: the same samples of velocity through the same low pass, as they are
TEST(BandLimiter, BeatsPlainSamplesByMoreThan40Decibels) {
    const Sawtooth saw{squeal_like};
    const Motion motion = saw.sampled(16, 0.25);
    const std::vector<double> plain = resampled({16.0 * rate, "m/s", motion.v}, rate).samples;
    const double raw = largest_alias(saw, plain, 16, MotionQuantity::velocity);
    const double ours = largest_alias(saw, limited(motion, MotionQuantity::velocity), 16, MotionQuantity::velocity);
    EXPECT_GT(20.0 * std::log10(raw / ours), 40.0);
}

TEST(BandLimiter, KeepsLevelAndPhaseOfASmoothMotion) {
    for (const double frequency : {3.0, 440.0, 5000.0, 21000.0}) {
        const double omega = 2.0 * std::numbers::pi * frequency;
        Motion motion;
        motion.interval = 1.0 / (16.0 * rate);
        for (std::size_t k = 0; k < 16U * 6000U; ++k) {
            const base::SineCosine at =
                base::sine_cosine_of_turns(frequency * motion.interval * static_cast<double>(k));
            motion.u.push_back(at.sine / omega);
            motion.v.push_back(at.cosine);
            motion.a.push_back(-omega * at.sine);
        }
        const std::vector<double> velocity = limited(motion, MotionQuantity::velocity);
        const std::vector<double> acceleration = limited(motion, MotionQuantity::acceleration);
        ASSERT_EQ(velocity.size(), 6000U);
        const double x = omega * motion.interval;
        const double bound = 2e-5 + 0.02 * x * x * x * x;  // the low pass's ripple, then O((ωh)⁴)
        for (std::size_t n = edge; n + edge < velocity.size(); ++n) {
            const base::SineCosine at = base::sine_cosine_of_turns(frequency / rate * static_cast<double>(n));
            ASSERT_NEAR(velocity[n], at.cosine, bound) << frequency;
            ASSERT_NEAR(acceleration[n], -omega * at.sine, bound * omega + 1e-5) << frequency;
        }
    }
}

// jumps of velocity and of acceleration at random, often several in one interval
Motion random_motion(int density) {
    support::CounterRandom random(3);
    struct Jump {
        double time, velocity, acceleration;
    };
    std::vector<Jump> jumps;
    for (double time = 0.01; time < 0.09; time += random.decades(2e-7, 1e-3))
        jumps.push_back({time, random.between(-1.0, 1.0), random.between(-2e3, 2e3)});
    Motion motion;
    motion.interval = 1.0 / (rate * density);
    double u = 0.0, v = 0.0, a = 0.0, at = 0.0;
    std::size_t next = 0;
    for (std::size_t k = 0; k <= static_cast<std::size_t>(density) * 4800U; ++k) {
        const double time = motion.interval * static_cast<double>(k);
        for (; next < jumps.size() && jumps[next].time <= time; ++next) {
            const double dt = jumps[next].time - at;
            u += v * dt + 0.5 * a * dt * dt;
            v += a * dt;
            at = jumps[next].time;
            v += jumps[next].velocity - 0.3 * v;  // stays bounded
            a = jumps[next].acceleration;
        }
        const double dt = time - at;
        motion.u.push_back(u + v * dt + 0.5 * a * dt * dt);
        motion.v.push_back(v + a * dt);
        motion.a.push_back(a);
    }
    return motion;
}

TEST(BandLimiter, NeedNotKnowWhereNorHowManyJumpsThereAre) {
    for (const MotionQuantity quantity : {MotionQuantity::velocity, MotionQuantity::acceleration}) {
        const std::vector<double> coarse = limited(random_motion(16), quantity);
        const std::vector<double> fine = limited(random_motion(256), quantity);
        double most = 0.0, peak = 0.0;
        for (std::size_t n = 0; n < coarse.size(); ++n) {
            most = std::max(most, std::abs(coarse[n] - fine[n]));
            peak = std::max(peak, std::abs(fine[n]));
        }
        EXPECT_LT(20.0 * std::log10(most / peak), quantity == MotionQuantity::velocity ? -85.0 : -65.0);
    }
}

TEST(BandLimiter, IsTheSameHoweverTheInputIsCut) {
    const Motion motion = random_motion(16);
    for (const MotionQuantity quantity : {MotionQuantity::velocity, MotionQuantity::acceleration}) {
        support::CounterRandom random(5);
        BandLimiter limiter(motion.interval, rate, quantity);
        std::vector<double> in_parts;
        const auto append = [&](const std::vector<double>& part) {
            in_parts.insert(in_parts.end(), part.begin(), part.end());
        };
        for (std::size_t begin = 0; begin < motion.u.size();) {
            const std::size_t count = std::min(motion.u.size() - begin, random.below(900));
            append(limiter.push(motion.part(begin, count)));
            begin += count;
        }
        append(limiter.finish());
        EXPECT_EQ(in_parts, limited(motion, quantity));
        EXPECT_EQ(in_parts.size(), 4801U);
    }
}

TEST(BandLimiter, TakesMotionsOfAnyInterval) {
    // as of the beta_2 engine with h = 1 us: 1 MHz is no whole multiple of the rate
    const double frequency = 1000.0, omega = 2.0 * std::numbers::pi * frequency;
    Motion motion;
    motion.interval = 1e-6;
    for (std::size_t k = 0; k < 100000; ++k) {
        const base::SineCosine at = base::sine_cosine_of_turns(frequency * 1e-6 * static_cast<double>(k));
        motion.u.push_back(at.sine / omega);
        motion.v.push_back(at.cosine);
        motion.a.push_back(-omega * at.sine);
    }
    const std::vector<double> velocity = limited(motion, MotionQuantity::velocity);
    ASSERT_EQ(velocity.size(), 4800U);
    for (std::size_t n = edge; n + edge < velocity.size(); ++n)
        ASSERT_NEAR(velocity[n], base::sine_cosine_of_turns(frequency / rate * static_cast<double>(n)).cosine, 1e-5);
}

TEST(BandLimiter, IsSilentWithoutAMotion) {
    BandLimiter limiter(1.0 / (16.0 * rate), rate, MotionQuantity::velocity);
    EXPECT_TRUE(limiter.finish().empty());
}

}  // namespace
}  // namespace stridor::signal
