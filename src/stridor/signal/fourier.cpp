#include "stridor/signal/fourier.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"
#include "stridor/base/elementary.hpp"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace stridor::signal {

namespace {

// Stockham's order of the fast Fourier transform (Cochran et al. 1967, Proceedings of the IEEE 55, 1664): a stage of
// radix 4 takes one number out of each quarter and writes its results where the next stage finds them, so nothing is
// put in order at the end. With n numbers left to a transform, s transforms side by side and w = exp(-2πi p / n):
//     y[q + s 4p + s j] = wʲ Σ_l (-i)^(jl) x[q + s p + s l n/4],  j = 0 ... 3,  p < n / 4,  q < s
// N real samples are N / 2 complex numbers x[2n] + i x[2n+1]. Of their transform Z come the lines
//     X[k] = (Z[k] + Z*[N/2-k]) / 2 - i/2 exp(-2πi k / N) (Z[k] - Z*[N/2-k]).
// The way back swaps real and imaginary parts, before and after.

// a cache line between the parts, for streams a power of two apart push each other out of the cache
constexpr std::size_t gap = 8;

// the stage in which s is 1: the numbers' parts still take turns, and `w` holds six rows
STRIDOR_CLONES void first_stage(const double* __restrict x, double* __restrict real, double* __restrict imaginary,
                                std::size_t quarter, const double* __restrict w) {
#pragma omp simd
    for (std::size_t p = 0; p < quarter; ++p) {
        const double* a = x + 2 * p;
        const double* b = a + 2 * quarter;
        const double* c = b + 2 * quarter;
        const double* d = c + 2 * quarter;
        const double even_r = a[0] + c[0];
        const double even_i = a[1] + c[1];
        const double odd_r = b[0] + d[0];
        const double odd_i = b[1] + d[1];
        const double left_r = a[0] - c[0];
        const double left_i = a[1] - c[1];
        const double right_r = b[0] - d[0];
        const double right_i = b[1] - d[1];
        const double one_r = left_r + right_i;
        const double one_i = left_i - right_r;
        const double two_r = even_r - odd_r;
        const double two_i = even_i - odd_i;
        const double three_r = left_r - right_i;
        const double three_i = left_i + right_r;
        real[4 * p] = even_r + odd_r;
        real[4 * p + 1] = w[p] * one_r - w[p + quarter] * one_i;
        real[4 * p + 2] = w[p + 2 * quarter] * two_r - w[p + 3 * quarter] * two_i;
        real[4 * p + 3] = w[p + 4 * quarter] * three_r - w[p + 5 * quarter] * three_i;
        imaginary[4 * p] = even_i + odd_i;
        imaginary[4 * p + 1] = w[p] * one_i + w[p + quarter] * one_r;
        imaginary[4 * p + 2] = w[p + 2 * quarter] * two_i + w[p + 3 * quarter] * two_r;
        imaginary[4 * p + 3] = w[p + 4 * quarter] * three_i + w[p + 5 * quarter] * three_r;
    }
}

// Numbers with their parts apart.
struct Numbers {
    const double* real;
    const double* imaginary;
};
struct Results {
    double* real;
    double* imaginary;
};

// A later stage, of s transforms side by side: s is a multiple of four. The numbers of a butterfly lie `apart`.
inline void butterflies(Numbers x, std::size_t apart, Results y, std::size_t s, const base::SineCosine* w) {
    const base::SineCosine one = w[0];
    const base::SineCosine two = w[1];
    const base::SineCosine three = w[2];
    const double* __restrict from_r = x.real;
    const double* __restrict from_i = x.imaginary;
    double* __restrict to_r = y.real;
    double* __restrict to_i = y.imaginary;
    for (std::size_t first = 0; first < s; first += 4)
#pragma omp simd
        for (std::size_t q = first; q < first + 4; ++q) {
            const double even_r = from_r[q] + from_r[q + 2 * apart];
            const double even_i = from_i[q] + from_i[q + 2 * apart];
            const double odd_r = from_r[q + apart] + from_r[q + 3 * apart];
            const double odd_i = from_i[q + apart] + from_i[q + 3 * apart];
            const double left_r = from_r[q] - from_r[q + 2 * apart];
            const double left_i = from_i[q] - from_i[q + 2 * apart];
            const double right_r = from_r[q + apart] - from_r[q + 3 * apart];
            const double right_i = from_i[q + apart] - from_i[q + 3 * apart];
            const double one_r = left_r + right_i;
            const double one_i = left_i - right_r;
            const double two_r = even_r - odd_r;
            const double two_i = even_i - odd_i;
            const double three_r = left_r - right_i;
            const double three_i = left_i + right_r;
            to_r[q] = even_r + odd_r;
            to_r[q + s] = one.cosine * one_r - one.sine * one_i;
            to_r[q + 2 * s] = two.cosine * two_r - two.sine * two_i;
            to_r[q + 3 * s] = three.cosine * three_r - three.sine * three_i;
            to_i[q] = even_i + odd_i;
            to_i[q + s] = one.cosine * one_i + one.sine * one_r;
            to_i[q + 2 * s] = two.cosine * two_i + two.sine * two_r;
            to_i[q + 3 * s] = three.cosine * three_i + three.sine * three_r;
        }
}

// all butterflies of a stage that has n numbers left to a transform
STRIDOR_CLONES void later_stage(Numbers x, Results y, std::size_t n, std::size_t s, const base::SineCosine* w) {
    for (std::size_t p = 0; p < n / 4; ++p)
        butterflies(Numbers{x.real + s * p, x.imaginary + s * p}, n * s / 4,
                    Results{y.real + 4 * s * p, y.imaginary + 4 * s * p}, s, w + 3 * p);
}

// the last stage, of radix 2, where half the size is no power of four
STRIDOR_CLONES void pairs(Numbers x, Results y, std::size_t s) {
#pragma omp simd
    for (std::size_t q = 0; q < s; ++q) {
        y.real[q] = x.real[q] + x.real[q + s];
        y.real[q + s] = x.real[q] - x.real[q + s];
        y.imaginary[q] = x.imaginary[q] + x.imaginary[q + s];
        y.imaginary[q + s] = x.imaginary[q] - x.imaginary[q + s];
    }
}

// The lines of a frame out of the transform of its half as many complex numbers; a line's parts take turns.
STRIDOR_CLONES void lines_of(Numbers z, std::size_t half, const base::SineCosine* __restrict turn,
                             double* __restrict spectrum) {
    const double* __restrict re = z.real;
    const double* __restrict im = z.imaginary;
    spectrum[0] = re[0] + im[0];
    spectrum[1] = 0.0;
    spectrum[2 * half] = re[0] - im[0];
    spectrum[2 * half + 1] = 0.0;
#pragma omp simd
    for (std::size_t k = 1; k < half / 2; ++k) {
        const std::size_t mirror = half - k;
        const double even_r = 0.5 * (re[k] + re[mirror]);
        const double even_i = 0.5 * (im[k] - im[mirror]);
        const double odd_r = 0.5 * (im[k] + im[mirror]);
        const double odd_i = 0.5 * (re[mirror] - re[k]);
        const double turned_r = turn[k].cosine * odd_r - turn[k].sine * odd_i;
        const double turned_i = turn[k].cosine * odd_i + turn[k].sine * odd_r;
        spectrum[2 * k] = even_r + turned_r;
        spectrum[2 * k + 1] = even_i + turned_i;
        spectrum[2 * mirror] = even_r - turned_r;
        spectrum[2 * mirror + 1] = turned_i - even_i;
    }
    // the line that mirrors itself
    const std::size_t middle = half / 2;
    spectrum[2 * middle] = re[middle] - turn[middle].cosine * im[middle];
    spectrum[2 * middle + 1] = turn[middle].sine * im[middle];
}

// The complex numbers whose transform holds the samples of a frame, with real and imaginary parts swapped.
STRIDOR_CLONES void numbers_of(const double* __restrict spectrum, std::size_t half,
                               const base::SineCosine* __restrict turn, double* __restrict numbers) {
    const double scale = 0.5 / static_cast<double>(half);
    numbers[0] = scale * (spectrum[0] - spectrum[2 * half]);
    numbers[1] = scale * (spectrum[0] + spectrum[2 * half]);
#pragma omp simd
    for (std::size_t k = 1; k < half / 2; ++k) {
        const std::size_t mirror = half - k;
        const double even_r = spectrum[2 * k] + spectrum[2 * mirror];
        const double even_i = spectrum[2 * k + 1] - spectrum[2 * mirror + 1];
        const double left_r = spectrum[2 * k] - spectrum[2 * mirror];
        const double left_i = spectrum[2 * k + 1] + spectrum[2 * mirror + 1];
        const double odd_r = turn[k].cosine * left_r + turn[k].sine * left_i;
        const double odd_i = turn[k].cosine * left_i - turn[k].sine * left_r;
        numbers[2 * k] = scale * (even_i + odd_r);
        numbers[2 * k + 1] = scale * (even_r - odd_i);
        numbers[2 * mirror] = scale * (odd_r - even_i);
        numbers[2 * mirror + 1] = scale * (even_r + odd_i);
    }
    // the line that mirrors itself
    const std::size_t middle = half / 2;
    const double twice_r = 2.0 * spectrum[2 * middle];
    const double twice_i = 2.0 * spectrum[2 * middle + 1];
    numbers[2 * middle] = scale * (turn[middle].sine * twice_i);
    numbers[2 * middle + 1] = scale * (twice_r + turn[middle].cosine * twice_i);
}

// the parts swapped back
STRIDOR_CLONES void samples_of(Numbers z, std::size_t half, double* __restrict frame) {
    const double* __restrict re = z.real;
    const double* __restrict im = z.imaginary;
#pragma omp simd
    for (std::size_t n = 0; n < half; ++n) {
        frame[2 * n] = im[n];
        frame[2 * n + 1] = re[n];
    }
}

// Eigen's transform of any length, with turns of our own: the last bits of the C library's depend on the machine. It
// takes a frame as complex numbers.
class AnyLength {
public:
    explicit AnyLength(std::size_t size)
        : forward_(plan(size, Way::forward)),
          backward_(plan(size, Way::backward)),
          from_(size),
          to_(size) {}

    void forward(std::span<const double> frame, std::span<std::complex<double>> spectrum) {
        forward_.work(0, to_.data(), frame.data(), 1, 1);
        std::copy_n(to_.begin(), spectrum.size(), spectrum.begin());
    }

    void backward(std::span<const std::complex<double>> spectrum, std::span<double> frame) {
        std::copy(spectrum.begin(), spectrum.end(), from_.begin());
        for (std::size_t k = 1; k < spectrum.size(); ++k)
            from_[from_.size() - k] = std::conj(spectrum[k]);
        backward_.work(0, to_.data(), from_.data(), 1, 1);
        const double scale = 1.0 / static_cast<double>(frame.size());
        std::transform(to_.begin(), to_.end(), frame.begin(),
                       [=](const std::complex<double>& number) { return scale * number.real(); });
    }

private:
    enum class Way { forward, backward };
    using Plan = Eigen::internal::kiss_cpx_fft<double>;

    static Plan plan(std::size_t size, Way way) {
        Plan made;
        made.m_inverse = way == Way::backward;
        for (std::size_t k = 0; k < size; ++k) {
            const base::SineCosine turn =
                base::sine_cosine_of_turns(static_cast<double>(k) / static_cast<double>(size));
            made.m_twiddles.emplace_back(turn.cosine, made.m_inverse ? turn.sine : -turn.sine);
        }
        made.factorize(static_cast<int>(size));
        return made;
    }

    Plan forward_;
    Plan backward_;
    std::vector<std::complex<double>> from_;
    std::vector<std::complex<double>> to_;
};

}  // namespace

bool RadixFour::takes(std::size_t size) {
    return size >= 16 && std::has_single_bit(size);
}

RadixFour::RadixFour(std::size_t size)
    : half_(size / 2),
      here_(2 * (half_ + gap)),
      there_(here_.size()),
      numbers_(size) {
    STRIDOR_EXPECT(takes(size));
    const auto turn = [](std::size_t k, std::size_t n) {
        const base::SineCosine angle = base::sine_cosine_of_turns(static_cast<double>(k) / static_cast<double>(n));
        return base::SineCosine{-angle.sine, angle.cosine};
    };
    const std::size_t quarter = half_ / 4;
    first_.resize(6 * quarter);
    for (std::size_t order = 1; order <= 3; ++order)
        for (std::size_t p = 0; p < quarter; ++p) {
            first_[(2 * order - 2) * quarter + p] = turn(order * p, half_).cosine;
            first_[(2 * order - 1) * quarter + p] = turn(order * p, half_).sine;
        }
    for (std::size_t n = quarter; n >= 4; n /= 4)
        for (std::size_t p = 0; p < n / 4; ++p)
            for (std::size_t order = 1; order <= 3; ++order)
                later_.push_back(turn(order * p, n));
    for (std::size_t k = 0; k <= half_ / 2; ++k)
        turns_.push_back(turn(k, size));
}

void RadixFour::transform(const double* numbers) {
    first_stage(numbers, real(here_), imaginary(here_), half_ / 4, first_.data());
    const base::SineCosine* w = later_.data();
    std::size_t s = 4;
    std::size_t n = half_ / 4;
    for (; n >= 4; n /= 4, s *= 4) {
        later_stage(Numbers{real(here_), imaginary(here_)}, Results{real(there_), imaginary(there_)}, n, s, w);
        std::swap(here_, there_);
        w += 3 * (n / 4);
    }
    if (n == 2) {
        pairs({real(here_), imaginary(here_)}, {real(there_), imaginary(there_)}, s);
        std::swap(here_, there_);
    }
}

void RadixFour::forward(std::span<const double> frame, std::span<std::complex<double>> spectrum) {
    STRIDOR_EXPECT(frame.size() == 2 * half_ && spectrum.size() == half_ + 1);
    transform(frame.data());
    lines_of({real(here_), imaginary(here_)}, half_, turns_.data(), reinterpret_cast<double*>(spectrum.data()));
}

void RadixFour::backward(std::span<const std::complex<double>> spectrum, std::span<double> frame) {
    STRIDOR_EXPECT(frame.size() == 2 * half_ && spectrum.size() == half_ + 1);
    numbers_of(reinterpret_cast<const double*>(spectrum.data()), half_, turns_.data(), numbers_.data());
    transform(numbers_.data());
    samples_of({real(here_), imaginary(here_)}, half_, frame.data());
}

struct Fourier::Buffers {
    explicit Buffers(std::size_t count) : size(count), time(count), half(count / 2 + 1) {
        if (RadixFour::takes(count))
            radix_four.emplace(count);
        else
            any_length.emplace(count);
    }
    std::optional<RadixFour> radix_four{};  // takes a quarter of the time
    std::optional<AnyLength> any_length{};
    std::size_t size;
    base::AlignedVector<double> time;
    base::AlignedVector<std::complex<double>> half;
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
    if (buffers_->radix_four && frame.size() == size()) {
        buffers_->radix_four->forward(frame, buffers_->half);
        return buffers_->half;
    }
    base::AlignedVector<double>& time = buffers_->time;
    const auto end = std::copy(frame.begin(), frame.end(), time.begin());
    std::fill(end, time.end(), 0.0);
    if (buffers_->radix_four)
        buffers_->radix_four->forward(time, buffers_->half);
    else
        buffers_->any_length->forward(time, buffers_->half);
    return buffers_->half;
}

std::span<const double> Fourier::frame(std::span<const std::complex<double>> spectrum) {
    STRIDOR_EXPECT(spectrum.size() == size() / 2 + 1);
    if (buffers_->radix_four) {
        buffers_->radix_four->backward(spectrum, buffers_->time);
        return buffers_->time;
    }
    buffers_->any_length->backward(spectrum, buffers_->time);
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
