#pragma once

#include <array>
#include <span>

/// The ear in the model of roughness: curves over the critical-band rate and the modulation frequency.
namespace stridor::sound {

/// A point of a piecewise linear curve.
struct CurvePoint {
    double place;
    double value;
};

/// Returns the value of a curve; beyond its ends that of the end.
double value_at(std::span<const CurvePoint> curve, double place);

/// Returns the critical-band rate [Bark] of a frequency [Hz], up to 20 kHz. Zwicker (1961), edges and centres of the
/// bands.
double critical_band_rate(double frequency);

/// Returns the transmission through the ear from the front [dB] over the critical-band rate. Fastl and Zwicker (2007),
/// figure 8.18.
double transmission(double rate);

/// Returns the threshold of hearing [dB] over the critical-band rate, after the way through the ear.
double hearing_threshold(double rate);

/// Returns the weight of a channel's modulation depth, g [1], over its critical-band rate. Aures (1985).
double modulation_weight(double rate);

/// Returns how well a channel follows a modulation of that frequency [Hz], H [1]. Daniel and Weber (1997), figure 2.
///
/// The channels are counted from 0, at 0.5 Bark.
double modulation_response(std::size_t channel, double frequency);

}  // namespace stridor::sound
