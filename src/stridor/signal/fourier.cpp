#include "stridor/signal/fourier.hpp"

#include "stridor/base/check.hpp"
#include "stridor/signal/radix_four.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <optional>
#include <vector>

namespace stridor::signal {

struct Fourier::Buffers {
    explicit Buffers(std::size_t count) : size(count), time(count), half(count / 2 + 1) {
        transform.SetFlag(Eigen::FFT<double>::HalfSpectrum);
        if (RadixFour::takes(count)) radix_four.emplace(count);
    }
    std::optional<RadixFour> radix_four{};  // takes half the time
    Eigen::FFT<double> transform;
    std::size_t size;
    std::vector<double> time;
    std::vector<std::complex<double>> half;
};

Fourier::Fourier(std::size_t size) : buffers_(std::make_unique<Buffers>(size)) {
    STRIDOR_EXPECT(size >= 2 && size % 2 == 0);
}
Fourier::~Fourier() = default;
Fourier::Fourier(Fourier&&) noexcept = default;
Fourier& Fourier::operator=(Fourier&&) noexcept = default;

std::size_t Fourier::size() const {
    return buffers_->size;
}

std::span<const std::complex<double>> Fourier::spectrum(std::span<const double> frame) {
    STRIDOR_EXPECT(frame.size() <= size());
    std::vector<double>& time = buffers_->time;
    const auto end = std::copy(frame.begin(), frame.end(), time.begin());
    std::fill(end, time.end(), 0.0);
    if (buffers_->radix_four)
        buffers_->radix_four->forward(time, buffers_->half);
    else
        buffers_->transform.fwd(buffers_->half.data(), time.data(), static_cast<Eigen::Index>(time.size()));
    return buffers_->half;
}

std::span<const double> Fourier::frame(std::span<const std::complex<double>> spectrum) {
    STRIDOR_EXPECT(spectrum.size() == size() / 2 + 1);
    if (buffers_->radix_four) {
        buffers_->radix_four->backward(spectrum, buffers_->time);
        return buffers_->time;
    }
    std::copy(spectrum.begin(), spectrum.end(), buffers_->half.begin());
    buffers_->transform.inv(buffers_->time.data(), buffers_->half.data(), static_cast<Eigen::Index>(size()));
    return buffers_->time;
}

std::size_t power_of_two_near(double duration, double rate) {
    const double samples = duration * rate;
    std::size_t size = 64;
    // the nearer neighbour by ratio: 1.5 is far enough from both 1 and 2 to do without a logarithm
    while (static_cast<double>(size) * 1.4142135623730951 < samples)
        size *= 2;
    return size;
}

}  // namespace stridor::signal
