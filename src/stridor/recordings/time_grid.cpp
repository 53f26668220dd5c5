#include "stridor/recordings/time_grid.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>

namespace stridor::recordings::time_grid {

Precision precision_of(std::string_view numeral) {
    const std::size_t mark = numeral.find_first_of("eE");
    const std::string_view mantissa = numeral.substr(0, mark);
    Precision precision{0, 0};
    bool is_behind_point = false;
    for (const char c : mantissa) {
        const bool is_digit = c >= '0' && c <= '9';
        precision.decimals += is_digit && is_behind_point ? 1 : 0;
        precision.digits += is_digit && (precision.digits > 0 || c != '0') ? 1 : 0;
        is_behind_point = is_behind_point || c == '.';
    }
    int exponent = 0;
    if (mark != std::string_view::npos) {
        std::string_view power = numeral.substr(mark + 1);
        if (power.starts_with('+')) power.remove_prefix(1);
        std::from_chars(power.data(), power.data() + power.size(), exponent);
    }
    precision.decimals = std::clamp(precision.decimals - std::clamp(exponent, -400, 400), -400, 400);
    return precision;
}

Precision finer(Precision a, Precision b) {
    return {std::max(a.decimals, b.decimals), std::max(a.digits, b.digits)};
}

double resolution(Precision precision, double time) {
    const double by_decimals = std::pow(10.0, -precision.decimals);
    const double exponent = time == 0.0 ? -400.0 : std::floor(std::log10(std::abs(time)));
    const double by_digits = std::pow(10.0, exponent + 1.0 - std::min(precision.digits, 16));
    return std::max(by_decimals, by_digits);
}

SnappedRate rate_of(const Times& times) {
    const double begin = times.first.front();
    const double span = times.first.back() - begin;
    const double begin_error = resolution(times.precision, begin);
    double step = span / static_cast<double>(times.first.size() - 1);
    double tolerance = (begin_error + resolution(times.precision, times.first.back())) / span;

    // over the whole table the same error counts for less, if it is clear how many steps it has
    const double whole = times.last - begin;
    const double steps = std::round(whole / step);
    const bool is_clear = steps > 0.0 && steps < 1e15 && steps * tolerance < 0.25;
    if (is_clear) {
        const double whole_tolerance = (begin_error + resolution(times.precision, times.last)) / whole;
        const double refined = whole / steps;
        const bool agrees = std::abs(refined / step - 1.0) <= tolerance + whole_tolerance + 1e-9;
        if (agrees && whole_tolerance <= tolerance) {
            step = refined;
            tolerance = whole_tolerance;
        }
    }
    return snapped_rate(step * times.unit, std::clamp(tolerance, 1e-12, 0.01));
}

std::optional<double> missed(const Times& times, double rate, std::uint64_t row, double time) {
    const double step = 1.0 / (rate * times.unit);  // in the unit of the file
    const double expected = times.first.front() + static_cast<double>(row) * step;
    const double off = std::abs(time - expected);
    if (off <= 0.05 * step) return std::nullopt;
    // printed to its last digit, a time is off by less than one unit of it against a line through two others
    if (off <= 0.05 * step + resolution(times.precision, time)) return std::nullopt;
    return expected;
}

}  // namespace stridor::recordings::time_grid
