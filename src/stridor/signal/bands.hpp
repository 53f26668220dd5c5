#pragma once

#include "stridor/signal/spectrum.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// A band of frequencies with the mean square of what lies in it.
struct Band {
    double nominal = 0.0;      // [Hz] the name of its centre, "125", "31.5"; 0: it has none
    double low = 0.0;          // [Hz]
    double high = 0.0;         // [Hz]
    double mean_square = 0.0;  // [unit²]
};

/// How wide a band is.
enum class BandWidth { octave, third_octave };

/// Octave or third-octave bands of a spectrum, base-ten centres and edges (IEC 61260-1: G = 10^0.3), from 12.5 Hz
/// (octaves 16 Hz) as far as they lie wholly below half the rate.
///
/// Levels are summed from the spectrum's lines, not by filters: a band narrower than four lines is left out, and the
/// slopes are those of the window instead of the standard's filters.
std::vector<Band> bands(const Spectrum& spectrum, BandWidth width);

/// A-weighting of a frequency as a factor on mean squares (IEC 61672-1, annex E); 1 at 1 kHz.
double a_weighting(double frequency);

/// The spectrum with A-weighted densities.
Spectrum a_weighted(Spectrum spectrum);

/// A range of frequencies that the field has a name for. Reported beside the verdict, which does not use them.
struct NamedBand {
    std::string_view name;
    std::string_view source;
    double low = 0.0;   // [Hz]
    double high = 0.0;  // [Hz]
};

inline constexpr std::array<NamedBand, 4> named_bands{{
    {"brake squeal", "SAE J2521: 1.25 to 16 kHz, counted from 70 dB(A)", 1250.0, 16000.0},
    {"creep groan", "brakes: below 100 Hz", 20.0, 100.0},
    {"wiper squeal", "about 1 kHz", 700.0, 1400.0},
    {"wiper chatter", "below 100 Hz", 10.0, 100.0},
}};

/// Level from which SAE J2521 counts a squeal [dB(A) re 20 uPa].
inline constexpr double squeal_level_j2521 = 70.0;

}  // namespace stridor::signal
