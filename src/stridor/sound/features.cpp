// Frames of about 85 ms, Hann, half overlapped, give spectra P_j(f) and their mean P(f). The floor φ is what a
// broadband background adds: the lowest median over equal bands. What stands out of it is kept by the gain
//     G(f) = max(0, 1 - e φ / P(f)),  0 below 40 Hz,
// with e so that one bin of noise in ten thousand passes,
// once in the spectrum, for everything about tones, and once in time, frame by frame, for everything about shape.
// The autocorrelation is that of the windowed frames over that of the window (Boersma 1993).
#include "stridor/sound/features.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"
#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/signal/median.hpp"
#include "stridor/signal/powers.hpp"
#include "stridor/signal/window.hpp"
#include "stridor/sound/course.hpp"
#include "stridor/sound/tones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

namespace stridor::sound {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double line_frame = 0.085;       // [s] long enough for lines 25 Hz apart, short enough for 100 ms phases
constexpr double lowest_frequency = 40.0;  // [Hz] below lies the drive, not its noise
constexpr double longest_cycle = 0.025;    // [s]
constexpr std::size_t floor_bands = 24;
constexpr std::size_t least_floor_bins = 20;  // of a band: the lowest of medians of fewer lies far below the background
constexpr double cliff = 100.0;               // [1] drop from band to band where a recording's bandwidth ends

using Power = std::vector<double>;

// The power per bin of a white background: the lowest median of equal bands. Bands above a cliff hold nothing, for the
// recording ends there, and say nothing about its background.
double floor_of(std::span<const double> power, std::size_t lowest) {
    const std::span<const double> audible = power.subspan(lowest);
    const std::size_t wanted = std::max(least_floor_bins, audible.size() / floor_bands);
    const std::size_t width = std::max<std::size_t>(1, std::min(wanted, audible.size()));
    double least = infinity;
    double before = 0.0;
    for (std::size_t band = 0; (band + 1) * width <= audible.size(); ++band) {
        const double here = signal::median_of(audible.subspan(band * width, width));
        if (band > 3 && here * cliff < before) break;
        least = std::min(least, here);
        before = here;
    }
    return std::isfinite(least) ? least : 0.0;
}

// How many floors one bin of noise in ten thousand exceeds, the floor being the median of means over so many frames: a
// quantile of the chi-squared distribution (Wilson and Hilferty 1931). Half overlapped Hann frames count 0.7 each.
double floor_excess(std::size_t frames) {
    constexpr double deviate = 3.72;
    const double independent = 0.3 + 0.7 * static_cast<double>(frames);
    const double median = 1.0 - 1.0 / (9.0 * independent);
    const double ratio = 1.0 + deviate / (3.0 * std::sqrt(independent) * median);
    return ratio * ratio * ratio;
}

// place of the strongest line within bins [from, to), from the logarithms of three bins,
// in which Hann's line is a parabola
double line_place(std::span<const double> power, std::size_t from, std::size_t to) {
    const auto top = std::max_element(power.begin() + static_cast<std::ptrdiff_t>(from),
                                      power.begin() + static_cast<std::ptrdiff_t>(to));
    const auto k = static_cast<std::size_t>(top - power.begin());
    const double place = static_cast<double>(k);
    if (k == 0 || k + 1 >= power.size()) return place;
    const double left = power[k - 1];
    const double right = power[k + 1];
    if (!(left > 0.0 && power[k] > 0.0 && right > 0.0)) return place;
    return place +
           parabola_summit(base::logarithm_2(left), base::logarithm_2(power[k]), base::logarithm_2(right)).place;
}

std::vector<double> echo_of(signal::Fourier& fourier, std::span<const double> window) {
    const auto spectrum = fourier.spectrum(window);
    std::vector<std::complex<double>> power(spectrum.size());
    for (std::size_t k = 0; k < power.size(); ++k)
        power[k] = std::norm(spectrum[k]);
    const auto frame = fourier.frame(power);
    std::vector<double> echo(frame.begin(), frame.end());
    const double whole = echo.front();
    for (double& value : echo)
        value /= whole;
    return echo;
}

// Writes samples under the window without the straight line that fits them best: what the drive's slow motion looks
// like in a short frame.
STRIDOR_CLONES void window_without_line(std::span<const double> samples, std::span<const double> window,
                                        std::span<double> result) {
    const auto count = static_cast<double>(samples.size());
    const double middle = 0.5 * (count - 1.0);
    // four sums at a time: each waits for itself only
    std::array<double, 4> sums{};
    std::array<double, 4> products{};
    std::size_t first = 0;
    for (; first + 4 <= samples.size(); first += 4)
        for (std::size_t lane = 0; lane < 4; ++lane) {
            sums[lane] += samples[first + lane];
            products[lane] += (static_cast<double>(first + lane) - middle) * samples[first + lane];
        }
    for (; first < samples.size(); ++first) {
        sums[0] += samples[first];
        products[0] += (static_cast<double>(first) - middle) * samples[first];
    }
    const double mean = std::accumulate(sums.begin(), sums.end(), 0.0) / count;
    const double covariance = std::accumulate(products.begin(), products.end(), 0.0);
    const double slope = 12.0 * covariance / (count * (count * count - 1.0));
    const auto length = static_cast<std::int32_t>(samples.size());
    const double* __restrict from = samples.data();
    const double* __restrict weights = window.data();
    double* __restrict to = result.data();
    for (std::int32_t n = 0; n < length; ++n)
        to[n] = (from[n] - mean - slope * (static_cast<double>(n) - middle)) * weights[n];
}

// lines times a gain
STRIDOR_CLONES void scale_lines(std::span<const std::complex<double>> lines, std::span<const double> gain,
                                std::span<std::complex<double>> result) {
    for (std::size_t k = 0; k < gain.size(); ++k)
        result[k] = {lines[k].real() * gain[k], lines[k].imag() * gain[k]};
}

STRIDOR_CLONES void add_to(std::span<double> sums, std::span<const double> values) {
    double* __restrict to = sums.data();
    const double* __restrict from = values.data();
    for (std::size_t n = 0; n < values.size(); ++n)
        to[n] += from[n];
}

// Width of the band in which a sound rests, in effective values; `widening` times what is left of the floor widens it.
double resting_width(double left, double widening) {
    return std::sqrt(0.0625 + widening * widening * left * left);
}

}  // namespace

struct FeatureFinder::Picture {
    std::span<const double> window;
    std::span<const double> echo;
    std::size_t hop = 1;
    std::size_t frames = 0;
    std::vector<std::complex<double>> lines;  // shape [frame][bin]
    Power power;                              // shape [bin], mean over the frames
    Power gain;                               // shape [bin]
    double floor = 0.0;
    std::size_t lowest = 1;  // first bin that counts

    std::span<const std::complex<double>> frame(std::size_t place) const {
        return std::span(lines).subspan(place * power.size(), power.size());
    }
};

FeatureFinder::FeatureFinder(double rate)
    : rate_(rate),
      size_(signal::power_of_two_near(line_frame, rate)),
      fourier_(size_),
      window_(signal::window(signal::Window::hann, size_)),
      window_echo_(echo_of(fourier_, window_)) {}

FeatureFinder::Picture FeatureFinder::picture_of(std::span<const double> samples) {
    Picture picture;
    const std::size_t size = std::min(size_, samples.size());
    if (size == size_) {
        picture.window = window_;
        picture.echo = window_echo_;
    } else {
        if (short_window_.size() != size) {
            short_window_ = windows_.of(size);
            short_echo_ = echo_of(fourier_, short_window_);
        }
        picture.window = short_window_;
        picture.echo = short_echo_;
    }
    picture.hop = std::max<std::size_t>(1, size / 2);
    const std::size_t bins = size_ / 2 + 1;
    picture.power.assign(bins, 0.0);
    Power power(bins);
    std::vector<double> frame(size);
    picture.lines.reserve((samples.size() / picture.hop) * bins);
    for (std::size_t first = 0; first + size <= samples.size(); first += picture.hop) {
        window_without_line(samples.subspan(first, size), picture.window, frame);
        const auto spectrum = fourier_.spectrum(frame);
        signal::powers_of(spectrum, power);
        add_to(picture.power, power);
        picture.lines.insert(picture.lines.end(), spectrum.begin(), spectrum.end());
        ++picture.frames;
    }
    for (double& value : picture.power)
        value /= static_cast<double>(picture.frames);

    picture.lowest = static_cast<std::size_t>(std::ceil(lowest_frequency * static_cast<double>(size_) / rate_));
    picture.lowest = std::max<std::size_t>(2, picture.lowest);
    picture.floor = floor_of(picture.power, picture.lowest);
    picture.gain.assign(picture.power.size(), 0.0);
    const double background = floor_excess(picture.frames) * picture.floor;
    for (std::size_t k = picture.lowest; k < picture.gain.size(); ++k)
        if (picture.power[k] > 0.0) picture.gain[k] = std::max(0.0, 1.0 - background / picture.power[k]);
    return picture;
}

void FeatureFinder::describe_tone(const Picture& picture, SoundFeatures& features) {
    Power kept(picture.power.size());
    double whole = 0.0;
    for (std::size_t k = 0; k < kept.size(); ++k)
        whole += kept[k] = picture.power[k] * picture.gain[k];
    if (!(whole > 0.0)) return;
    const double width = rate_ / static_cast<double>(size_);  // [Hz] of a bin
    const double place = line_place(kept, picture.lowest, kept.size() - 1);
    const std::size_t top = base::whole_near(place, kept.size() - 1);
    features.frequency = place * width;

    // a Hann line and the two bins on either side; a short stretch has wider lines
    const std::size_t half_line = static_cast<std::size_t>(
        std::ceil(2.0 * static_cast<double>(size_) / static_cast<double>(picture.window.size())));
    double line = 0.0;
    for (std::size_t k = top - std::min(top, half_line); k <= std::min(kept.size() - 1, top + half_line); ++k)
        line += kept[k];
    features.tonality = line / whole;
    const auto low = std::max(picture.lowest, static_cast<std::size_t>(static_cast<double>(top) * 0.7071));
    const auto high = std::min(kept.size(), static_cast<std::size_t>(static_cast<double>(top) * 1.4142) + 2);
    const double around = signal::median_of(std::span(picture.power).subspan(low, high - low));
    features.prominence = base::decibels_of_power(picture.power[top] / std::max(around, 1e-15 * picture.power[top]));

    describe_movement(picture, place, features);
    describe_cycles(picture, kept, features);
}

// the strongest frequency of each frame, within a third around that of all, weighted by its power
void FeatureFinder::describe_movement(const Picture& picture, double place, SoundFeatures& features) {
    const std::size_t from = std::max(picture.lowest, static_cast<std::size_t>(0.75 * place));
    const std::size_t to = std::min(picture.power.size() - 1, static_cast<std::size_t>(1.34 * place) + 2);
    double weight = 0.0;
    double first = 0.0;
    double second = 0.0;
    Power here(to);
    for (std::size_t j = 0; j < picture.frames; ++j) {
        const auto frame = picture.frame(j);
        for (std::size_t k = from; k < to; ++k)
            here[k] = std::norm(frame[k]) * picture.gain[k];
        const double there = line_place(here, from, to);
        const double power = here[base::whole_near(there, to - 1)];
        weight += power;
        first += power * there;
        second += power * there * there;
    }
    if (weight > 0.0)
        features.movement =
            std::sqrt(std::max(0.0, second / weight - first / weight * (first / weight))) / std::max(place, 1.0);
}

// how much the sound repeats itself: from cycle to cycle of its strongest line, and after whatever time it does so best
void FeatureFinder::describe_cycles(const Picture& picture, std::span<const double> kept, SoundFeatures& features) {
    std::vector<std::complex<double>> spectrum(kept.begin(), kept.end());
    const auto echo = fourier_.frame(spectrum);
    const std::size_t lags =
        std::min({static_cast<std::size_t>(longest_cycle * rate_), size_ / 2, picture.window.size() * 2 / 3});
    std::vector<double> likeness(lags);
    for (std::size_t lag = 0; lag < lags; ++lag)
        likeness[lag] = echo[lag] / echo[0] / std::max(picture.echo[lag], 0.02);
    const auto peak_in = [&](std::size_t low_lag, std::size_t high_lag) {
        Summit best{0.0, -1.0};
        for (std::size_t lag = std::max<std::size_t>(1, low_lag); lag < std::min(high_lag, lags); ++lag) {
            Summit here_peak{0.0, likeness[lag]};
            const bool is_summit =
                lag + 1 < lags && likeness[lag] >= likeness[lag - 1] && likeness[lag] > likeness[lag + 1];
            if (is_summit) here_peak = parabola_summit(likeness[lag - 1], likeness[lag], likeness[lag + 1]);
            if (here_peak.height > best.height) best = {static_cast<double>(lag) + here_peak.place, here_peak.height};
        }
        return best;
    };
    const double cycle = rate_ / features.frequency;
    const double reach = std::max(1.0, 0.1 * cycle);
    if (cycle + reach < static_cast<double>(lags))
        features.regularity = std::clamp(
            peak_in(base::whole_near(cycle - reach, lags), base::whole_near(cycle + reach, lags) + 1).height, 0.0, 1.0);
    const auto negative = std::find_if(likeness.begin(), likeness.end(), [](double value) { return value < 0.0; });
    const Summit best = peak_in(static_cast<std::size_t>(negative - likeness.begin()), lags);
    if (best.height > 0.0) {
        features.repetition = std::min(1.0, best.height);
        features.repetition_frequency = rate_ / best.place;
    }
}

// overlap-add of the frames that went through the gain, over the sum of their windows where that is not small
std::vector<double> FeatureFinder::above_floor(const Picture& picture, std::size_t size) {
    const std::size_t length = picture.window.size();
    std::vector<double> sum(size);
    std::vector<double> weight(size);
    std::vector<std::complex<double>> spectrum(picture.power.size());
    for (std::size_t j = 0; j < picture.frames; ++j) {
        scale_lines(picture.frame(j), picture.gain, spectrum);
        add_to(std::span(sum).subspan(j * picture.hop), fourier_.frame(spectrum).first(length));
        add_to(std::span(weight).subspan(j * picture.hop), picture.window);
    }
    std::vector<double> samples;
    samples.reserve(size);
    for (std::size_t n = 0; n < size; ++n)
        if (weight[n] > 0.2) samples.push_back(sum[n] / weight[n]);
    return samples;
}

SoundStretch FeatureFinder::find(std::span<const double> samples) {
    STRIDOR_EXPECT(static_cast<double>(samples.size()) >= least_duration * rate_ - 1.0);
    SoundStretch stretch;
    SoundFeatures& features = stretch.features;
    features.duration = static_cast<double>(samples.size()) / rate_;
    const Picture picture = picture_of(samples);
    double power = 0.0;
    double kept = 0.0;
    double kept_floor = 0.0;
    double kept_slope = 0.0;  // the same of the sound's slope
    double kept_slope_floor = 0.0;
    for (std::size_t k = picture.lowest; k < picture.power.size(); ++k) {
        if (picture.gain[k] > 0.0) power += picture.power[k] - picture.floor;
        kept += picture.power[k] * picture.gain[k] * picture.gain[k];
        kept_floor += picture.floor * picture.gain[k] * picture.gain[k];
        const auto square = static_cast<double>(k) * static_cast<double>(k) * picture.gain[k] * picture.gain[k];
        kept_slope += square * picture.power[k];
        kept_slope_floor += square * picture.floor;
    }
    const double background = picture.floor * static_cast<double>(picture.power.size() - picture.lowest);
    features.clearness = power > 0.0 ? base::decibels_of_power(power / background) : -infinity;
    if (!(kept > 0.0)) return stretch;
    describe_tone(picture, features);

    const std::vector<double> sound = above_floor(picture, samples.size());
    const Moments moments = moments_of(sound);
    if (!(moments.second * moments.second > 0.0)) return stretch;
    features.mean_square = moments.second;
    features.peak = moments.peak;
    features.kurtosis = moments.fourth / (moments.second * moments.second);
    const double effective = std::sqrt(moments.second);
    features.crest = moments.peak / effective;
    // what is left of the floor widens the place where the sound rests
    const double left = std::sqrt(kept_floor / kept);
    features.rest = largest_dwell(sound, effective * resting_width(left, 4.0));
    const LevelCourse level = level_course(sound, rate_, windows_);
    features.abruptness = level.abruptness;
    features.trend = level.trend;
    // and makes the level unsteady by so many decibels
    features.unsteadiness = std::max(0.0, level.unsteadiness - 5.0 * left);

    std::vector<double> slope(sound.size() - 1);
    for (std::size_t n = 0; n < slope.size(); ++n)
        slope[n] = sound[n + 1] - sound[n];
    const double slope_width = resting_width(std::sqrt(kept_slope_floor / kept_slope), 1.5);
    features.rest = std::max(features.rest, largest_dwell(slope, std::sqrt(moments_of(slope).second) * slope_width));
    ImpulseTrain train = impulse_train(slope, rate_);
    stretch.impulses = std::move(train.instants);
    features.impulses = stretch.impulses.size();
    features.impulse_periodicity = train.periodicity;
    features.impulse_interval = train.interval;
    return stretch;
}

SoundFeatures sound_features(const signal::Signal& signal) {
    if (signal::duration(signal) < FeatureFinder::least_duration)
        throw Error(ErrorKind::input, {"the sound is too short to be judged", "it must last at least 20 ms", ""});
    return FeatureFinder(signal.rate).find(signal.samples).features;
}

}  // namespace stridor::sound
