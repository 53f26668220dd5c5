#pragma once

#include "stridor/signal/fourier.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/signal/window.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The features that distinguish squeal, squeak, creak and mere rubbing in one stretch of sound. Formulas, units and
/// sources: docs/methods/sound.md. Only `mean_square` and `peak` depend on the sound's gain.
struct SoundFeatures {
    double from = 0.0;      // [s] where the stretch begins
    double duration = 0.0;  // [s]

    double mean_square = 0.0;  // [unit²] above 40 Hz, the floor taken away
    double peak = 0.0;         // [unit] largest magnitude above 40 Hz, the floor taken away
    double clearness = 0.0;    // [dB] power of the sound over that of the floor; infinite without a floor

    double frequency = 0.0;             // [Hz] of the strongest line; 0: there is none
    double prominence = 0.0;            // [dB] of that line over the median of its surroundings, an octave wide
    double tonality = 0.0;              // [1] share of the power in that line
    double regularity = 0.0;            // [1] likeness of each cycle of that frequency with the next: autocorrelation
    double repetition = 0.0;            // [1] that likeness at its best cycle up to 25 ms long
    double repetition_frequency = 0.0;  // [Hz] of that best cycle; 0: there is none
    double movement = 0.0;              // [1] standard deviation of the strongest frequency over time, as its share

    double trend = 0.0;         // [dB/s] slope of the level
    double unsteadiness = 0.0;  // [dB] standard deviation of the level around that slope
    double abruptness = 0.0;    // [dB] largest change of the level within 20 ms

    double rest = 0.0;                 // [1] largest share of time spent within a quarter of the effective value
    double kurtosis = 0.0;             // [1] fourth moment over the squared second: sine 1.5, noise 3, impulses more
    double crest = 0.0;                // [1] peak over effective value
    std::size_t impulses = 0;          // [1] rises of the envelope above a third of its peak
    double impulse_interval = 0.0;     // [s] after which the envelope repeats itself best; 0: it does not
    double impulse_periodicity = 0.0;  // [1] autocorrelation of the envelope there
};

/// Returns the energy of a stretch: the integral of its square [Pa^2*s or the sound's unit squared times s].
inline double energy(const SoundFeatures& features) {
    return features.mean_square * features.duration;
}

/// The features of a stretch, and the instants of its impulses [s] from its start, for intervals longer than a stretch.
struct SoundStretch {
    SoundFeatures features;
    std::vector<double> impulses;  // [s] shape [impulse]
};

/// Finds the features of stretches of one rate. It keeps tables and buffers; each thread needs its own.
class FeatureFinder {
public:
    /// Takes the `rate` [Hz] of the samples.
    explicit FeatureFinder(double rate);

    /// Returns the features of a stretch, at least `least_duration` long; `from` stays 0.
    SoundStretch find(std::span<const double> samples);

    static constexpr double least_duration = 0.02;  // [s]

private:
    struct Picture;  // spectra of the stretch's frames, their mean and the floor

    Picture picture_of(std::span<const double> samples);
    void describe_tone(const Picture& picture, SoundFeatures& features);
    void describe_movement(const Picture& picture, double place, SoundFeatures& features);
    void describe_cycles(const Picture& picture, std::span<const double> kept, SoundFeatures& features);
    std::vector<double> above_floor(const Picture& picture, std::size_t size);

    double rate_;
    std::size_t size_;  // samples of a frame
    signal::Fourier fourier_;
    signal::Windows windows_{signal::Window::hann};
    std::vector<double> window_;       // for frames of `size_`
    std::vector<double> window_echo_;  // circular autocorrelation of the window, 1 at lag 0
    std::vector<double> short_window_{};
    std::vector<double> short_echo_{};
};

/// Returns the features of a whole signal as one stretch. Throws `Error` (input) if it is shorter than
/// `least_duration`.
SoundFeatures sound_features(const signal::Signal& signal);

}  // namespace stridor::sound
