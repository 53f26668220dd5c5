// Hearing: a minute of stereo analysed, in one thread and in as many as there are processors; sixty of it are an hour.

#include "stridor/hearing/run_sound.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/signal/fourier.hpp"
#include "stridor/signal/perturb.hpp"
#include "stridor/sound/analysis.hpp"
#include "stridor/sound/quality.hpp"

#include <benchmark/benchmark.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace stridor::sound {
namespace {

constexpr double rate = 48000.0;                         // [Hz]
constexpr std::size_t minute = 60 * std::size_t{48000};  // [1] frames

// Table 1's squeal again and again: many short stretches
std::vector<double> squeal() {
    const signal::Signal once = hearing::sound_of_case(parameters::Case{}, {});
    std::vector<double> samples;
    while (samples.size() < minute)
        samples.insert(samples.end(), once.samples.begin(), once.samples.end());
    samples.resize(minute);
    return samples;
}

// one long stretch after the other
std::vector<double> noise() {
    signal::Signal knock{rate, "FS", std::vector<double>(minute)};
    knock.samples.front() = 1.0;
    return signal::with_noise(knock, -200.0, 1).samples;
}

void in_threads(std::size_t count, const std::function<void(std::size_t)>& work) {
    tbb::parallel_for(std::size_t{0}, count, work, tbb::simple_partitioner());
}

void sound_minute(benchmark::State& state, std::vector<double> (*make)(), const Runner& run) {
    const signal::Signal channel{rate, "FS", make()};
    for ([[maybe_unused]] const auto repetition : state) {
        state.PauseTiming();
        const auto source = signal::source_of({channel, channel});
        state.ResumeTiming();
        benchmark::DoNotOptimize(analyse(*source, {}, run).front().stretches.size());
    }
}
BENCHMARK_CAPTURE(sound_minute, squeal_one_thread, squeal, one_after_the_other)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sound_minute, squeal, squeal, in_threads)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sound_minute, noise_one_thread, noise, one_after_the_other)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sound_minute, noise, noise, in_threads)->UseRealTime()->Unit(benchmark::kMillisecond);

// loudness, sharpness, roughness and third octaves of a minute of one channel
void sound_quality_minute(benchmark::State& state) {
    const std::vector<double> samples = noise();
    for ([[maybe_unused]] const auto repetition : state) {
        SoundQualityMeter meter(rate, SoundField::free);
        meter.push(samples);
        benchmark::DoNotOptimize(meter.finish().loudness);
    }
}
BENCHMARK(sound_quality_minute)->Unit(benchmark::kMillisecond);

// a frame there and back
void sound_transform(benchmark::State& state) {
    signal::Fourier fourier(static_cast<std::size_t>(state.range(0)));
    std::vector<double> frame(fourier.size());
    for (std::size_t n = 0; n < frame.size(); ++n)
        frame[n] = std::sin(0.1 * static_cast<double>(n * n % 997));
    for ([[maybe_unused]] const auto repetition : state)
        benchmark::DoNotOptimize(fourier.frame(fourier.spectrum(frame)).front());
}
BENCHMARK(sound_transform)->Arg(1024)->Arg(4096);

}  // namespace
}  // namespace stridor::sound
