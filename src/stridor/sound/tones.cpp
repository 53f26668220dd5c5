#include "stridor/sound/tones.hpp"

#include "stridor/base/clones.hpp"
#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/median.hpp"
#include "stridor/signal/powers.hpp"
#include "stridor/signal/spectrum.hpp"
#include "stridor/signal/window.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

// Frames of 43 ms, Hann, half overlapped. A line is a local maximum of the power that stands 9 dB above what the
// half octave around it has, estimated by its geometric mean: that of noise lies e^-gamma below the mean power. The
// power's transform back is the frame's autocorrelation: over that of the window it is greatest where the wave repeats.
namespace stridor::sound {

namespace {

constexpr double frame_time = 0.043;         // [s]
constexpr double least_frequency = 150.0;    // [Hz] of a tone: below lies rumble
constexpr double greatest_frequency = 12e3;  // [Hz] of a tone
constexpr double weighted_from = 100.0;      // [Hz] for the centre, the spread and the fundamental
constexpr double prominence = 2.98973;       // [octave] of power, 9 dB
constexpr double median_of_noise = 0.29866;  // [octave] e^gamma ln 2, the median power over the geometric mean
constexpr double half_band = 0.19;           // [1] a quarter octave as a share of the frequency
constexpr std::size_t narrowest = 5;         // bins on either side
constexpr double most_change = 0.03;         // [1] of a partial's frequency from frame to frame
constexpr double most_bins = 1.5;            // the same for low ones
constexpr std::size_t least_frames = 3;
constexpr double highest_fundamental = 1500.0;  // [Hz] a higher one is heard as half, a third ... of it
constexpr double lowest_fundamental = 70.0;     // [Hz] three periods of it fit into a frame
constexpr double least_overlap = 0.05;  // [1] of the window's autocorrelation: beyond, little is left to compare
constexpr double loud_share = 0.01;     // [1] 20 dB: softer frames say nothing of the wave
constexpr double tiny = 1e-30;

std::size_t band_of(std::size_t bin) {
    return std::max(narrowest, static_cast<std::size_t>(std::lround(half_band * static_cast<double>(bin))));
}

// samples less their mean under a window
STRIDOR_CLONES void window_samples(std::span<const double> samples, double mean, std::span<const double> window,
                                   std::span<double> result) {
    const double* __restrict from = samples.data();
    const double* __restrict weights = window.data();
    double* __restrict to = result.data();
    for (std::size_t n = 0; n < samples.size(); ++n)
        to[n] = (from[n] - mean) * weights[n];
    for (std::size_t n = samples.size(); n < result.size(); ++n)
        to[n] = 0.0;
}

// powers times their weights, which are added to a spectrum, too
STRIDOR_CLONES void weigh_lines(std::span<const double> power, std::span<const double> weights,
                                std::span<double> weighted, std::span<double> spectrum) {
    const double* __restrict from = power.data();
    const double* __restrict factor = weights.data();
    double* __restrict to = weighted.data();
    double* __restrict sums = spectrum.data();
    for (std::size_t k = 0; k < power.size(); ++k) {
        to[k] = factor[k] * from[k];
        sums[k] += to[k];
    }
}

// the greatest product of two rows, and where it is
struct Greatest {
    double value = 0.0;
    std::size_t place = 0;
};

Greatest greatest_product(std::span<const double> a, std::span<const double> b) {
    Greatest found;
    for (std::size_t k = 0; k < a.size(); ++k)
        if (const double here = a[k] * b[k]; here > found.value) found = {here, k};
    return found;
}

}  // namespace

Summit parabola_summit(double left, double centre, double right) {
    const double curvature = left - 2.0 * centre + right;
    if (!(curvature < 0.0)) return {0.0, centre};
    const double shift = std::clamp(0.5 * (left - right) / curvature, -0.5, 0.5);
    return {shift, centre - 0.25 * (left - right) * shift};
}

struct ToneFinder::Line {
    double place = 0.0;   // in bins
    double energy = 0.0;  // [unit²] A-weighted, above its surroundings
};

struct ToneFinder::Partial {
    std::size_t first = 0;  // frame
    std::vector<Line> lines{};
};

struct ToneFinder::Frames {
    std::size_t hop = 1;
    std::vector<std::vector<Line>> lines{};  // shape [frame][line]
    std::vector<double> power{};             // [unit²] A-weighted, shape [frame]
    std::vector<double> spectrum{};          // [unit²] A-weighted, shape [bin]
    std::vector<double> energy{};            // [unit²] windowed, from 100 Hz, shape [frame]
    std::vector<double> likeness{};          // [1] of the wave to itself one period later, shape [frame]
    std::vector<double> fundamental{};       // [octave] of 1 Hz, of that period, shape [frame]
};

ToneFinder::ToneFinder(double rate)
    : rate_(rate),
      size_(signal::power_of_two_near(frame_time, rate)),
      fourier_(size_),
      window_(signal::window(signal::Window::hann, size_)) {
    const double width = rate_ / static_cast<double>(size_);  // [Hz] of a bin
    for (std::size_t k = 0; k <= size_ / 2; ++k)
        weights_.push_back(signal::a_weighting(static_cast<double>(k) * width));
    lowest_ = std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(least_frequency / width)), 2, weights_.size());
    highest_ = std::min(size_ / 2 - 2, static_cast<std::size_t>(greatest_frequency / width));
    shortest_ = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(rate_ / highest_fundamental)));
    longest_ = std::min(size_ / 2, static_cast<std::size_t>(rate_ / lowest_fundamental));
    std::vector<double> power(weights_.size());
    signal::powers_of(fourier_.spectrum(window_), power);
    const std::span<const double> own = autocorrelation_of(power);
    for (std::size_t k = 0; k < longest_; ++k)
        windowed_.push_back(1.0 / std::max(own[k] / own[0], least_overlap));
}

// of the wave whose powers these are, shape [lag]; valid until the next transform
std::span<const double> ToneFinder::autocorrelation_of(std::span<const double> power) {
    numbers_.assign(power.begin(), power.end());
    return fourier_.frame(numbers_);
}

// Unweighted, for the low harmonics tell voices and engines; rumble is left out. It overwrites the powers.
void ToneFinder::add_fundamental(std::span<double> power, Frames& frames) {
    const double width = rate_ / static_cast<double>(size_);
    const auto audible = static_cast<std::size_t>(std::ceil(weighted_from / width));
    std::fill_n(power.begin(), std::min(audible, power.size()), 0.0);
    const std::span<const double> own = autocorrelation_of(power);
    const auto lags = own.subspan(0, longest_);
    const Greatest found = greatest_product(lags.subspan(shortest_), std::span(windowed_).subspan(shortest_));
    frames.energy.push_back(std::max(0.0, own[0]));
    const auto lag = static_cast<double>(shortest_ + found.place);
    frames.likeness.push_back(own[0] > 0.0 ? std::min(1.0, found.value / own[0]) : 0.0);
    frames.fundamental.push_back(base::logarithm_2(rate_ / lag));
}

// the lines of one frame
std::vector<ToneFinder::Line> ToneFinder::lines_of(std::span<const double> power) const {
    // what lies 120 dB below the strongest bin is no surrounding to stand out of
    const double least = *std::max_element(power.begin(), power.end()) * 1e-12 + tiny;
    const std::size_t end = std::min(power.size(), highest_ + band_of(highest_) + 1);
    std::vector<double> above(end);
    for (std::size_t k = 0; k < end; ++k)
        above[k] = power[k] + least;
    std::vector<double> octaves(end);
    base::find_logarithms_2(above, octaves);
    std::vector<double> sums(end + 1);
    std::partial_sum(octaves.begin(), octaves.end(), sums.begin() + 1);
    std::vector<Line> lines;
    for (std::size_t k = lowest_; k < highest_; ++k) {
        if (!(power[k] > power[k - 1] && power[k] >= power[k + 1])) continue;
        const std::size_t band = band_of(k);
        const std::size_t from = k > band ? k - band : 1;
        const std::size_t to = std::min(end, k + band + 1);
        const double level = median_of_noise + (sums[to] - sums[from]) / static_cast<double>(to - from);
        if (!(octaves[k] > prominence + level)) continue;
        const double surroundings = base::power_of_2(level);
        // in the logarithm Hann's line is a parabola
        const double shift = parabola_summit(octaves[k - 1], octaves[k], octaves[k + 1]).place;
        Line line{static_cast<double>(k) + shift, 0.0};
        for (std::size_t j = k - 2; j <= k + 2; ++j)
            line.energy += weights_[j] * std::max(0.0, power[j] - surroundings);
        lines.push_back(line);
    }
    return lines;
}

ToneFinder::Frames ToneFinder::frames_of(std::span<const double> samples) {
    Frames frames;
    frames.hop = size_ / 2;
    frames.spectrum.assign(weights_.size(), 0.0);
    const double mean = std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
    std::vector<double> frame(size_);
    std::vector<double> power(weights_.size());
    std::vector<double> weighted(weights_.size());
    for (std::size_t first = 0; first == 0 || first + size_ <= samples.size(); first += frames.hop) {
        const std::size_t count = std::min(size_, samples.size() - first);
        window_samples(samples.subspan(first, count), mean, window_, frame);
        signal::powers_of(fourier_.spectrum(frame), power);
        weigh_lines(power, weights_, weighted, frames.spectrum);
        frames.lines.push_back(lines_of(power));
        frames.power.push_back(
            std::accumulate(weighted.begin() + static_cast<std::ptrdiff_t>(lowest_), weighted.end(), 0.0));
        if (longest_ > shortest_) add_fundamental(power, frames);
    }
    // one-sided power over N times the window's square
    const double sum_of_window = std::accumulate(window_.begin(), window_.end(), 0.0);
    const double unit = 2.0 / (signal::noise_bandwidth(window_) * sum_of_window * sum_of_window) /
                        static_cast<double>(frames.power.size());
    for (double& value : frames.spectrum)
        value *= unit;
    return frames;
}

// Each partial goes on in the nearest line of the next frame, the strongest partial first.
std::vector<ToneFinder::Partial> ToneFinder::partials_of(const Frames& frames) const {
    std::vector<Partial> partials;
    std::vector<std::size_t> going;
    for (std::size_t j = 0; j < frames.lines.size(); ++j) {
        const std::vector<Line>& lines = frames.lines[j];
        std::vector<std::uint8_t> is_taken(lines.size(), 0);
        std::vector<std::size_t> next;
        std::stable_sort(going.begin(), going.end(), [&](std::size_t a, std::size_t b) {
            return partials[a].lines.back().energy > partials[b].lines.back().energy;
        });
        for (const std::size_t p : going) {
            const double place = partials[p].lines.back().place;
            std::size_t nearest = lines.size();
            double distance = std::max(most_bins, most_change * place);
            for (std::size_t k = 0; k < lines.size(); ++k) {
                const double here = std::abs(lines[k].place - place);
                if (is_taken[k] != 0 || here > distance) continue;
                nearest = k;
                distance = here;
            }
            if (nearest == lines.size()) continue;
            is_taken[nearest] = 1;
            partials[p].lines.push_back(lines[nearest]);
            next.push_back(p);
        }
        for (std::size_t k = 0; k < lines.size(); ++k) {
            if (is_taken[k] != 0) continue;
            next.push_back(partials.size());
            partials.push_back({j, {lines[k]}});
        }
        going = std::move(next);
    }
    std::erase_if(partials, [](const Partial& partial) { return partial.lines.size() < least_frames; });
    return partials;
}

namespace {

// the value that nine tenths of the values do not exceed
double ninth_decile(std::vector<double> values) {
    const auto place = static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[static_cast<std::size_t>(place)];
}

struct Deviation {
    double mean = 0.0;
    double deviation = 0.0;
};

Deviation deviation_of(std::span<const double> values, std::span<const double> weights) {
    double whole = 0.0;
    double first = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        whole += weights[k];
        first += weights[k] * values[k];
    }
    if (!(whole > 0.0)) return {};
    const double mean = first / whole;
    double second = 0.0;
    for (std::size_t k = 0; k < values.size(); ++k)
        second += weights[k] * (values[k] - mean) * (values[k] - mean);
    return {mean, std::sqrt(second / whole)};
}

// the median distance of neighbouring lines that hold a hundredth of the strongest one's energy or more; 0 for fewer
// than three
double spacing_of(std::vector<double> places) {
    if (places.size() < 3) return 0.0;
    std::adjacent_difference(places.begin(), places.end(), places.begin());
    return signal::median_of(std::span(places).subspan(1));
}

void describe_spectrum(std::span<const double> spectrum, double width, Tones& tones) {
    tones.mean_square = std::accumulate(spectrum.begin(), spectrum.end(), 0.0);
    const auto from = std::min(spectrum.size(), static_cast<std::size_t>(std::ceil(weighted_from / width)));
    std::vector<double> octaves;
    for (std::size_t k = from; k < spectrum.size(); ++k)
        octaves.push_back(base::logarithm_2(static_cast<double>(k) * width));
    const Deviation found = deviation_of(octaves, spectrum.subspan(from));
    if (!(found.mean > 0.0)) return;
    tones.centre = base::power_of_2(found.mean);
    tones.spread = found.deviation;
}

}  // namespace

void ToneFinder::describe_spacing(const Frames& frames, Tones& tones) const {
    std::vector<double> octaves;
    std::vector<double> weights;
    for (const std::vector<Line>& lines : frames.lines) {
        double strongest = 0.0;
        double energy = 0.0;
        for (const Line& line : lines) {
            strongest = std::max(strongest, line.energy);
            energy += line.energy;
        }
        std::vector<double> places;
        for (const Line& line : lines)
            if (line.energy >= 0.01 * strongest) places.push_back(line.place);
        const double spacing = spacing_of(std::move(places));
        if (!(spacing > 0.0)) continue;
        octaves.push_back(base::logarithm_2(spacing));
        weights.push_back(energy);
    }
    const double width = rate_ / static_cast<double>(size_);
    if (!octaves.empty()) tones.spacing = width * base::power_of_2(deviation_of(octaves, weights).mean);
}

// weighted by amplitude and likeness
void ToneFinder::describe_fundamental(const Frames& frames, Tones& tones) {
    if (frames.energy.empty()) return;
    const double least = loud_share * *std::max_element(frames.energy.begin(), frames.energy.end());
    std::vector<double> weights(frames.energy.size());
    for (std::size_t j = 0; j < weights.size(); ++j)
        if (frames.energy[j] > least) weights[j] = std::sqrt(frames.energy[j]) * frames.likeness[j];
    const Deviation found = deviation_of(frames.fundamental, weights);
    if (found.mean > 0.0) tones.fundamental = base::power_of_2(found.mean);
}

Tones ToneFinder::find(std::span<const double> samples) {
    Tones tones;
    const Frames frames = frames_of(samples);
    const double width = rate_ / static_cast<double>(size_);
    const double step = static_cast<double>(frames.hop) / rate_;
    describe_spectrum(frames.spectrum, width, tones);
    describe_fundamental(frames, tones);

    std::vector<double> tonal(frames.power.size());  // [unit²] in tones, shape [frame]
    std::vector<Line> strongest(frames.power.size());
    double energy = 0.0;
    for (const Partial& partial : partials_of(frames)) {
        double here = 0.0;
        for (std::size_t k = 0; k < partial.lines.size(); ++k) {
            const Line& line = partial.lines[k];
            here += line.energy;
            tonal[partial.first + k] += line.energy;
            if (line.energy > strongest[partial.first + k].energy) strongest[partial.first + k] = line;
        }
        energy += here;
        tones.length += here * static_cast<double>(partial.lines.size()) * step;
    }
    if (energy > 0.0) tones.length /= energy;

    std::vector<double> pitches;
    std::vector<double> weights;
    for (std::size_t j = 0; j < tonal.size(); ++j) {
        if (strongest[j].energy > 0.0) {
            const double frequency = strongest[j].place * width;
            tones.pitch.push_back({(static_cast<double>(j) + 1.0) * step, frequency});
            pitches.push_back(base::logarithm_2(frequency));
            weights.push_back(strongest[j].energy);
        }
        tonal[j] = frames.power[j] > 0.0 ? std::min(1.0, tonal[j] / frames.power[j]) : 0.0;
    }
    tones.presence = ninth_decile(std::move(tonal));
    tones.wander = deviation_of(pitches, weights).deviation;
    describe_spacing(frames, tones);
    return tones;
}

}  // namespace stridor::sound
