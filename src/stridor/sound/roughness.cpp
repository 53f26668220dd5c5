// Daniel and Weber (1997), "Psychoacoustical roughness: implementation of an optimized model", Acustica 83, 113-123:
//   200 ms, Blackman's window -> spectrum, the way through the ear -> components above the threshold of hearing
//   -> each excites 47 channels along Terhardt's slopes: 27 dB/Bark downwards, 24 + 230 Hz/f - 0.2 L/dB upwards
//   -> the channel's signal, rectified: mean h0 and fluctuation, weighted by H(f): m = rms(H)/h0, up to 1
//   -> correlation k of neighbours 1 Bark apart -> R = c Σ g(z) (m k₋ k₊)².
// The mean squares and products of fluctuations are sums over their spectra (Parseval), so that none is transformed
// back.

#include "stridor/sound/roughness.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/sound/roughness_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stridor::sound {

namespace {

using Complex = std::complex<double>;

constexpr double roughness_rate = 48000.0;                 // [Hz]
constexpr std::size_t frame_size = 9600;                   // 200 ms
constexpr std::size_t hop = frame_size / 2;                // as if half a frame were heard anew
constexpr double line_step = roughness_rate / frame_size;  // [Hz]
constexpr std::size_t first_line = 4;                      // 20 Hz
constexpr std::size_t last_line = 4000;                    // 20 kHz
constexpr std::size_t channel_count = 47;
constexpr std::size_t first_modulation = 2;  // [lines] below it is what the window makes of a steady tone

// what fluctuates less does so by rounding; its correlation with a neighbour would be a matter of chance
constexpr double least_depth = 1e-9;  // [1]

constexpr double most_amplitude = 1e15;  // [1] 300 dB: no sound, and where numbers end

constexpr double down_slope = -27.0;  // [dB/Bark] from a component towards low rates

// so that 1 kHz, 60 dB, wholly modulated with 70 Hz is 1 asper; Daniel and Weber have 0.25 and their own arithmetic
constexpr double asper = 0.25 / 1.0062;

// 10^(decibels / 20)
double amplitude_of(double decibels) {
    constexpr double octaves_per_decibel = 0.16609640474436813;  // log2(10) / 20
    return base::power_of_2(octaves_per_decibel * decibels);
}

double level_of_amplitude(double amplitude) {
    constexpr double decibels_per_octave = 6.020599913279624;
    return decibels_per_octave * base::logarithm_2(amplitude);
}

double power_of(Complex value) {
    return value.real() * value.real() + value.imag() * value.imag();
}

std::vector<double> blackman() {
    std::vector<double> window(frame_size);
    for (std::size_t n = 0; n < frame_size; ++n) {
        const double turns = static_cast<double>(n) / frame_size;
        window[n] = 0.42 - 0.5 * base::sine_cosine_of_turns(turns).cosine +
                    0.08 * base::sine_cosine_of_turns(2.0 * turns).cosine;
    }
    return window;
}

// what of the tables each line of a spectrum and each channel needs
struct RoughEar {
    RoughEar() {
        // a line of amplitude a: a/√2 over 20 uPa, through a window of mean 0.42, 2/N of the transform
        constexpr double line_scale = 2.0 / (0.42 * frame_size) / (1.4142135623730951 * 20e-6);
        for (std::size_t k = first_line; k <= last_line; ++k) {
            rates[k] = critical_band_rate(line_step * static_cast<double>(k));
            scales[k] = line_scale * amplitude_of(transmission(rates[k]));
            thresholds[k] = amplitude_of(hearing_threshold(rates[k]));
        }
        for (std::size_t i = 0; i < channel_count; ++i) {
            const double place = 0.5 * static_cast<double>(i + 1);  // [Bark]
            channel_thresholds[i] = amplitude_of(hearing_threshold(place));
            weights[i] = modulation_weight(place);
            falls[i] = amplitude_of(down_slope * 0.5 * static_cast<double>(i));
            for (std::size_t k = first_modulation; k < responses[i].size(); ++k)
                responses[i][k] = modulation_response(i, line_step * static_cast<double>(k));
        }
    }
    std::array<double, last_line + 1> rates{};       // [Bark]
    std::array<double, last_line + 1> scales{};      // [1/Pa] from the transform to what reaches the inner ear
    std::array<double, last_line + 1> thresholds{};  // [1] over 20 uPa
    std::array<double, channel_count> channel_thresholds{};
    std::array<double, channel_count> weights{};
    std::array<double, channel_count> falls{};  // [1] towards low rates, over so many channels
    std::array<std::array<double, 130>, channel_count> responses{};
};

const RoughEar& rough_ear() {
    static const RoughEar tables;
    return tables;
}

// the channels beside a component; the same one twice if it lies at a channel's place
std::size_t channel_below(double place) {
    return static_cast<std::size_t>(2.0 * place);
}

std::size_t channel_above(double place) {
    return static_cast<std::size_t>(std::ceil(2.0 * place));
}

}  // namespace

RoughnessMeter::RoughnessMeter() : window_(blackman()), transform_(frame_size), shaped_(frame_size) {
    frame_.reserve(frame_size);
    excitation_.resize(frame_size / 2 + 1);
}

void RoughnessMeter::push(std::span<const double> pressures) {
    while (!pressures.empty()) {
        const std::size_t taken = std::min(pressures.size(), frame_size - frame_.size());
        frame_.insert(frame_.end(), pressures.begin(), pressures.begin() + static_cast<std::ptrdiff_t>(taken));
        pressures = pressures.subspan(taken);
        if (frame_.size() < frame_size) return;
        const double roughness = frame_roughness();
        heard_.count(roughness);
        sum_ += roughness;
        frame_.erase(frame_.begin(), frame_.begin() + hop);
    }
}

double RoughnessMeter::mean() const {
    return sum_ / static_cast<double>(heard_.values());  // 0/0 of no frame
}

double RoughnessMeter::exceeded(double share) const {
    return heard_.values() > 0 ? heard_.exceeded(share) : std::numeric_limits<double>::quiet_NaN();
}

void RoughnessMeter::find_components() {
    components_.clear();
    const RoughEar& tables = rough_ear();
    for (std::size_t k = first_line; k <= last_line; ++k) {
        const double amplitude = tables.scales[k] * std::sqrt(power_of(lines_[k]));
        if (!(amplitude > tables.thresholds[k] && amplitude < most_amplitude)) continue;
        const double place = tables.rates[k];
        const double frequency = line_step * static_cast<double>(k);
        // a slope that rises, of more than 120 dB, is none
        const double up_slope = std::min(-24.0 - 230.0 / frequency + 0.2 * level_of_amplitude(amplitude), 0.0);
        const std::size_t below = channel_below(place);
        const std::size_t above = channel_above(place);
        components_.push_back({.line = k,
                               .below = below,
                               .above = above,
                               .amplitude = amplitude,
                               .at_below = amplitude_of(down_slope * (place - 0.5 * static_cast<double>(below))),
                               .reached = amplitude_of(up_slope * (0.5 * static_cast<double>(above) - place)),
                               .rise = amplitude_of(0.5 * up_slope)});
    }
}

// the signal of a channel: components within it whole, others by what reaches its neighbour on their side
void RoughnessMeter::excite(std::size_t channel) {
    const RoughEar& tables = rough_ear();
    const std::size_t number = channel + 1;  // of channels at 0.5, 1, ... Bark; components count alike
    std::fill(excitation_.begin(), excitation_.end(), Complex{});
    for (Component& c : components_) {
        double share = 1.0;
        if (c.above < number) {
            share = c.amplitude * c.reached > tables.channel_thresholds[channel - 1] ? c.reached : 0.0;
            c.reached *= c.rise;
        } else if (c.below > number) {
            if (number == channel_count) continue;
            const double reached = c.at_below * tables.falls[c.below - number - 1];
            share = c.amplitude * reached > tables.channel_thresholds[channel + 1] ? reached : 0.0;
        }
        excitation_[c.line] = share * tables.scales[c.line] * lines_[c.line];
    }
}

RoughnessMeter::Envelope RoughnessMeter::envelope_of(std::size_t channel) {
    excite(channel);
    const std::span<const double> signal = transform_.frame(excitation_);
    double sum = 0.0;
    for (std::size_t n = 0; n < frame_size; ++n) {
        shaped_[n] = std::abs(signal[n]);
        sum += shaped_[n];
    }
    Envelope envelope;
    if (!(sum > 0.0)) return envelope;
    const std::span<const Complex> spectrum = transform_.spectrum(shaped_);
    for (std::size_t k = first_modulation; k < lines; ++k) {
        envelope.spectrum[k] = rough_ear().responses[channel][k] * spectrum[k];
        envelope.power += power_of(envelope.spectrum[k]);
    }
    // both N cancel: rms = √(2 Σ|Y|²) / N, h0 = Σ|x| / N
    const double depth = std::sqrt(2.0 * envelope.power) / sum;
    if (depth < least_depth) return {};
    envelope.depth = std::min(depth, 1.0);
    return envelope;
}

double RoughnessMeter::frame_roughness() {
    for (std::size_t n = 0; n < frame_size; ++n)
        shaped_[n] = window_[n] * frame_[n];
    const std::span<const Complex> spectrum = transform_.spectrum(shaped_);
    lines_.assign(spectrum.begin(), spectrum.end());
    find_components();
    if (components_.empty()) return 0.0;
    for (std::size_t i = 0; i < channels; ++i)
        envelopes_[i] = envelope_of(i);
    double sum = 0.0;
    for (std::size_t i = 0; i < channels; ++i) {
        const double before = i >= 2 ? correlation(envelopes_[i - 2], envelopes_[i]) : 1.0;
        const double after = i + 2 < channels ? correlation(envelopes_[i], envelopes_[i + 2]) : 1.0;
        const double part = envelopes_[i].depth * before * after;
        sum += rough_ear().weights[i] * part * part;
    }
    return asper * sum;
}

// of two fluctuations, 0 if one of them is none
double RoughnessMeter::correlation(const Envelope& a, const Envelope& b) {
    if (!(a.power > 0.0 && b.power > 0.0)) return 0.0;
    double product = 0.0;
    for (std::size_t k = first_modulation; k < lines; ++k)
        product += a.spectrum[k].real() * b.spectrum[k].real() + a.spectrum[k].imag() * b.spectrum[k].imag();
    return product / std::sqrt(a.power * b.power);
}

}  // namespace stridor::sound
