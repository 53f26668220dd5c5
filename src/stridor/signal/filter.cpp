// A Butterworth filter of order n has its poles at equal angles on the circle of the corner: sections with quality
// factors 1 / (2 cos φ_k), φ_k = π (2k + 1) / (2n). The bilinear transform s = (1 - z⁻¹) / (1 + z⁻¹) / tan(π f / rate)
// maps each to a biquad and keeps the corner exact.
#include "stridor/signal/filter.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"

#include <cmath>
#include <complex>

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

}  // namespace

std::vector<Biquad> low_pass(double corner, double rate, int order) {
    return butterworth(Kind::low, corner, rate, order);
}

std::vector<Biquad> high_pass(double corner, double rate, int order) {
    return butterworth(Kind::high, corner, rate, order);
}

namespace {

// one section at work
struct RunningBiquad {
    Biquad biquad;
    double first = 0.0;
    double second = 0.0;

    double next(double x) {
        const double y = biquad.b0 * x + first;
        first = biquad.b1 * x - biquad.a1 * y + second;
        second = biquad.b2 * x - biquad.a2 * y;
        return y;
    }
};

}  // namespace

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
        gain *= std::abs((section.b0 + delay * (section.b1 + delay * section.b2)) /
                         (1.0 + delay * (section.a1 + delay * section.a2)));
    return gain;
}

}  // namespace stridor::signal
