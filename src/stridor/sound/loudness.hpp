#pragma once

#include "stridor/signal/filter.hpp"
#include "stridor/sound/exceedance.hpp"

#include <array>
#include <string_view>

/// Loudness by Zwicker's method, ISO 532-1:2017. docs/methods/sound-quality.md.
namespace stridor::sound {

/// How the sound reaches the listener: from the front, or from everywhere.
enum class SoundField { free, diffuse };

inline constexpr std::array<std::string_view, 2> sound_field_names{"free", "diffuse"};

/// Core loudness of the 20 critical bands [sone/Bark], and a last 0 above them.
using CoreLoudness = std::array<double, 21>;

/// Specific loudness [sone/Bark] at 0.1, 0.2, ... 24 Bark.
using SpecificLoudness = std::array<double, 240>;

/// Returns the core loudness of third-octave powers, as mean squares over (20 uPa)² [1] from 25 Hz (ISO 532-1, A.3).
///
/// Valid for levels up to 120 dB below 300 Hz; beyond that the correction for 120 dB is used.
CoreLoudness core_loudness(const signal::ThirdOctaves& ratios, SoundField field);

/// Returns the total loudness [sone]: core loudness with the slopes towards higher bands, integrated over the
/// critical-band rate. Not rounded. Writes the specific loudness to `specific` unless null.
double total_loudness(const CoreLoudness& core, SpecificLoudness* specific = nullptr);

/// Returns the loudness level [phon] of a loudness [sone].
double loudness_level(double loudness);

/// Returns the sharpness [acum] of a specific loudness, DIN 45692:2009; 0 for silence.
double sharpness(const SpecificLoudness& specific);

/// Loudness over time, 2000 values a second (ISO 532-1, 6): critical bands decay as in the ear, and their sum is
/// weighted in time.
class LoudnessOverTime {
public:
    /// Takes the `field`: the sound comes from the front or from all sides.
    explicit LoudnessOverTime(SoundField field) : field_(field) {}

    /// Takes smoothed powers over (20 uPa)² [1], each half a millisecond after the last.
    void push(const signal::ThirdOctaves& ratios);

    /// Accounts for the end of the last power; nothing may be pushed afterwards.
    void finish();

    /// Returns the largest loudness [sone].
    double greatest() const { return heard_.greatest(); }

    /// Returns the loudness [sone] that is exceeded in this share of the time [1], within 0.1 %.
    double exceeded(double share) const { return heard_.exceeded(share); }

private:
    void decay(const CoreLoudness& next);
    void weigh(double next);

    SoundField field_;
    bool has_core_ = false;
    CoreLoudness core_{};     // of half a millisecond ago
    CoreLoudness decayed_{};  // [sone/Bark] what the ear still holds
    CoreLoudness charge_{};   // [sone/Bark] the slower memory behind it
    bool has_sum_ = false;
    double sum_ = 0.0;    // [sone] of half a millisecond ago
    double fast_ = 0.0;   // [sone] low pass of 3.5 ms
    double slow_ = 0.0;   // [sone] low pass of 70 ms
    Exceedance heard_{};  // [sone]
};

}  // namespace stridor::sound
