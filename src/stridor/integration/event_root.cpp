// Bernstein's polynomials are positive and add up to 1: a polynomial lies between its smallest and largest coefficient, has
// no more roots than its coefficients have changes of sign, and rises where they rise. So an interval either has no root, or one,
// or is halved (de Casteljau). The form of degree 7 misses the series by 2e-7 of its amplitude: whatever it says about a
// sign is confirmed on the series itself.

#include "stridor/integration/event_root.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr int degree = 7;
// below this width an interval holds dips no deeper than rounding
constexpr double narrowest = 0x1p-27;
// what the form of degree 7 may miss, as a share of its largest coefficient
constexpr double missed = 1e-6;

// the series without its known root, and its slope; four interleaved chains each
class Quotient {
public:
    Quotient(const Lanes (&series)[term_blocks], int multiplicity) {
        for (int k = 0; k < terms; ++k)
            c_[k] = series[k / lanes].at[k % lanes];
        a_ = c_ + multiplicity;
    }

    double value(double x) const {
        const double x2 = x * x;
        const double x4 = x2 * x2;
        double p[4] = {a_[terms - 4], a_[terms - 3], a_[terms - 2], a_[terms - 1]};
        for (int k = terms - 8; k >= 0; k -= 4)
            for (int i = 0; i < 4; ++i)
                p[i] = p[i] * x4 + a_[k + i];
        return (p[0] + p[1] * x) + (p[2] + p[3] * x) * x2;
    }

    // to 1e-4, which is enough for Newton's steps
    double slope(double x) const {
        const double x2 = x * x;
        const double x4 = x2 * x2;
        double p[4];
        for (int i = 0; i < 4; ++i)
            p[i] = ((9 + i) * a_[9 + i] * x4 + (5 + i) * a_[5 + i]) * x4 + (1 + i) * a_[1 + i];
        return (p[0] + p[1] * x) + (p[2] + p[3] * x) * x2;
    }

    // sign just after 0: that of the first coefficient that is not zero
    double first() const {
        for (int k = 0; k < terms; ++k)
            if (a_[k] != 0.0) return a_[k];
        return 0.0;
    }

private:
    double c_[terms + most_multiplicity]{};
    const double* a_;
};

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

// the root between a positive and a non-positive value: Newton's steps, halved where they leave the bracket
double polish(const Quotient& q, const Interval& interval) {
    // a step this small leaves an error of its square
    constexpr double close = 1e-9;
    double from = interval.from, to = interval.to;
    double x = first_guess(interval);
    for (int k = 0; k < 80; ++k) {
        const double value = q.value(x);
        (value > 0.0 ? from : to) = x;
        double next = x - value / q.slope(x);
        if (!(next >= from && next <= to)) next = 0.5 * (from + to);
        const double change = std::abs(next - x);
        x = next;
        if (change <= close * x || change < 0x1p-70) break;
    }
    return x;
}

}  // namespace

double first_crossing(const Lanes (&series)[term_blocks], int multiplicity, const Lanes& bernstein) {
    const Quotient q(series, multiplicity);
    const double start = q.first();
    if (start < 0.0) return 0.0;
    if (start == 0.0) return no_crossing;

    double amplitude = 0.0;
    for (const double b : bernstein.at)
        amplitude = std::max(amplitude, std::abs(b));
    const double slack = missed * amplitude;

    constexpr int deepest = 64;
    Interval stack[deepest];
    int depth = 0;
    stack[depth++] = {0.0, 1.0, bernstein};
    while (depth > 0) {
        const Interval here = stack[--depth];
        const Shape shape = shape_of(here.b, slack);
        if (shape == Shape::positive || shape == Shape::rising) continue;
        const bool is_last = here.to - here.from <= narrowest || depth + 2 > deepest;
        if (shape == Shape::falling || is_last) {
            if (q.value(here.to) <= 0.0) return polish(q, here);
            continue;
        }
        halve(here, stack[depth + 1], stack[depth]);
        depth += 2;
    }
    return no_crossing;
}

}  // namespace stridor::integration
