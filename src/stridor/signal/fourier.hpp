#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace stridor::signal {

/// The discrete Fourier transform of real frames of one length, and back: by `RadixFour` if it takes the
/// length, else by Eigen's transform.
///
///     X[k] = Σ x[n] exp(-2πi k n / N),  k = 0 ... N/2;   x[n] = 1/N Σ X[k] exp(+2πi k n / N)
///
/// It keeps its tables and buffers; each thread needs its own. What it returns is valid until its next call.
class Fourier {
public:
    /// Frames of `size` samples; an even number, fastest for powers of two.
    explicit Fourier(std::size_t size);
    ~Fourier();
    Fourier(Fourier&&) noexcept;
    Fourier& operator=(Fourier&&) noexcept;

    /// Samples of a frame [1].
    std::size_t size() const;

    /// The spectrum of a frame, shape [size / 2 + 1]; a frame shorter than `size` is filled with zeros.
    std::span<const std::complex<double>> spectrum(std::span<const double> frame);

    /// The frame of a spectrum of shape [size / 2 + 1].
    std::span<const double> frame(std::span<const std::complex<double>> spectrum);

private:
    struct Buffers;
    std::unique_ptr<Buffers> buffers_;
};

/// The power of two nearest to a time, as a number of samples; at least 64.
std::size_t power_of_two_near(double duration, double rate);

}  // namespace stridor::signal
