#include "stridor/signal/bands.hpp"

#include "stridor/base/elementary.hpp"

#include <array>
#include <cmath>

namespace stridor::signal {

namespace {

constexpr double log2_of_ten = 3.321928094887362;
constexpr std::array<double, 10> nominal_of_decade{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
constexpr int first_third = 11;  // 12.5 Hz = 10^(11/10)
constexpr int last_third = 50;   // 100 kHz

// 10^(tenths / 10)
double power_of_ten(double tenths) {
    return base::power_of_2(log2_of_ten * tenths / 10.0);
}

double nominal(int third) {
    double decade = 1.0;
    for (int k = 0; k < third / 10; ++k)
        decade *= 10.0;
    return decade * nominal_of_decade[static_cast<std::size_t>(third % 10)];
}

}  // namespace

std::vector<Band> bands(const Spectrum& spectrum, BandWidth width) {
    const bool is_octave = width == BandWidth::octave;
    const double half = is_octave ? 1.5 : 0.5;  // [1/10 decade]
    const double limit = static_cast<double>(spectrum.density.size() - 1) * spectrum.spacing;
    std::vector<Band> result;
    // octaves stand at every third third: 16 Hz (12), 31.5 Hz (15), ..., 1 kHz (30)
    for (int third = is_octave ? 12 : first_third; third <= last_third; third += is_octave ? 3 : 1) {
        Band band{nominal(third), power_of_ten(third - half), power_of_ten(third + half), 0.0};
        if (band.high > limit * (1.0 + 1e-9)) break;
        if (band.high - band.low < 4.0 * spectrum.spacing) continue;
        band.mean_square = mean_square_between(spectrum, band.low, band.high);
        result.push_back(band);
    }
    return result;
}

double a_weighting(double frequency) {
    const auto response = [](double f) {
        constexpr double f1 = 20.598997;
        constexpr double f2 = 107.65265;
        constexpr double f3 = 737.86223;
        constexpr double f4 = 12194.217;
        const double s = f * f;
        return f4 * f4 * s * s / ((s + f1 * f1) * std::sqrt((s + f2 * f2) * (s + f3 * f3)) * (s + f4 * f4));
    };
    const double ratio = response(frequency) / response(1000.0);
    return ratio * ratio;
}

Spectrum a_weighted(Spectrum spectrum) {
    for (std::size_t k = 0; k < spectrum.density.size(); ++k)
        spectrum.density[k] *= a_weighting(static_cast<double>(k) * spectrum.spacing);
    return spectrum;
}

}  // namespace stridor::signal
