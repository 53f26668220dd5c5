// Bernstein's polynomials are positive and add up to 1: a polynomial lies between its smallest and largest coefficient,
// has no more roots than its coefficients have changes of sign, and rises where they rise. So an interval either has no
// root, or one, or is halved (de Casteljau). The form of degree 7 misses the series by 2e-7 of its amplitude: whatever
// it says about a sign is confirmed on the series itself.

#include "stridor/integration/exact/event_root.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr int degree = 7;
// below this width an interval holds dips no deeper than rounding
constexpr double narrowest = 0x1p-27;
// what the form of degree 7 may miss, as a share of its largest coefficient: 2e-7 of the vibration, of which an event
// function may show a small part (a twentieth has been seen)
constexpr double missed = 1e-4;
// so many intervals are looked at before a search is given up: 56 have been seen in 13 million searches, while a
// function whose coefficients are all rounding would be halved into 2^27. Ten milliseconds at most.
constexpr int most_intervals = 4096;

struct Interval {
    double from, to;
    Lanes b;
};

enum class Shape { positive, rising, falling, unknown };

Shape shape_of(const Lanes& b, double slack) {
    double least = b.at[0];
    bool rises = true, falls = true;
    int changes = 0;
    for (int j = 1; j <= degree; ++j) {
        least = std::min(least, b.at[j]);
        rises = rises && b.at[j] >= b.at[j - 1];
        falls = falls && b.at[j] <= b.at[j - 1];
        if ((b.at[j] > 0.0) != (b.at[j - 1] > 0.0)) ++changes;
    }
    if (least > slack) return Shape::positive;
    if (rises) return Shape::rising;
    // one change of sign from clearly positive to clearly negative is one root as well
    const bool falls_through = changes == 1 && b.at[0] > slack && b.at[degree] < -slack;
    return falls || falls_through ? Shape::falling : Shape::unknown;
}

void halve(const Interval& whole, Interval& left, Interval& right) {
    Lanes b = whole.b;
    const double middle = 0.5 * (whole.from + whole.to);
    left = {whole.from, middle, {}};
    right = {middle, whole.to, {}};
    for (int j = 0; j <= degree; ++j) {
        left.b.at[j] = b.at[0];
        right.b.at[degree - j] = b.at[degree - j];
        for (int k = 0; k < degree - j; ++k)
            b.at[k] = 0.5 * (b.at[k] + b.at[k + 1]);
    }
}

// where the polygon of the coefficients crosses zero: within a few per cent of the interval of the root
double first_guess(const Interval& interval) {
    int j = 0;
    while (j < degree - 1 && interval.b.at[j + 1] > 0.0)
        ++j;
    const double drop = interval.b.at[j] - interval.b.at[j + 1];
    const double share = drop > 0.0 ? std::clamp(interval.b.at[j] / drop, 0.0, 1.0) : 0.5;
    return interval.from + (interval.to - interval.from) * (j + share) / degree;
}

// sign of the quotient just after 0: that of the first coefficient that is not zero
double first_coefficient(const Lanes (&series)[term_blocks], int multiplicity) {
    for (int k = multiplicity; k < terms; ++k)
        if (const double c = series[k / lanes].at[k % lanes]; c != 0.0) return c;
    return 0.0;
}

}  // namespace

double first_crossing(const Lanes (&series)[term_blocks], int multiplicity, const Lanes& bernstein,
                      const Kernel& loops) {
    const double start = first_coefficient(series, multiplicity);
    if (start < 0.0) return 0.0;
    if (start == 0.0) return no_crossing;

    double amplitude = 0.0, sum = start;
    for (const double b : bernstein.at) {
        amplitude = std::max(amplitude, std::abs(b));
        sum += b;
    }
    if (!std::isfinite(sum)) return no_number;
    const double slack = missed * amplitude;

    constexpr int deepest = 64;
    Interval stack[deepest];
    int depth = 0;
    stack[depth++] = {0.0, 1.0, bernstein};
    for (int looked_at = 0; depth > 0; ++looked_at) {
        if (looked_at == most_intervals) return endless_search;
        const Interval here = stack[--depth];
        const Shape shape = shape_of(here.b, slack);
        if (shape == Shape::positive || shape == Shape::rising) continue;
        const bool is_last = here.to - here.from <= narrowest || depth + 2 > deepest;
        if (shape == Shape::falling || is_last) {
            const double root = loops.root(series, multiplicity, here.from, here.to, first_guess(here),
                                           here.b.at[degree] < -slack ? Falling::surely : Falling::perhaps);
            if (root <= 1.0) return root;
            continue;
        }
        halve(here, stack[depth + 1], stack[depth]);
        depth += 2;
    }
    return no_crossing;
}

}  // namespace stridor::integration
