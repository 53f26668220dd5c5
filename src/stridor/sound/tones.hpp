#pragma once

#include "stridor/signal/fourier.hpp"

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::sound {

/// The top of a parabola.
struct Summit {
    double place = 0.0;  // in steps from the middle value
    double height = 0.0;
};

/// Returns the top of the parabola through a greatest value and its neighbours, at most half a step away; the middle
/// value if the three do not bend down.
Summit parabola_summit(double left, double centre, double right);

/// The strongest tone at an instant.
struct TonePoint {
    double time = 0.0;       // [s]
    double frequency = 0.0;  // [Hz]
};

/// The tones of a passage, and how its A-weighted power spreads over frequency. Formulas: docs/methods/ear.md.
struct Tones {
    double mean_square = 0.0;        // [unit²] A-weighted
    double presence = 0.0;           // [1] share of the power in tones, in the frame that nine tenths stay below
    double length = 0.0;             // [s] how long a tone lasts, weighted by energy; 0: there is none
    double wander = 0.0;             // [octave] standard deviation of the strongest tone's pitch
    double spacing = 0.0;            // [Hz] between neighbouring lines, where three or more sound; 0: nowhere
    double centre = 0.0;             // [Hz] geometric mean of the power's frequencies; 0: silence
    double spread = 0.0;             // [octave] their standard deviation
    double fundamental = 0.0;        // [Hz] how often the wave repeats, geometric mean; 0: silence
    std::vector<TonePoint> pitch{};  // where there is a tone, in time
};

/// Follows sinusoidal partials through short frames (McAulay and Quatieri 1986): lines that stand 9 dB out of their
/// surroundings, in three frames or more. So a gliding sound keeps its harmonics, and no harmonic must be the
/// strongest.
///
/// It keeps tables and buffers; each thread needs its own.
class ToneFinder {
public:
    /// Takes the `rate` [Hz] of the samples.
    explicit ToneFinder(double rate);

    /// Returns the tones of a passage of any length; times count from its beginning.
    Tones find(std::span<const double> samples);

private:
    struct Line;
    struct Partial;
    struct Frames;

    Frames frames_of(std::span<const double> samples);
    std::vector<Line> lines_of(std::span<const double> power) const;
    std::span<const double> autocorrelation_of(std::span<const double> power);
    void add_fundamental(std::span<double> power, Frames& frames);
    static void describe_fundamental(const Frames& frames, Tones& tones);
    std::vector<Partial> partials_of(const Frames& frames) const;
    void describe_spacing(const Frames& frames, Tones& tones) const;

    double rate_;
    std::size_t size_;  // samples of a frame
    signal::Fourier fourier_;
    std::vector<double> window_;
    std::vector<double> weights_{};  // [1] A-weighting, shape [bin]
    std::vector<std::complex<double>> numbers_{};
    std::vector<double> windowed_{};  // [1] 1 over the window's own autocorrelation, shape [lag]
    std::size_t shortest_ = 0;        // lags at which the wave may repeat, in samples
    std::size_t longest_ = 0;
    std::size_t lowest_ = 0;  // bins of tones
    std::size_t highest_ = 0;
};

}  // namespace stridor::sound
