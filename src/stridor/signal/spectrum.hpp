#pragma once

#include "stridor/signal/fourier.hpp"
#include "stridor/signal/signal.hpp"
#include "stridor/signal/window.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
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

    /// `rate` [Hz] of the samples; the listener may be empty.
    Welch(double rate, WelchOptions options = {}, Listener listener = {});

    /// Takes the next samples.
    void push(std::span<const double> samples);

    /// Averaged so far. Fewer samples than a frame give one frame filled up with zeros; none give no frame.
    Spectrum spectrum();

    /// From one frame to the next [1] samples.
    std::size_t hop() const { return options_.size / 2; }
    /// From one line to the next [Hz].
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

/// The spectrum of a whole signal.
Spectrum welch(const Signal& signal, WelchOptions options = {});

/// Mean square between two frequencies [unit²]: lines count with the share of their spacing that lies inside.
double mean_square_between(const Spectrum& spectrum, double low, double high);

/// Mean square of a sinusoid at each line [unit²]: density times noise bandwidth. What a level spectrum shows.
std::vector<double> line_squares(const Spectrum& spectrum);

/// A peak of a spectrum.
struct SpectrumPeak {
    double frequency = 0.0;    // [Hz] between lines, by a parabola through three levels
    double mean_square = 0.0;  // [unit²] of the sinusoid it would be
    double prominence = 0.0;   // [dB] over the median of the octave around it
};

/// The strongest peaks that stand out by at least `prominence` [dB], strongest first, at most `most`, none within four
/// lines of a stronger one and none below 20 Hz.
std::vector<SpectrumPeak> strongest_peaks(const Spectrum& spectrum, std::size_t most = 8, double prominence = 10.0);

}  // namespace stridor::signal
