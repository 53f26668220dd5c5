#include "stridor/recordings/rate.hpp"

#include "stridor/base/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

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
    const auto* const usual = std::min_element(usual_rates.begin(), usual_rates.end(), [&](double a, double b) {
        return std::abs(a - rate) < std::abs(b - rate);
    });
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
