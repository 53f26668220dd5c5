#pragma once

#include <array>
#include <cstddef>
#include <optional>

/// Numbers of some 33 digits, and polynomials of them, for references that double precision is held against.
namespace stridor::support {

#ifdef __SIZEOF_FLOAT128__
__extension__ using Quad = __float128;
#else
using Quad = long double;  // 33 digits on 64-bit ARM
#endif

/// pi to the digits of a Quad: the sum of three doubles.
constexpr Quad quad_pi() {
    return Quad(3.14159265358979311600) + Quad(1.22464679914735320717e-16) + Quad(-2.99476980971833966e-33);
}

inline Quad magnitude(Quad x) {
    return x < 0 ? -x : x;
}

/// Sine and cosine of an angle [rad] of some turns at most.
struct SineCosine {
    Quad sine;
    Quad cosine;
};
SineCosine sine_cosine(Quad angle);

inline constexpr std::size_t series_order = 28;

/// c[0] + c[1] x + ... + c[28] x^28, by its coefficients.
template <typename Real>
using Series = std::array<Real, series_order + 1>;

/// The value of a series at x.
template <typename Real>
Real value(const Series<Real>& p, Real x) {
    Real sum = p[series_order];
    for (std::size_t k = series_order; k-- > 0;)
        sum = sum * x + p[k];
    return sum;
}

/// The series divided by x^power, its lowest coefficients dropped: they are zero but for rounding.
Series<Quad> without_root_at_zero(const Series<Quad>& p, std::size_t power);

/// The first x in (0, end], end at most 1, at which a series that is positive at 0 falls through zero;
/// empty if it does not.
///
/// No root is missed: a stretch is left out only where bounds on all terms prove that the series keeps its sign there
/// or is monotone. Two roots closer than 2^-80 are taken for a touch, which is no fall. A series of zeros does not
/// fall; one of rounding errors throws std::runtime_error.
std::optional<Quad> first_fall(const Series<Quad>& p, Quad end);

}  // namespace stridor::support
