#include "stridor/sound/rhythm.hpp"

#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/fourier.hpp"
#include "stridor/signal/powers.hpp"
#include "stridor/signal/window.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace stridor::sound {

namespace {

constexpr double slowest_pace = 4.0;       // [Hz] a passage holds at least a few turns of it
constexpr double fastest_pace = 200.0;     // [Hz]
constexpr double paces_per_octave = 12.0;  // [1]
constexpr std::size_t least_parts = 8;     // of a sound that may have a pace
constexpr std::size_t least_frame = 4096;  // parts: of those of 2 ms each pace holds two lines or more
constexpr double deepest = 1e-9;           // [1] 90 dB below the greatest power all is alike

// [unit²] mean power of each twelfth of an octave
std::vector<double> pace_powers(std::span<const double> lines, double spacing) {
    std::vector<double> powers;
    std::vector<double> counts;
    for (std::size_t k = 1; k < lines.size(); ++k) {
        const double pace = spacing * static_cast<double>(k);
        if (pace < slowest_pace || pace >= fastest_pace) continue;
        const double place = paces_per_octave * base::logarithm_2(pace / slowest_pace);
        const std::size_t bin = base::whole_below(place, 100);
        if (bin >= powers.size()) {
            powers.resize(bin + 1);
            counts.resize(bin + 1);
        }
        powers[bin] += lines[k];
        counts[bin] += 1.0;
    }
    std::size_t kept = 0;
    for (std::size_t bin = 0; bin < powers.size(); ++bin)
        if (counts[bin] > 0.0) powers[kept++] = powers[bin] / counts[bin];
    powers.resize(kept);
    return powers;
}

}  // namespace

double rhythm_of(std::span<const double> squares, double part) {
    if (squares.size() < least_parts) return 0.0;
    const std::vector<double> weights = signal::window(signal::Window::hann, squares.size());
    std::vector<double> amplitudes(squares.size());
    for (std::size_t k = 0; k < squares.size(); ++k)
        amplitudes[k] = std::sqrt(squares[k]);
    const double mean = std::inner_product(amplitudes.begin(), amplitudes.end(), weights.begin(), 0.0) /
                        std::accumulate(weights.begin(), weights.end(), 0.0);
    for (std::size_t k = 0; k < squares.size(); ++k)
        amplitudes[k] = (amplitudes[k] - mean) * weights[k];

    signal::Fourier fourier(std::max(least_frame, std::bit_ceil(squares.size())));
    std::vector<double> lines(fourier.size() / 2 + 1);
    signal::powers_of(fourier.spectrum(amplitudes), lines);
    std::vector<double> powers = pace_powers(lines, 1.0 / (part * static_cast<double>(fourier.size())));
    if (powers.empty()) return 0.0;
    const double greatest = *std::max_element(powers.begin(), powers.end());
    if (!(greatest > 0.0)) return 0.0;
    for (double& power : powers)
        power = power / greatest + deepest;
    base::make_decibels(powers);
    return -std::accumulate(powers.begin(), powers.end(), 0.0) / static_cast<double>(powers.size());
}

}  // namespace stridor::sound
