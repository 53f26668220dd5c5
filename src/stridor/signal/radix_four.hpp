#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

namespace stridor::signal {

/// The transform of `Fourier` for frames of a power of two: radix 4, with real and imaginary parts apart, so that
/// several numbers are taken at a time. Error: a few roundings, growing with the logarithm of the size.
///
/// It keeps its tables and buffers; each thread needs its own.
class RadixFour {
public:
    /// Can frames of `size` samples be transformed: is it a power of two, 16 or more?
    static bool takes(std::size_t size);

    /// Frames of `size` samples.
    explicit RadixFour(std::size_t size);

    /// The spectrum of a frame, shapes [size] and [size / 2 + 1].
    void forward(std::span<const double> frame, std::span<std::complex<double>> spectrum);

    /// The frame of a spectrum, likewise.
    void backward(std::span<const std::complex<double>> spectrum, std::span<double> frame);

private:
    struct Turn {
        double cosine = 1.0;
        double sine = 0.0;  // of a negative angle
    };

    /// Transforms half_ complex numbers, real and imaginary parts in turns, into `here_`.
    void transform(const double* numbers);
    double* real(std::vector<double>& buffer) const { return buffer.data(); }
    double* imaginary(std::vector<double>& buffer) const { return buffer.data() + buffer.size() / 2; }

    std::size_t half_;             // complex numbers that a frame makes
    std::vector<double> first_{};  // cosines, sines of once, twice, three times the turn, shape [6][half / 4]
    std::vector<Turn> later_{};    // the same of the later stages, shape [stage][butterfly][3]
    std::vector<Turn> turns_{};    // exp(-2πi k / size), shape [half / 2 + 1]
    std::vector<double> here_;     // real parts, then imaginary ones
    std::vector<double> there_;
    std::vector<double> numbers_{};
};

}  // namespace stridor::signal
