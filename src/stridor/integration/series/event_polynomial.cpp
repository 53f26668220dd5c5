// On an interval a polynomial lies between the smallest and the largest of its Bernstein coefficients, and has no more
// zeros than they have changes of sign. An interval with none is passed, with one it holds one zero, which Newton's
// steps find between bounds; with more it is halved (de Casteljau).

#include "stridor/integration/series/event_polynomial.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::integration {

namespace {

constexpr int most_coefficients = 32;
constexpr double narrowest_part = 0x1p-44;  // [1] below it an interval holds dips no deeper than rounding
constexpr std::size_t most_parts = 48;      // waiting: one of each width, and the narrowest's neighbour
constexpr double zero_rounding = 0x1p-52;   // [1] of a zero: a neighbouring number
constexpr double least_rounding = 1e-17;    // [1] of a block: what matters of a zero near its beginning
constexpr int most_halvings = 8192;         // before a function that is all rounding is given up

using BernsteinForm = std::array<double, most_coefficients>;

struct IntervalPart {
    double from, to;
    BernsteinForm b;
};

// b_j = Σ_{i <= j} C(j, i) / C(n, i) c_i, as differences are summed
BernsteinForm bernstein_form(std::span<const double> c) {
    const int n = static_cast<int>(c.size()) - 1;
    BernsteinForm b{};
    double binomial = 1.0;  // C(n, i)
    for (int i = 0; i <= n; ++i) {
        b[static_cast<std::size_t>(i)] = c[static_cast<std::size_t>(i)] / binomial;
        binomial *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    }
    for (int pass = 1; pass <= n; ++pass)
        for (int j = n; j >= pass; --j)
            b[static_cast<std::size_t>(j)] += b[static_cast<std::size_t>(j - 1)];
    return b;
}

void halve_part(const IntervalPart& whole, int n, IntervalPart& left, IntervalPart& right) {
    BernsteinForm b = whole.b;
    const double middle = 0.5 * (whole.from + whole.to);
    left.from = whole.from;
    left.to = right.from = middle;
    right.to = whole.to;
    for (int j = 0; j <= n; ++j) {
        left.b[static_cast<std::size_t>(j)] = b[0];
        right.b[static_cast<std::size_t>(n - j)] = b[static_cast<std::size_t>(n - j)];
        for (int k = 0; k < n - j; ++k)
            b[static_cast<std::size_t>(k)] =
                0.5 * (b[static_cast<std::size_t>(k)] + b[static_cast<std::size_t>(k + 1)]);
    }
}

// certainly positive on [0, 1]? by the first coefficients, less what the others can take
bool is_positive(std::span<const double> c) {
    constexpr std::size_t first = 9;
    if (c.size() <= first) return false;
    double others = 0.0;
    for (const double each : c.subspan(first))
        others += each < 0.0 ? each : 0.0;
    const BernsteinForm b = bernstein_form(c.first(first));
    return *std::min_element(b.begin(), b.begin() + first) + others > 0.0;
}

int sign_changes(const BernsteinForm& b, int n) {
    int changes = 0;
    for (int j = 1; j <= n; ++j)
        if ((b[static_cast<std::size_t>(j)] > 0.0) != (b[static_cast<std::size_t>(j - 1)] > 0.0)) ++changes;
    return changes;
}

struct ValueAndSlope {
    double value, slope;
};

// By even and odd powers, c(x) = E(x²) + x O(x²): four sums side by side, which do not wait for each other.
ValueAndSlope value_and_slope(std::span<const double> c, double x) {
    const double y = x * x;
    double even = 0.0, odd = 0.0, even_slope = 0.0, odd_slope = 0.0;
    std::size_t k = c.size();
    if (k % 2 == 1) even = c[--k];
    while (k > 0) {
        odd_slope = odd_slope * y + odd;
        odd = odd * y + c[--k];
        even_slope = even_slope * y + even;
        even = even * y + c[--k];
    }
    return {even + x * odd, 2.0 * x * even_slope + odd + 2.0 * y * odd_slope};
}

// the zero between an end where the polynomial is `first`, above zero, and one where it is `last`, below
double polished(std::span<const double> c, double from, double to, double first, double last) {
    double x = from + (to - from) * (first / (first - last));
    for (int step = 0; step < 80; ++step) {
        const auto [value, slope] = value_and_slope(c, x);
        if (value > 0.0)
            from = x;
        else
            to = x;
        double next = x - value / slope;
        if (!(next > from && next < to)) next = 0.5 * (from + to);
        if (std::abs(next - x) <= std::max(least_rounding, zero_rounding * x) || from == to) return next;
        x = next;
    }
    return x;
}

}  // namespace

double value_of(std::span<const double> c, double x) {
    double value = 0.0;
    for (std::size_t k = c.size(); k-- > 0;)
        value = value * x + c[k];
    return value;
}

double first_zero(std::span<const double> whole, int dropped, double reach) {
    const std::span<const double> c = whole.subspan(static_cast<std::size_t>(dropped));
    // all coefficients, and those below zero: sums side by side, which do not wait for each other
    constexpr std::size_t side_by_side = 4;
    std::array<double, side_by_side> sum{}, below{};
    std::size_t k = 1;
    for (; k + side_by_side <= c.size(); k += side_by_side)
        for (std::size_t i = 0; i < side_by_side; ++i) {
            sum[i] += c[k + i];
            below[i] += c[k + i] < 0.0 ? c[k + i] : 0.0;  // without a branch: signs follow no rule
        }
    for (; k < c.size(); ++k) {
        sum[0] += c[k];
        below[0] += c[k] < 0.0 ? c[k] : 0.0;
    }
    if (!std::isfinite(c[0] + ((sum[0] + sum[1]) + (sum[2] + sum[3])))) return no_polynomial;
    if (c[0] < 0.0) return 0.0;
    const double least = c[0] + ((below[0] + below[1]) + (below[2] + below[3]));
    if (least > 0.0 || is_positive(c)) return no_zero;
    const int n = static_cast<int>(c.size()) - 1;
    std::array<IntervalPart, most_parts> stack;
    std::size_t parts = 1;
    stack[0] = {0.0, 1.0, bernstein_form(c)};
    for (int looked_at = 0; parts > 0 && looked_at < most_halvings; ++looked_at) {
        const IntervalPart here = stack[--parts];
        if (here.from >= reach) break;
        const int changes = sign_changes(here.b, n);
        if (changes == 0 && here.b[0] > 0.0) continue;
        const double first = here.b[0];
        const double last = here.b[static_cast<std::size_t>(n)];
        if (changes <= 1 && first > 0.0 && last <= 0.0) {
            const double zero = polished(c, here.from, here.to, first, last);
            return zero <= reach ? zero : no_zero;
        }
        if (changes <= 1 && !(first > 0.0)) {
            if (here.from > 0.0) return here.from;  // the zero lies where two parts meet
            if (last > 0.0 || changes == 0) {       // it begins at zero: its next coefficient says which way
                for (const double each : c)
                    if (each != 0.0) {
                        if (each < 0.0) return 0.0;
                        break;
                    }
                continue;
            }
        }
        if (here.to - here.from < narrowest_part) {
            if (last <= 0.0) return here.to <= reach ? here.to : no_zero;
            continue;
        }
        // the left one is looked at first
        halve_part(here, n, stack[parts + 1], stack[parts]);
        parts += 2;
    }
    return no_zero;
}

double late_zero(std::span<const double> c, double zero, double reach) {
    for (std::size_t k = 0; k < c.size(); ++k) {
        if (!std::isfinite(c[k])) return no_polynomial;
        if (!(std::abs(c[k]) > zero)) continue;
        if (c[k] > 0.0) return first_zero(c, static_cast<int>(k), reach);
        const auto term = [&](double place) {
            double value = -c[k];
            for (std::size_t j = 0; j < k; ++j)
                value *= place;
            return value;
        };
        if (!(term(reach) > zero)) return no_zero;
        // halves are the same on every machine, and near enough
        double place = reach;
        while (place > 0.0 && term(place) > zero)
            place = k == 0 ? 0.0 : 0.5 * place;
        return place;
    }
    return no_zero;
}

}  // namespace stridor::integration
