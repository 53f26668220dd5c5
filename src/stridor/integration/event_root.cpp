// Bernstein's polynomials are positive and add up to 1: a polynomial lies between its smallest and largest coefficient, has
// no more roots than its coefficients have changes of sign, and rises where they rise. So an interval either has no root, or one,
// or is halved (de Casteljau). The form of degree 7 misses the series by 1e-9 of the vibration: whatever it says about a
// sign is confirmed on the series itself.

#include "stridor/integration/event_root.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr int degree = 7;
// below this width an interval holds dips no deeper than rounding
constexpr double narrowest = 0x1p-27;
// what the form of degree 7 may miss, as a share of its largest coefficient: 1e-9 of the vibration, of which an event function
// may show a small part (2e-8 of itself has been seen)
constexpr double missed = 1e-6;

// a series and its derivative, summed in four interleaved chains
class Quotient {
public:
    Quotient(const Lanes (&series)[term_blocks], int multiplicity) {
        for (int k = multiplicity; k < terms; ++k) {
            const double c = series[k / lanes].at[k % lanes];
            c_[k - multiplicity] = c;
            if (k > multiplicity) d_[k - multiplicity - 1] = c * (k - multiplicity);
        }
    }

    double value(double x) const { return sum(c_, x); }
    double slope(double x) const { return sum(d_, x); }

    // sign just after 0: that of the first coefficient that is not zero
    double first() const {
        for (const double c : c_)
            if (c != 0.0) return c;
        return 0.0;
    }

private:
    static double sum(const double (&a)[terms], double x) {
        const double x2 = x * x;
        const double x4 = x2 * x2;
        double p[4] = {a[terms - 4], a[terms - 3], a[terms - 2], a[terms - 1]};
        for (int k = terms - 8; k >= 0; k -= 4)
            for (int i = 0; i < 4; ++i)
                p[i] = p[i] * x4 + a[k + i];
        return (p[0] + p[1] * x) + (p[2] + p[3] * x) * x2;
    }

    double c_[terms]{};
    double d_[terms]{};
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

// the root between a positive and a non-positive value: Newton's steps, halved where they leave the bracket
double polish(const Quotient& q, double from, double to) {
    double x = 0.5 * (from + to);
    for (int k = 0; k < 80; ++k) {
        const double value = q.value(x);
        (value > 0.0 ? from : to) = x;
        double next = x - value / q.slope(x);
        if (!(next > from && next < to)) next = 0.5 * (from + to);
        const double change = std::abs(next - x);
        x = next;
        if (change <= 0x1p-53 * x || change < 0x1p-70) break;
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
            if (q.value(here.to) <= 0.0) return polish(q, here.from, here.to);
            continue;
        }
        halve(here, stack[depth + 1], stack[depth]);
        depth += 2;
    }
    return no_crossing;
}

}  // namespace stridor::integration
