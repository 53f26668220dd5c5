#include "stridor/recordings/time_grid.hpp"

#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace stridor::recordings {

namespace {

// of sound recorders, and of measuring front ends (multiples of 12800 and powers of two)
constexpr std::array usual_rates{8000.0,  11025.0,  12800.0,  16000.0,  16384.0,  22050.0,  25600.0,  32000.0,
                                 32768.0, 40960.0,  44100.0,  48000.0,  51200.0,  65536.0,  81920.0,  88200.0,
                                 96000.0, 102400.0, 131072.0, 176400.0, 192000.0, 204800.0, 262144.0, 384000.0};

bool is_near(double value, double wanted, double tolerance) {
    return std::abs(value - wanted) <= tolerance * wanted;
}

struct Rounded {
    double value = 0.0;
    int digits = 0;
};

// the decimal number of the fewest digits within the tolerance
Rounded fewest_digits(double value, double tolerance) {
    for (int digits = 1; digits < 17; ++digits) {
        std::array<char, 40> text{};
        const auto written =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
        double rounded = value;
        std::from_chars(text.data(), written.ptr, rounded);
        if (is_near(rounded, value, tolerance)) return {rounded, digits};
    }
    return {value, 17};
}

double exact_rate(double step, double tolerance) {
    const double rate = 1.0 / step;
    const auto usual = std::min_element(usual_rates.begin(), usual_rates.end(),
                                        [&](double a, double b) { return std::abs(a - rate) < std::abs(b - rate); });
    if (is_near(*usual, rate, tolerance)) return *usual;
    const Rounded by_rate = fewest_digits(rate, tolerance);
    const Rounded by_step = fewest_digits(step, tolerance);
    return by_step.digits < by_rate.digits ? 1.0 / by_step.value : by_rate.value;
}

}  // namespace

SnappedRate snapped_rate(double step, double tolerance) {
    const double rate = exact_rate(step, tolerance);
    if (is_near(rate * step, 1.0, 1e-9)) return {rate};
    return {rate, "the step " + base::shortest(step) + " s was taken for " + base::shortest(rate) + " Hz"};
}

double step_tolerance(std::string_view numeral) {
    int digits = 0;  // from the first one that is not zero
    for (const char c : numeral) {
        if (c == 'e' || c == 'E' || c == 'd' || c == 'D') break;
        const bool counts = c >= '0' && c <= '9' && (digits > 0 || c != '0');
        digits += counts ? 1 : 0;
    }
    double unit = 1.0;
    for (int digit = 1; digit < digits; ++digit)
        unit /= 10.0;
    return std::clamp(unit, 1e-9, 5e-6);
}

}  // namespace stridor::recordings

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
