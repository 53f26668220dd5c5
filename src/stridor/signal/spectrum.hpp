#pragma once

#include "stridor/signal/fourier.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/signal/window.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::signal {

/// A one-sided spectrum: line k stands at k * spacing.
struct Spectrum {
    double spacing = 0.0;           // [Hz] between lines
    double bandwidth = 0.0;         // [Hz] noise bandwidth of a line
    std::string unit = full_scale;  // of the samples
    std::vector<double> density{};  // [unit²/Hz] shape [line]
    std::size_t frames = 0;         // [1] that were averaged
};

/// How a spectrum is averaged.
struct WelchOptions {
    std::size_t size = 4096;  // [1] samples of a frame
    Window window = Window::hann;
};

/// Welch's averaged spectrum (Welch 1967): half overlapped, windowed frames from the first sample on.
///
///     S[k] = c_k / (rate Σw²) mean |X[k]|²,   c_k = 2, but 1 at 0 Hz and at rate / 2
///
/// so that Σ S spacing is the mean square of the samples (Parseval), exactly for white noise on average, and for one
/// frame through a rectangular window to rounding. Nothing is detrended. Frames are handed on as they come.
class Welch {
public:
    /// Called with the one-sided density of each frame [unit²/Hz], shape [line].
    using Listener = std::function<void(std::span<const double>)>;

    /// Takes the `rate` [Hz] of the samples; the listener may be empty.
    Welch(double rate, WelchOptions options = {}, Listener listener = {});

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// Returns the average so far. Fewer samples than a frame give one frame filled up with zeros; no sample gives no
    /// frame.
    Spectrum spectrum();

    /// Returns the number of samples from one frame to the next [1].
    std::size_t hop() const { return options_.size / 2; }
    /// Returns the distance from one line to the next [Hz].
    double spacing() const { return rate_ / static_cast<double>(options_.size); }

private:
    void take(std::span<const double> samples, double squares);

    double rate_;
    WelchOptions options_;
    Listener listener_;
    Fourier fourier_;
    std::vector<double> window_;
    double squares_;  // Σw²
    std::vector<double> pending_{};
    std::vector<double> windowed_;
    std::vector<double> density_;
    std::vector<double> sum_;
    std::size_t frames_ = 0;
};

/// Returns the spectrum of a whole signal.
Spectrum welch(const Signal& signal, WelchOptions options = {});

/// Returns the mean square between two frequencies [unit²]: each line counts with the share of its spacing inside.
double mean_square_between(const Spectrum& spectrum, double low, double high);

/// Returns the mean square of a sinusoid at each line [unit²], density times noise bandwidth, as a level spectrum
/// shows.
std::vector<double> line_squares(const Spectrum& spectrum);

/// A peak of a spectrum.
struct SpectrumPeak {
    double frequency = 0.0;    // [Hz] between lines, by a parabola through three levels
    double mean_square = 0.0;  // [unit²] of a sinusoid with this peak
    double prominence = 0.0;   // [dB] over the median of the octave around it
};

/// Returns the strongest peaks that stand out by at least `prominence` [dB], strongest first, at most `most`. No peak
/// lies within four lines of a stronger one, none below 20 Hz.
std::vector<SpectrumPeak> strongest_peaks(const Spectrum& spectrum, std::size_t most = 8, double prominence = 10.0);

/// A band of frequencies with its mean square.
struct Band {
    double nominal = 0.0;      // [Hz] the nominal centre, "125", "31.5"; 0: none
    double low = 0.0;          // [Hz]
    double high = 0.0;         // [Hz]
    double mean_square = 0.0;  // [unit²]
};

/// The two widths of a band.
enum class BandWidth { octave, third_octave };

/// Returns the octave or third-octave bands of a spectrum, base-ten centres and edges (IEC 61260-1: G = 10^0.3), from
/// 12.5 Hz (octaves 16 Hz) as far as they lie wholly below half the rate.
///
/// Levels are summed from the spectrum's lines, not by filters: a band narrower than four lines is left out, and the
/// slopes are those of the window instead of the standard's filters.
std::vector<Band> bands(const Spectrum& spectrum, BandWidth width);

/// Returns the A-weighting of a frequency as a factor on mean squares (IEC 61672-1, annex E); 1 at 1 kHz.
double a_weighting(double frequency);

/// Returns the spectrum with A-weighted densities.
Spectrum a_weighted(Spectrum spectrum);

/// A range of frequencies with a name in the field. Reported beside the verdict, which does not use it.
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
