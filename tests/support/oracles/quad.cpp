// The first root of a polynomial p on [0, end], with certainty. Around the middle of a stretch of half-width r the
// polynomial is q(s) = p(middle + s), |s| <= r, and
//
//     |q₀| > Σ_{k≥1} |qₖ| rᵏ          proves that it has no root there,
//     |q₁| > Σ_{k≥2} k |qₖ| rᵏ⁻¹      proves that it is monotone there: one root if the ends differ in sign, else none.
//
// Where neither holds the stretch is halved, the earlier half first. Wide stretches are tested in double precision,
// both inequalities tightened by more than the rounding errors; only where that does not decide are 33 digits used. The
// one root of a monotone stretch is polished by Newton's iteration, kept inside its bracket by bisection.

#include "support/oracles/quad.hpp"

#include <cmath>
#include <stdexcept>

namespace stridor::support {

namespace {

template <typename Real>
Real size_of(Real x) {
    return x < 0 ? -x : x;
}

// the coefficients of p(by + s)
template <typename Real>
Series<Real> shifted(Series<Real> p, Real by) {
    for (std::size_t i = 0; i < series_order; ++i)
        for (std::size_t k = series_order; k-- > i;)
            p[k] += by * p[k + 1];
    return p;
}

Quad polished_root(const Series<Quad>& p, Quad low, Quad high) {
    Series<Quad> slope{};
    for (std::size_t k = 0; k < series_order; ++k)
        slope[k] = Quad(static_cast<double>(k + 1)) * p[k + 1];
    Quad x = (low + high) / 2;
    // bisection alone would need some 110 halvings
    for (int n = 0; n < 200; ++n) {
        const Quad y = value(p, x);
        (y > 0 ? low : high) = x;
        Quad next = x - y / value(slope, x);
        if (!(next > low && next < high)) next = (low + high) / 2;
        const Quad step = magnitude(next - x);
        x = next;
        if (step < Quad(1e-32)) break;
    }
    return x;
}

constexpr int double_depth = 24;        // halvings after which double precision gives way to quad
constexpr int last_depth = 80;          // halvings after which a stretch counts as a touch
constexpr int most_stretches = 100000;  // a series that is nothing but rounding errors would need 2^80

// of [0, 1]
struct Stretch {
    Quad low, high;
    int depth;
};

// p not negative at the stretch's low end; `rounding` is more than the error of any sum below
template <typename Real>
std::optional<Quad> first_fall_in(const Series<Quad>& p, const Series<Real>& rounded, Real rounding, Stretch in,
                                  int& stretches) {
    if (++stretches > most_stretches) throw std::runtime_error("an event function is zero but for rounding");
    const Quad middle = (in.low + in.high) / 2;
    const Real r = static_cast<Real>((in.high - in.low) / 2);
    const Series<Real> q = shifted(rounded, static_cast<Real>(middle));
    Real terms = 0, slopes = 0;
    for (std::size_t k = series_order; k >= 1; --k) {
        const Real factor = static_cast<Real>(static_cast<double>(k));
        terms = (terms + size_of(q[k])) * r;
        if (k >= 2) slopes = (slopes + factor * size_of(q[k])) * r;
    }
    if (size_of(q[0]) > terms + rounding) return {};
    if (size_of(q[1]) > slopes + rounding) {
        // a zero at the very end is found in the next stretch, if it is a fall
        if (q[1] > 0 || value(p, in.high) >= 0) return {};
        return polished_root(p, in.low, in.high);
    }
    if (in.depth >= last_depth) return {};
    if constexpr (sizeof(Real) < sizeof(Quad)) {
        if (in.depth >= double_depth) return first_fall_in<Quad>(p, p, Quad(0), in, stretches);
    }
    if (const auto early = first_fall_in(p, rounded, rounding, {in.low, middle, in.depth + 1}, stretches)) return early;
    return first_fall_in(p, rounded, rounding, {middle, in.high, in.depth + 1}, stretches);
}

}  // namespace

SineCosine sine_cosine(Quad angle) {
    // both series of a 64th of the angle, then the angle doubled six times
    const Quad x = angle / 64;
    Quad sine = 0, cosine = 0, term = 1;
    for (int k = 0; k < 40; ++k) {
        const Quad signed_term = (k / 2) % 2 == 0 ? term : -term;
        (k % 2 == 0 ? cosine : sine) += signed_term;
        term *= x / (k + 1);
    }
    for (int n = 0; n < 6; ++n) {
        const Quad doubled = 2 * sine * cosine;
        cosine = (cosine - sine) * (cosine + sine);
        sine = doubled;
    }
    return {sine, cosine};
}

Series<Quad> without_root_at_zero(const Series<Quad>& p, std::size_t power) {
    Series<Quad> quotient{};
    for (std::size_t k = 0; k + power <= series_order; ++k)
        quotient[k] = p[k + power];
    return quotient;
}

std::optional<Quad> first_fall(const Series<Quad>& p, Quad end) {
    Series<double> rounded{};
    double size = 0.0;  // Σ k |pₖ| 2ᵏ bounds every partial sum of a shift by at most 1, and those of the slope
    for (std::size_t k = 0; k <= series_order; ++k) {
        rounded[k] = static_cast<double>(p[k]);
        size += static_cast<double>(k + 1) * std::abs(std::ldexp(rounded[k], static_cast<int>(k)));
    }
    if (size == 0.0) return {};
    int stretches = 0;
    // each coefficient of a shift takes at most 2 * 28 roundings of 1.1e-16
    return first_fall_in<double>(p, rounded, 1e-13 * size, {Quad(0), end, 0}, stretches);
}

}  // namespace stridor::support
