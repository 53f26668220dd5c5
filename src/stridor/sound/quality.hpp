#pragma once

#include "stridor/signal/filter.hpp"
#include "stridor/sound/loudness.hpp"

#include <memory>
#include <span>

namespace stridor::sound {

/// How a listener perceives a sound of known pressure.
struct SoundQuality {
    SoundField field = SoundField::free;
    double loudness = 0.0;                 // [sone] of the mean spectrum, as if it were stationary (ISO 532-1, 5)
    double greatest_loudness = 0.0;        // [sone] largest of the loudness over time (ISO 532-1, 6)
    double loudness_5 = 0.0;               // [sone] N5, exceeded in 5 % of the time
    double loudness_10 = 0.0;              // [sone] N10
    double sharpness = 0.0;                // [acum] of the mean spectrum (DIN 45692)
    double roughness = 0.0;                // [asper] mean over time (Daniel and Weber); NaN below 200 ms
    double roughness_5 = 0.0;              // [asper] R5, exceeded in 5 % of the time; NaN below 200 ms
    signal::ThirdOctaves third_octaves{};  // [Pa²] mean squares, by the filters; 0 beyond half the rate
};

/// Describes a sound pressure as it comes; its memory does not grow. Other rates are resampled to 48 kHz.
class SoundQualityMeter {
public:
    /// Takes the rate [Hz] and the field. Throws what `rate_ratio` throws.
    SoundQualityMeter(double rate, SoundField field);
    ~SoundQualityMeter();
    SoundQualityMeter(SoundQualityMeter&&) noexcept;
    SoundQualityMeter& operator=(SoundQualityMeter&&) noexcept;

    /// Takes the next sound pressures.
    void push(std::span<const double> pressures);  // [Pa]

    /// Ends the sound and returns its quality.
    SoundQuality finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Says whether a third-octave band lies wholly below half the rate [Hz].
bool holds_third_octave(double rate, std::size_t band);

}  // namespace stridor::sound
