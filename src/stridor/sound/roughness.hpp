#pragma once

#include "stridor/signal/fourier.hpp"
#include "stridor/sound/exceedance.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// Roughness [asper] over time by the model of Daniel and Weber (1997): how rough a listener finds fluctuations of some
/// 15 to 300 Hz. 1 asper: 1 kHz, 60 dB, wholly modulated in amplitude with 70 Hz. docs/methods/sound-quality.md.
///
/// It analyses 200 ms every 100 ms. The sound comes from the front; the model has no other form.
class RoughnessMeter {
public:
    /// Begins before the first sample.
    RoughnessMeter();

    /// Takes sound pressures [Pa] at 48 kHz.
    void push(std::span<const double> pressures);

    /// Returns the mean over the frames [asper]; NaN for a sound shorter than 200 ms.
    double mean() const;

    /// Returns the roughness that is exceeded in this share of the frames [asper], within 0.1 %; NaN for a sound
    /// shorter than 200 ms.
    double exceeded(double share) const;

private:
    static constexpr std::size_t channels = 47;  // half a Bark apart, from 0.5 Bark on
    static constexpr std::size_t lines = 130;    // of an envelope: no weight has any of 650 Hz or more

    // Channels are counted from 1, at 0.5 Bark. Shares are of the component's own amplitude.
    struct Component {
        std::size_t line;   // of the frame's spectrum
        std::size_t below;  // the channel at its place or next below; `above` alike
        std::size_t above;
        double amplitude;  // [1] over 20 uPa, after the way through the ear
        double at_below;   // [1] share that reaches `below`
        double reached;    // [1] share that reaches `above`; then the next, as channels are looked at
        double rise;       // [1] of that share, from a channel to the next higher
    };
    struct Envelope {
        std::array<std::complex<double>, lines> spectrum{};  // weighted by the ear's band pass of modulations
        double power = 0.0;                                  // of that spectrum
        double depth = 0.0;                                  // [1] of modulation, up to 1
    };

    double frame_roughness();
    void find_components();
    void excite(std::size_t channel);
    Envelope envelope_of(std::size_t channel);
    static double correlation(const Envelope& a, const Envelope& b);

    std::vector<double> window_;
    signal::Fourier transform_;
    std::vector<double> frame_{};                     // [Pa] the last 200 ms, as far as they came
    std::vector<double> shaped_{};                    // by the window, then rectified
    std::vector<Component> components_{};             // audible ones, by rising frequency
    std::vector<std::complex<double>> lines_{};       // of the whole frame
    std::vector<std::complex<double>> excitation_{};  // of one channel
    std::array<Envelope, channels> envelopes_{};
    Exceedance heard_{};  // [asper]
    double sum_ = 0.0;    // [asper]
};

}  // namespace stridor::sound
