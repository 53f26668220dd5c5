#include "stridor/signal/spectrum.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/clones.hpp"
#include "stridor/base/decibels.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/signal/median.hpp"
#include "stridor/signal/powers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::signal {

namespace {

constexpr std::array<double, 10> nominal_of_decade{1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0};
constexpr int first_third = 11;  // 12.5 Hz = 10^(11/10)
constexpr int last_third = 50;   // 100 kHz

// 10^(tenths / 10)
double power_of_ten(double tenths) {
    return base::power_of_2(base::log2_of_ten * tenths / 10.0);
}

double nominal(int third) {
    double decade = 1.0;
    for (int k = 0; k < third / 10; ++k)
        decade *= 10.0;
    return decade * nominal_of_decade[static_cast<std::size_t>(third % 10)];
}

// one-sided densities of powers: the first and the last line have one side
STRIDOR_CLONES void make_densities(std::span<double> powers, double scale) {
    const double first = powers.front() / scale;
    const double last = powers.back() / scale;
    for (double& value : powers)
        value = 2.0 * value / scale;
    powers.front() = first;
    powers.back() = last;
}

}  // namespace

Welch::Welch(double rate, WelchOptions options, Listener listener)
    : rate_(rate),
      options_(options),
      listener_(std::move(listener)),
      fourier_(options.size),
      window_(window(options.window, options.size)),
      squares_(std::inner_product(window_.begin(), window_.end(), window_.begin(), 0.0)),
      windowed_(options.size),
      density_(options.size / 2 + 1),
      sum_(options.size / 2 + 1) {
    STRIDOR_EXPECT(rate > 0.0);
}

void Welch::push(std::span<const double> samples) {
    const auto take_from = [this](std::span<const double> here, std::size_t begins) {
        std::size_t first = 0;
        for (; first < begins && first + options_.size <= here.size(); first += hop())
            take(here.subspan(first, options_.size), squares_);
        return first;
    };
    // frames that begin among what is kept, then those that begin later: only a rest is copied
    const std::size_t kept = pending_.size();
    const std::size_t joined = kept == 0 ? 0 : std::min(samples.size(), options_.size - 1);
    pending_.insert(pending_.end(), samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(joined));
    const std::size_t taken = take_from(pending_, kept);
    if (taken < kept) {
        pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(taken));
        return;
    }
    samples = samples.subspan(taken - kept);
    samples = samples.subspan(take_from(samples, samples.size()));
    pending_.assign(samples.begin(), samples.end());
}

void Welch::take(std::span<const double> samples, double squares) {
    for (std::size_t n = 0; n < samples.size(); ++n)
        windowed_[n] = window_[n] * samples[n];
    powers_of(fourier_.spectrum(std::span(windowed_).first(samples.size())), density_);
    make_densities(density_, rate_ * squares);
    for (std::size_t k = 0; k < density_.size(); ++k)
        sum_[k] += density_[k];
    ++frames_;
    if (listener_) listener_(density_);
}

Spectrum Welch::spectrum() {
    if (frames_ == 0 && !pending_.empty()) {
        // a short signal: its own, shorter window, so that its level stays right
        window_ = window(options_.window, pending_.size());
        const double squares = std::inner_product(window_.begin(), window_.end(), window_.begin(), 0.0);
        if (squares > 0.0) take(pending_, squares);
        pending_.clear();
    }
    Spectrum result;
    result.spacing = spacing();
    result.bandwidth = noise_bandwidth(window_) * rate_ / static_cast<double>(window_.size());
    result.frames = frames_;
    result.density = sum_;
    for (double& value : result.density)
        value /= static_cast<double>(std::max<std::size_t>(1, frames_));
    return result;
}

Spectrum welch(const Signal& signal, WelchOptions options) {
    Welch average(signal.rate, options);
    average.push(signal.samples);
    Spectrum result = average.spectrum();
    result.unit = signal.unit;
    return result;
}

double mean_square_between(const Spectrum& spectrum, double low, double high) {
    double sum = 0.0;
    const auto lines = spectrum.density.size();
    for (std::size_t k = 0; k < lines; ++k) {
        // the first and the last line reach only inwards
        const double centre = static_cast<double>(k) * spectrum.spacing;
        const double from = std::max(low, centre - (k == 0 ? 0.0 : 0.5 * spectrum.spacing));
        const double to = std::min(high, centre + (k + 1 == lines ? 0.0 : 0.5 * spectrum.spacing));
        const double share = k == 0 || k + 1 == lines ? 2.0 : 1.0;
        if (to > from) sum += share * spectrum.density[k] * (to - from);
    }
    return sum;
}

std::vector<double> line_squares(const Spectrum& spectrum) {
    std::vector<double> squares;
    squares.reserve(spectrum.density.size());
    for (const double density : spectrum.density)
        squares.push_back(density * spectrum.bandwidth);
    return squares;
}

namespace {

double octave_median(std::span<const double> density, std::size_t centre) {
    const auto low = static_cast<std::size_t>(0.7071 * static_cast<double>(centre));
    const auto high = std::min(density.size(), static_cast<std::size_t>(1.4142 * static_cast<double>(centre)) + 2);
    return median_of(density.subspan(low, high - low));
}

SpectrumPeak peak_at(const Spectrum& spectrum, std::size_t k) {
    const std::vector<double>& density = spectrum.density;
    SpectrumPeak peak;
    double shift = 0.0;
    double lift = 0.0;
    if (density[k - 1] > 0.0 && density[k + 1] > 0.0) {
        const double left = base::logarithm_2(density[k - 1] / density[k]);
        const double right = base::logarithm_2(density[k + 1] / density[k]);
        const double curvature = left + right;
        shift = curvature < 0.0 ? 0.5 * (left - right) / curvature : 0.0;
        lift = -0.25 * (left - right) * shift;
    }
    peak.frequency = (static_cast<double>(k) + shift) * spectrum.spacing;
    peak.mean_square = density[k] * spectrum.bandwidth * base::power_of_2(lift);
    peak.prominence = base::decibels_of_power(density[k] / std::max(octave_median(density, k), 1e-30 * density[k]));
    return peak;
}

}  // namespace

std::vector<SpectrumPeak> strongest_peaks(const Spectrum& spectrum, std::size_t most, double prominence) {
    constexpr double lowest = 20.0;  // [Hz]
    constexpr std::size_t apart = 4;
    const std::vector<double>& density = spectrum.density;
    std::vector<std::size_t> summits;
    for (std::size_t k = 1; k + 1 < density.size(); ++k)
        if (static_cast<double>(k) * spectrum.spacing >= lowest && density[k] > density[k - 1] &&
            density[k] >= density[k + 1])
            summits.push_back(k);
    std::stable_sort(summits.begin(), summits.end(), [&](auto a, auto b) { return density[a] > density[b]; });

    std::vector<SpectrumPeak> peaks;
    std::vector<std::size_t> taken;
    for (const std::size_t k : summits) {
        if (peaks.size() == most) break;
        const bool is_beside = std::any_of(
            taken.begin(), taken.end(), [&](std::size_t other) { return (k > other ? k - other : other - k) < apart; });
        taken.push_back(k);
        if (is_beside) continue;
        const SpectrumPeak peak = peak_at(spectrum, k);
        if (peak.prominence >= prominence) peaks.push_back(peak);
    }
    return peaks;
}

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
