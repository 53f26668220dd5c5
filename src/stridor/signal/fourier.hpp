#pragma once

#include "stridor/base/aligned.hpp"
#include "stridor/base/elementary.hpp"

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace stridor::signal {

/// The transform of `Fourier` for frames of a power of two: radix 4, with real and imaginary parts apart, so that
/// several numbers are taken at a time. Error: a few roundings, growing with the logarithm of the size.
///
/// It keeps its tables and buffers; each thread needs its own.
class RadixFour {
public:
    /// Says whether frames of `size` samples can be transformed: a power of two, 16 or more.
    static bool takes(std::size_t size);

    /// Makes a transform for frames of `size` samples.
    explicit RadixFour(std::size_t size);

    /// Writes the spectrum of a frame; shapes [size] and [size / 2 + 1].
    void forward(std::span<const double> frame, std::span<std::complex<double>> spectrum);

    /// Writes the frame of a spectrum; shapes [size / 2 + 1] and [size].
    void backward(std::span<const std::complex<double>> spectrum, std::span<double> frame);

private:
    /// Transforms half_ complex numbers, real and imaginary parts in turns, into `here_`.
    void transform(const double* numbers);
    double* real(base::AlignedVector<double>& buffer) const { return buffer.data(); }
    double* imaginary(base::AlignedVector<double>& buffer) const { return buffer.data() + buffer.size() / 2; }

    std::size_t half_;                       // complex numbers that a frame makes
    base::AlignedVector<double> first_{};    // cosines, sines of once, twice, three times the turn, shape [6][half / 4]
    std::vector<base::SineCosine> later_{};  // the same of the later stages, shape [stage][butterfly][3]
    std::vector<base::SineCosine> turns_{};  // exp(-2πi k / size), shape [half / 2 + 1]
    base::AlignedVector<double> here_;       // real parts, then imaginary ones
    base::AlignedVector<double> there_;
    base::AlignedVector<double> numbers_{};
};

/// The discrete Fourier transform of real frames of one length, and back: by `RadixFour` if it takes the
/// length, else by Eigen's transform. The bits are the same on every machine.
///
///     X[k] = Σ x[n] exp(-2πi k n / N),  k = 0 ... N/2;   x[n] = 1/N Σ X[k] exp(+2πi k n / N)
///
/// It keeps its tables and buffers; each thread needs its own. A result is valid until the next call.
class Fourier {
public:
    /// Makes a transform for frames of `size` samples; an even number, fastest for powers of two.
    explicit Fourier(std::size_t size);
    ~Fourier();
    Fourier(Fourier&&) noexcept;
    Fourier& operator=(Fourier&&) noexcept;

    /// Returns the number of samples of a frame [1].
    std::size_t size() const;

    /// Returns the spectrum of a frame, shape [size / 2 + 1]. A frame shorter than `size` is filled with zeros.
    std::span<const std::complex<double>> spectrum(std::span<const double> frame);

    /// Returns the frame of a spectrum of shape [size / 2 + 1].
    std::span<const double> frame(std::span<const std::complex<double>> spectrum);

private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

/// Returns the power of two nearest to a duration [s], as a number of samples; at least 64.
std::size_t power_of_two_near(double duration, double rate);

}  // namespace stridor::signal
