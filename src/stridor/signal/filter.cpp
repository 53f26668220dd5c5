#include "stridor/signal/filter.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/running_biquad.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

// A Butterworth filter of order n has its poles at equal angles on the circle of the corner: sections with quality
// factors 1 / (2 cos φ_k), φ_k = π (2k + 1) / (2n). The bilinear transform s = (1 - z⁻¹) / (1 + z⁻¹) / tan(π f / rate)
// maps each to a biquad and keeps the corner exact.
namespace stridor::signal {

namespace {

enum class Kind { low, high };

std::vector<Biquad> butterworth(Kind kind, double corner, double rate, int order) {
    STRIDOR_EXPECT(order > 0 && order % 2 == 0 && corner > 0.0 && corner < 0.5 * rate);
    const base::SineCosine half = base::sine_cosine_of_turns(0.5 * corner / rate);
    const double K = half.sine / half.cosine;
    std::vector<Biquad> sections;
    for (int k = 0; k < order / 2; ++k) {
        const double inverse_quality = 2.0 * base::sine_cosine_of_turns((2.0 * k + 1.0) / (4.0 * order)).cosine;
        const double scale = 1.0 / (1.0 + K * inverse_quality + K * K);
        const double b0 = kind == Kind::low ? K * K * scale : scale;
        const double b1 = kind == Kind::low ? 2.0 * b0 : -2.0 * b0;
        sections.push_back({b0, b1, b0, 2.0 * (K * K - 1.0) * scale, (1.0 - K * inverse_quality + K * K) * scale});
    }
    return sections;
}

// the modified Bessel function of the first kind and order 0, by its power series, which has no cancellation
double bessel_i0(double x) {
    const double quarter_square = 0.25 * x * x;
    double term = 1.0;
    double sum = 1.0;
    for (int k = 1; term > 1e-17 * sum; ++k) {
        term *= quarter_square / (static_cast<double>(k) * k);
        sum += term;
    }
    return sum;
}

// sin(2 pi f n) / (pi n)
double ideal_tap(double cutoff, double n) {
    return n == 0.0 ? 2.0 * cutoff : base::sine_cosine_of_turns(cutoff * n).sine / (std::numbers::pi * n);
}

constexpr std::size_t samples_per_power = 24;  // [1] 48 kHz to 2 kHz

/// What a band's sections differ by from a1 = -2 and a2 = 1, and the gain: ISO 532-1:2017, table A.2.
struct BandCoefficients {
    std::array<double, 3> a1;
    std::array<double, 3> a2;
    double gain;
};

constexpr std::array<BandCoefficients, third_octave_count> coefficients{{
    {{-6.70260e-4, -3.75071e-4, -3.06523e-4}, {6.59453e-4, 3.61926e-4, 2.97634e-4}, 4.30764e-11},
    {{-8.47258e-4, -4.76448e-4, -3.88773e-4}, {8.30131e-4, 4.55616e-4, 3.74685e-4}, 8.59340e-11},
    {{-1.07210e-3, -6.06567e-4, -4.94004e-4}, {1.04496e-3, 5.73553e-4, 4.71677e-4}, 1.71424e-10},
    {{-1.35836e-3, -7.74327e-4, -6.29154e-4}, {1.31535e-3, 7.22007e-4, 5.93771e-4}, 3.41944e-10},
    {{-1.72380e-3, -9.91780e-4, -8.03529e-4}, {1.65564e-3, 9.08866e-4, 7.47455e-4}, 6.82035e-10},
    {{-2.19188e-3, -1.27545e-3, -1.02976e-3}, {2.08388e-3, 1.14406e-3, 9.40900e-4}, 1.36026e-9},
    {{-2.79386e-3, -1.64828e-3, -1.32520e-3}, {2.62274e-3, 1.44006e-3, 1.18438e-3}, 2.71261e-9},
    {{-3.57182e-3, -2.14252e-3, -1.71397e-3}, {3.30071e-3, 1.81258e-3, 1.49082e-3}, 5.40870e-9},
    {{-4.58305e-3, -2.80413e-3, -2.23006e-3}, {4.15355e-3, 2.28135e-3, 1.87646e-3}, 1.07826e-8},
    {{-5.90655e-3, -3.69947e-3, -2.92205e-3}, {5.22622e-3, 2.87118e-3, 2.36178e-3}, 2.14910e-8},
    {{-7.65243e-3, -4.92540e-3, -3.86007e-3}, {6.57493e-3, 3.61318e-3, 2.97240e-3}, 4.28228e-8},
    {{-1.00023e-2, -6.63788e-3, -5.15982e-3}, {8.29610e-3, 4.55999e-3, 3.75306e-3}, 8.54316e-8},
    {{-1.31230e-2, -9.02274e-3, -6.94543e-3}, {1.04220e-2, 5.73132e-3, 4.71734e-3}, 1.70009e-7},
    {{-1.73693e-2, -1.24176e-2, -9.46002e-3}, {1.30947e-2, 7.20526e-3, 5.93145e-3}, 3.38215e-7},
    {{-2.31934e-2, -1.73009e-2, -1.30358e-2}, {1.64308e-2, 9.04761e-3, 7.44926e-3}, 6.71990e-7},
    {{-3.13292e-2, -2.44342e-2, -1.82108e-2}, {2.06370e-2, 1.13731e-2, 9.36778e-3}, 1.33531e-6},
    {{-4.28261e-2, -3.49619e-2, -2.57855e-2}, {2.59325e-2, 1.43046e-2, 1.17912e-2}, 2.65172e-6},
    {{-5.91733e-2, -5.06072e-2, -3.69401e-2}, {3.25054e-2, 1.79513e-2, 1.48094e-2}, 5.25477e-6},
    {{-8.26348e-2, -7.40348e-2, -5.34977e-2}, {4.05894e-2, 2.24476e-2, 1.85371e-2}, 1.03780e-5},
    {{-1.17018e-1, -1.09516e-1, -7.85097e-2}, {5.08116e-2, 2.81387e-2, 2.32872e-2}, 2.04870e-5},
    {{-1.67714e-1, -1.63378e-1, -1.16419e-1}, {6.37872e-2, 3.53729e-2, 2.93723e-2}, 4.05198e-5},
    {{-2.42528e-1, -2.45161e-1, -1.73972e-1}, {7.98576e-2, 4.43370e-2, 3.70015e-2}, 7.97914e-5},
    {{-3.53142e-1, -3.69163e-1, -2.61399e-1}, {9.96330e-2, 5.53535e-2, 4.65428e-2}, 1.56511e-4},
    {{-5.16316e-1, -5.55473e-1, -3.93998e-1}, {1.24177e-1, 6.89403e-2, 5.86715e-2}, 3.04954e-4},
    {{-7.56635e-1, -8.34281e-1, -5.94547e-1}, {1.55023e-1, 8.58123e-2, 7.43960e-2}, 5.99157e-4},
    {{-1.10165, -1.23939, -8.91666e-1}, {1.91713e-1, 1.05243e-1, 9.40354e-2}, 1.16544e-3},
    {{-1.58477, -1.80505, -1.32500}, {2.39049e-1, 1.28794e-1, 1.21333e-1}, 2.27488e-3},
    {{-2.50630, -2.19464, -1.90231}, {1.42308e-1, 2.76470e-1, 1.47304e-1}, 3.91006e-3},
}};

// 10^((band - 16) / 10) kHz
double centre(std::size_t band) {
    return 1000.0 * base::power_of_2(base::log2_of_ten * (static_cast<double>(band) - 16.0) / 10.0);
}

}  // namespace

std::vector<Biquad> low_pass(double corner, double rate, int order) {
    return butterworth(Kind::low, corner, rate, order);
}

std::vector<Biquad> high_pass(double corner, double rate, int order) {
    return butterworth(Kind::high, corner, rate, order);
}

std::vector<double> filtered(std::span<const double> samples, std::span<const Biquad> sections) {
    std::vector<double> result(samples.begin(), samples.end());
    // each section waits for itself, so two of them take hardly longer than one
    for (std::size_t k = 0; k + 1 < sections.size(); k += 2) {
        RunningBiquad one{sections[k]};
        RunningBiquad other{sections[k + 1]};
        for (double& value : result)
            value = other.next(one.next(value));
    }
    if (sections.size() % 2 == 0) return result;
    RunningBiquad last{sections.back()};
    for (double& value : result)
        value = last.next(value);
    return result;
}

double gain_at(std::span<const Biquad> sections, double frequency, double rate) {
    const base::SineCosine turn = base::sine_cosine_of_turns(frequency / rate);
    const std::complex<double> delay(turn.cosine, -turn.sine);
    double gain = 1.0;
    for (const Biquad& section : sections)
        gain *= std::sqrt(std::norm((section.b0 + delay * (section.b1 + delay * section.b2)) /
                                    (1.0 + delay * (section.a1 + delay * section.a2))));
    return gain;
}

std::vector<double> low_pass_taps(const LowPass& design) {
    STRIDOR_EXPECT(0.0 < design.pass && design.pass < design.stop && design.stop <= 0.5);
    STRIDOR_EXPECT(design.attenuation >= 50.0 && design.attenuation <= 180.0);
    const double transition = design.stop - design.pass;
    const double cutoff = 0.5 * (design.pass + design.stop);
    const auto half = static_cast<std::size_t>(std::ceil(0.5 * (design.attenuation - 7.95) / (14.36 * transition))) + 1;
    const double beta = 0.1102 * (design.attenuation - 8.7);
    const double scale = 1.0 / bessel_i0(beta);

    std::vector<double> taps(2 * half + 1);
    double sum = 0.0;
    for (std::size_t k = 0; k <= half; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(half);
        const double window = scale * bessel_i0(beta * std::sqrt(1.0 - share * share));
        const double tap = window * ideal_tap(cutoff, static_cast<double>(k));
        taps[half + k] = taps[half - k] = tap;
        sum += k == 0 ? tap : 2.0 * tap;
    }
    for (double& tap : taps)
        tap /= sum;
    return taps;
}

ThirdOctaveFilters::ThirdOctaveFilters() {
    for (std::size_t band = 0; band < third_octave_count; ++band) {
        for (std::size_t k = 0; k < sections_.size(); ++k) {
            sections_[k].a1[band] = -2.0 - coefficients[band].a1[k];
            sections_[k].a2[band] = 1.0 - coefficients[band].a2[k];
        }
        const double time_constant = 2.0 / (3.0 * std::min(centre(band), 1000.0));  // [s]
        share_[band] = 1.0 - base::power_of_2(-base::log2_of_e / (third_octave_rate * time_constant));
    }
}

// the numerators are those of table A.1: 1 2 1, 1 0 -1 and 1 -2 1
void ThirdOctaveFilters::filter(double sample) {
    Section& low = sections_[0];
    Section& middle = sections_[1];
    Section& high = sections_[2];
    for (std::size_t k = 0; k < third_octave_count; ++k) {
        const double x = coefficients[k].gain * sample;
        const double y = x + low.first[k];
        low.first[k] = 2.0 * x - low.a1[k] * y + low.second[k];
        low.second[k] = x - low.a2[k] * y;
        output_[k] = y;
    }
    for (std::size_t k = 0; k < third_octave_count; ++k) {
        const double x = output_[k];
        const double y = x + middle.first[k];
        middle.first[k] = middle.second[k] - middle.a1[k] * y;
        middle.second[k] = -x - middle.a2[k] * y;
        output_[k] = y;
    }
    for (std::size_t k = 0; k < third_octave_count; ++k) {
        const double x = output_[k];
        const double y = x + high.first[k];
        high.first[k] = -2.0 * x - high.a1[k] * y + high.second[k];
        high.second[k] = x - high.a2[k] * y;
        output_[k] = y;
    }
}

void ThirdOctaveFilters::smooth() {
    for (std::size_t k = 0; k < third_octave_count; ++k) {
        const double power = output_[k] * output_[k];
        squares_[k] += power;
        smoothed_[0][k] += share_[k] * (power - smoothed_[0][k]);
        smoothed_[1][k] += share_[k] * (smoothed_[0][k] - smoothed_[1][k]);
        smoothed_[2][k] += share_[k] * (smoothed_[1][k] - smoothed_[2][k]);
    }
}

// in silence the states shrink for ever, and a processor takes a hundred times as long for the smallest numbers
void ThirdOctaveFilters::forget() {
    constexpr double nothing = 1e-30;  // [unit] 300 dB below what is heard, behind the smallest gain
    const auto clear = [](ThirdOctaves& values) {
        for (double& value : values)
            value = std::abs(value) < nothing ? 0.0 : value;
    };
    for (Section& section : sections_) {
        clear(section.first);
        clear(section.second);
    }
    for (ThirdOctaves& values : smoothed_)
        clear(values);
}

void ThirdOctaveFilters::push(std::span<const double> samples, const std::function<void(const ThirdOctaves&)>& take) {
    constexpr double greatest = 1e30;  // [unit] beyond every sound; its square and what is made of it are numbers
    for (const double sample : samples) {
        filter(std::clamp(sample, -greatest, greatest));
        smooth();
        if (count_++ % samples_per_power != 0) continue;
        forget();
        take(smoothed_[2]);
    }
}

ThirdOctaves ThirdOctaveFilters::mean_squares() const {
    ThirdOctaves mean{};
    for (std::size_t k = 0; k < third_octave_count && count_ > 0; ++k)
        mean[k] = squares_[k] / static_cast<double>(count_);
    return mean;
}

}  // namespace stridor::signal
