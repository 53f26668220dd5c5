#pragma once

#include "stridor/signal/perturb.hpp"
#include "stridor/signal/source.hpp"

#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

/// Sounds whose category is plain.
namespace stridor::support {

inline constexpr double sound_rate = 48000.0;  // [Hz]

inline double sine(double turns) {
    return std::sin(2.0 * std::numbers::pi * turns);
}

/// A function of time [s], sampled for so long [s].
inline signal::Signal sampled(double duration, const std::function<double(double)>& value) {
    signal::Signal result{sound_rate, signal::full_scale, {}};
    for (std::size_t n = 0; static_cast<double>(n) < duration * sound_rate; ++n)
        result.samples.push_back(value(static_cast<double>(n) / sound_rate));
    return result;
}

/// Impulses at these instants [s], each of which rings in wood: 2.1 and 3.4 kHz, for about 8 ms.
inline signal::Signal struck(double duration, const std::vector<double>& instants) {
    signal::Signal result{sound_rate, signal::full_scale,
                          std::vector<double>(static_cast<std::size_t>(duration * sound_rate))};
    for (const double instant : instants)
        for (std::size_t n = static_cast<std::size_t>(instant * sound_rate); n < result.samples.size(); ++n) {
            const double t = static_cast<double>(n) / sound_rate - instant;
            if (t > 0.1) break;
            result.samples[n] += std::exp(-t / 0.008) * (sine(2100.0 * t) + 0.7 * sine(3400.0 * t));
        }
    return result;
}

/// A textbook creak: forty impulses in three seconds, whose intervals grow.
inline signal::Signal creak() {
    std::vector<double> instants;
    double interval = 0.045;
    for (double t = 0.1; instants.size() < 40; t += interval) {
        instants.push_back(t);
        interval *= 1.025;
    }
    return signal::with_noise(struck(3.4, instants), 40.0, 3);
}

/// Ten harmonics of 700 Hz for so long [s].
inline signal::Signal squeal(double duration) {
    return signal::with_noise(sampled(duration,
                                      [](double t) {
                                          double sum = 0.0;
                                          for (int k = 1; k <= 10; ++k)
                                              sum += sine(700.0 * k * t) / k;
                                          return 0.3 * sum;
                                      }),
                              30.0, 4);
}

/// White noise for so long [s], of effective value 0.1.
inline signal::Signal hiss(double duration) {
    constexpr double buried = -200.0;  // [dB] the knock that the noise is measured against
    signal::Signal knock = sampled(duration, [](double) { return 0.0; });
    knock.samples.front() = 0.1 * std::sqrt(static_cast<double>(knock.samples.size())) * std::pow(10.0, 0.05 * buried);
    return signal::with_noise(knock, buried, 1);
}

}  // namespace stridor::support
