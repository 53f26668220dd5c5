// ISO 532-1:2017, Zwicker's method:
//   powers of third octaves -> levels as the ear passes them on (A.3 to A.6) -> core loudness per critical band
//   N' = 0.0635 10^(0.025 LTQ) ((1 - s + s 10^((LE - LTQ) / 10))^(1/4) - 1), s = 1/4
//   -> slopes towards higher bands (A.7 to A.9) -> sum over the critical-band rate.
// Levels are kept as powers, so that no logarithm is needed: the fourth root is all that is left.

#include "stridor/sound/loudness.hpp"

#include "stridor/base/elementary.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::sound {

namespace {

constexpr std::size_t critical_bands = 20;  // critical bands
constexpr std::size_t low_bands = 11;       // third octaves up to 250 Hz

// 10^(decibels / 10)
double power_of(double decibels) {
    return base::power_of_2(base::log2_of_ten * decibels / 10.0);
}

// e^x
double exponential(double x) {
    return base::power_of_2(base::log2_of_e * x);
}

// --- tables; ISO 532-1:2017

// A.3: up to which level each row of the corrections below holds [dB]
constexpr std::array<double, 8> level_ranges{45.0, 55.0, 65.0, 71.0, 80.0, 90.0, 100.0, 120.0};
// A.3: corrections of the low third octaves by the contours of equal loudness [dB]
constexpr std::array<std::array<double, low_bands>, 8> low_corrections{{
    {-32.0, -24.0, -16.0, -10.0, -5.0, 0.0, -7.0, -3.0, 0.0, -2.0, 0.0},
    {-29.0, -22.0, -15.0, -10.0, -4.0, 0.0, -7.0, -2.0, 0.0, -2.0, 0.0},
    {-27.0, -19.0, -14.0, -9.0, -4.0, 0.0, -6.0, -2.0, 0.0, -2.0, 0.0},
    {-25.0, -17.0, -12.0, -9.0, -3.0, 0.0, -5.0, -2.0, 0.0, -2.0, 0.0},
    {-23.0, -16.0, -11.0, -7.0, -3.0, 0.0, -4.0, -1.0, 0.0, -1.0, 0.0},
    {-20.0, -14.0, -10.0, -6.0, -3.0, 0.0, -4.0, -1.0, 0.0, -1.0, 0.0},
    {-18.0, -12.0, -9.0, -6.0, -2.0, 0.0, -3.0, -1.0, 0.0, -1.0, 0.0},
    {-15.0, -10.0, -8.0, -4.0, -2.0, 0.0, -3.0, -1.0, 0.0, -1.0, 0.0},
}};
// A.6: level of each critical band at the threshold of hearing, without the way through the ear [dB]
constexpr std::array<double, critical_bands> threshold{30.0, 18.0, 12.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0, 3.0,
                                                       3.0,  3.0,  3.0,  3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0};
// A.4: what the way through the ear takes [dB]
constexpr std::array<double, critical_bands> ear_loss{0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0,  0.0, 0.0, 0.0,
                                                      -0.5, -1.6, -3.2, -5.4, -5.6, -4.0, -1.5, 2.0, 5.0, 12.0};
// A.5: what a diffuse field has more than a free one [dB]
constexpr std::array<double, critical_bands> diffuse_gain{0.0, 0.0,  0.5,  0.9,  1.2,  1.6, 2.3, 2.8, 3.0, 2.0,
                                                          0.0, -1.4, -2.0, -1.9, -1.0, 0.5, 3.0, 4.0, 4.3, 4.0};
// A.7: from a third octave to its critical band [dB]
constexpr std::array<double, critical_bands> band_adaptation{-0.25, -0.6, -0.8, -0.8, -0.5, 0.0, 0.5, 1.1, 1.5, 1.7,
                                                             1.8,   1.8,  1.7,  1.6,  1.4,  1.2, 0.8, 0.5, 0.0, -0.5};
// A.8: upper ends of the critical bands [Bark]
constexpr std::array<double, critical_bands + 1> upper_ends{0.9,  1.8,  2.8,  3.5,  4.4,  5.4,  6.6,
                                                            7.9,  9.2,  10.6, 12.3, 13.8, 15.2, 16.7,
                                                            18.1, 19.3, 20.6, 21.8, 22.7, 23.6, 24.0};
// A.9: from which specific loudness on each row of the steepnesses holds [sone/Bark]
constexpr std::array<double, 18> slope_ranges{21.5, 18.0, 15.1, 11.5, 9.0,  6.1,  4.4,  3.1,   2.13,
                                              1.36, 0.82, 0.42, 0.30, 0.22, 0.15, 0.10, 0.035, 0.0};
// A.9: steepness of the upper slopes by critical band, from the second on; the last holds for all above [sone/Bark²]
constexpr std::array<std::array<double, 8>, 18> slopes{{
    {13.0, 8.2, 6.3, 5.5, 5.5, 5.5, 5.5, 5.5},
    {9.0, 7.5, 6.0, 5.1, 4.5, 4.5, 4.5, 4.5},
    {7.8, 6.7, 5.6, 4.9, 4.4, 3.9, 3.9, 3.9},
    {6.2, 5.4, 4.6, 4.0, 3.5, 3.2, 3.2, 3.2},
    {4.5, 3.8, 3.6, 3.2, 2.9, 2.7, 2.7, 2.7},
    {3.7, 3.0, 2.8, 2.35, 2.2, 2.2, 2.2, 2.2},
    {2.9, 2.3, 2.1, 1.9, 1.8, 1.7, 1.7, 1.7},
    {2.4, 1.7, 1.5, 1.35, 1.3, 1.3, 1.3, 1.3},
    {1.95, 1.45, 1.3, 1.15, 1.1, 1.1, 1.1, 1.1},
    {1.5, 1.2, 0.94, 0.86, 0.82, 0.82, 0.82, 0.82},
    {0.72, 0.67, 0.64, 0.63, 0.62, 0.62, 0.62, 0.62},
    {0.59, 0.53, 0.51, 0.50, 0.42, 0.42, 0.42, 0.42},
    {0.40, 0.33, 0.26, 0.24, 0.24, 0.22, 0.22, 0.22},
    {0.27, 0.21, 0.20, 0.18, 0.17, 0.17, 0.17, 0.17},
    {0.16, 0.15, 0.14, 0.12, 0.11, 0.11, 0.11, 0.11},
    {0.12, 0.11, 0.10, 0.08, 0.08, 0.08, 0.08, 0.08},
    {0.09, 0.08, 0.07, 0.06, 0.06, 0.06, 0.06, 0.05},
    {0.06, 0.05, 0.03, 0.02, 0.02, 0.02, 0.02, 0.02},
}};

// --- the tables as factors on powers

struct Factors {
    std::array<std::array<double, low_bands>, 8> low_limit;  // power up to which a row holds
    std::array<std::array<double, low_bands>, 8> low_factor;
    std::array<std::array<double, critical_bands>, 2> through_ear;  // by field: to the power inside the ear
    std::array<double, critical_bands> threshold_power;
    std::array<double, critical_bands> over_threshold;  // from there to what the fourth root is taken of
    std::array<double, critical_bands> scale;           // [sone/Bark]
};

Factors made_factors() {
    Factors f{};
    for (std::size_t row = 0; row < level_ranges.size(); ++row)
        for (std::size_t k = 0; k < low_bands; ++k) {
            f.low_limit[row][k] = power_of(level_ranges[row] - low_corrections[row][k]);
            f.low_factor[row][k] = power_of(low_corrections[row][k]);
        }
    for (std::size_t k = 0; k < critical_bands; ++k) {
        f.through_ear[0][k] = power_of(-ear_loss[k]);
        f.through_ear[1][k] = power_of(diffuse_gain[k] - ear_loss[k]);
        f.threshold_power[k] = power_of(threshold[k]);
        f.over_threshold[k] = power_of(-band_adaptation[k] - threshold[k]);
        f.scale[k] = 0.0635 * power_of(0.25 * threshold[k]);
    }
    return f;
}

const Factors& factors() {
    static const Factors made = made_factors();
    return made;
}

// a third octave up to 250 Hz by the contour of its level; beyond 120 dB as at 120 dB
double corrected(double ratio, std::size_t band, const Factors& f) {
    std::size_t row = 0;
    while (row + 1 < level_ranges.size() && ratio > f.low_limit[row][band])
        ++row;
    return ratio * f.low_factor[row][band];
}

}  // namespace

CoreLoudness core_loudness(const signal::ThirdOctaves& ratios, SoundField field) {
    const Factors& f = factors();
    // the three lowest critical bands are six, three and two third octaves wide
    std::array<double, critical_bands> powers{};
    for (std::size_t k = 0; k < low_bands; ++k)
        powers[k < 6 ? 0 : k < 9 ? 1 : 2] += corrected(ratios[k], k, f);
    for (std::size_t k = 3; k < critical_bands; ++k)
        powers[k] = ratios[k + 8];

    CoreLoudness core{};
    for (std::size_t k = 0; k < critical_bands; ++k) {
        const double inside = powers[k] * f.through_ear[field == SoundField::free ? 0 : 1][k];
        if (!(inside > f.threshold_power[k])) continue;
        constexpr double s = 0.25;
        const double root = std::sqrt(std::sqrt(1.0 - s + s * inside * f.over_threshold[k]));
        core[k] = std::max(0.0, f.scale[k] * (root - 1.0));
    }
    // within the lowest band the threshold depends on the level: (0.4 + 0.32 N'^0.2) N' where that is less
    if (core[0] > 0.0) core[0] *= std::min(1.0, 0.4 + 0.32 * base::power_of_2(0.2 * base::logarithm_2(core[0])));
    return core;
}

double total_loudness(const CoreLoudness& core, SpecificLoudness* specific) {
    double total = 0.0;
    double from = 0.0;    // [Bark] where the current piece begins
    double height = 0.0;  // [sone/Bark] there
    std::size_t row = slope_ranges.size() - 1;
    std::size_t filled = 0;
    // a piece falls by `steepness` from its beginning
    const auto add = [&](double to, double begin, double steepness) {
        const double end = begin - steepness * (to - from);
        total += 0.5 * (begin + end) * (to - from);
        constexpr double hair = 1e-4;  // [Bark] the ends are whole tenths
        for (; specific != nullptr && filled < specific->size(); ++filled) {
            const double place = 0.1 * static_cast<double>(filled + 1);
            if (place > to + hair) break;
            (*specific)[filled] = begin - steepness * (place - from);
        }
        from = to;
        height = end;
    };
    for (std::size_t band = 0; band < core.size(); ++band) {
        const std::size_t column = std::min<std::size_t>(band > 0 ? band - 1 : 0, 7);
        while (from < upper_ends[band]) {
            if (height <= core[band]) {
                row = 0;
                while (row + 1 < slope_ranges.size() && slope_ranges[row] > core[band])
                    ++row;
                add(upper_ends[band], core[band], 0.0);
            } else {
                // down to the row's end or the band's own core, whichever comes first
                const double floor = std::max(slope_ranges[row], core[band]);
                const double steepness = slopes[row][column];
                const double reach = from + (height - floor) / steepness;
                if (reach > upper_ends[band]) {
                    add(upper_ends[band], height, steepness);
                } else {
                    add(reach, height, steepness);
                    height = floor;  // without rounding, so that the next row begins there
                }
            }
            while (row + 1 < slope_ranges.size() && height <= slope_ranges[row])
                ++row;
        }
    }
    return std::max(0.0, total);
}

double loudness_level(double loudness) {
    if (loudness >= 1.0) return 40.0 + 10.0 * base::logarithm_2(loudness);
    const double level = 40.0 * base::power_of_2(0.35 * base::logarithm_2(loudness + 0.0005));
    return std::max(3.0, level);
}

double sharpness(const SpecificLoudness& specific) {
    constexpr double unit = 0.11;  // [acum] makes the standard's narrow-band noise at 1 kHz and 60 dB 1 acum
    constexpr double knee = 15.8;  // [Bark] above it what is high counts more
    double sum = 0.0;
    double weighted = 0.0;
    for (std::size_t k = 0; k < specific.size(); ++k) {
        const double rate = 0.1 * static_cast<double>(k + 1);
        const double weight = rate <= knee ? 1.0 : 0.15 * exponential(0.42 * (rate - knee)) + 0.85;
        sum += specific[k];
        weighted += specific[k] * weight * rate;
    }
    return sum > 0.0 ? unit * weighted / sum : 0.0;
}

namespace {

constexpr double powers_per_second = 2000.0;
constexpr int steps = 24;                                   // [1] between two powers, along the line that joins them
constexpr double step = 1.0 / (powers_per_second * steps);  // [s]

// [sone], [sone/Bark] less is silence; numbers that shrink for ever become slow to compute with
constexpr double nothing = 1e-12;

// constants of the ear's decay: two stores that empty into each other and away (ISO 532-1, 6.3)
struct Decay {
    Decay() {
        constexpr double short_time = 0.005;     // [s]
        constexpr double long_time = 0.015;      // [s]
        constexpr double variable_time = 0.075;  // [s]
        constexpr double p = (variable_time + long_time) / (variable_time * short_time);
        constexpr double q = 1.0 / (short_time * variable_time);
        const double root = std::sqrt(0.25 * p * p - q);
        const double slow = -0.5 * p + root;  // [1/s] eigenvalues
        const double fast = -0.5 * p - root;
        const double scale = variable_time * (slow - fast);
        const double s = exponential(slow * step);
        const double f = exponential(fast * step);
        charge_of_output = (s - f) / scale;
        charge_of_charge = ((variable_time * fast + 1.0) * s - (variable_time * slow + 1.0) * f) / scale;
        output_of_output = ((variable_time * slow + 1.0) * s - (variable_time * fast + 1.0) * f) / scale;
        output_of_charge = (variable_time * slow + 1.0) * (variable_time * fast + 1.0) * (s - f) / scale;
        alone = exponential(-step / long_time);
        charging = exponential(-step / variable_time);
    }
    double charge_of_output, charge_of_charge, output_of_output, output_of_charge, alone, charging;
};

const Decay& ear() {
    static const Decay decay;
    return decay;
}

// one step of one band: what is louder than the ear holds comes through at once, what is softer lets it decay
void step_of(double input, double& output, double& charge, const Decay& d) {
    const double output_before = output;
    const double charge_before = charge;
    if (input < output_before) {
        if (output_before > charge_before) {
            output = std::max(input, output_before * d.output_of_output - charge_before * d.output_of_charge);
            charge = std::min(output, output_before * d.charge_of_output - charge_before * d.charge_of_charge);
        } else {
            output = std::max(input, output_before * d.alone);
            charge = output;
        }
        return;
    }
    constexpr double equal = 1e-5;  // [sone/Bark] a difference that is none
    output = input;
    const bool stays = input - output_before < equal && input <= charge_before;
    charge = stays ? input : (charge_before - input) * d.charging + input;
}

}  // namespace

void LoudnessOverTime::push(const signal::ThirdOctaves& ratios) {
    const CoreLoudness next = core_loudness(ratios, field_);
    if (has_core_) decay(next);
    core_ = next;
    has_core_ = true;
}

void LoudnessOverTime::finish() {
    if (has_core_) decay({});
    if (has_sum_) weigh(0.0);
    has_core_ = has_sum_ = false;
}

// from the last core towards the next one; the value of an instant is that of its first step
void LoudnessOverTime::decay(const CoreLoudness& next) {
    const Decay& d = ear();
    CoreLoudness here{};
    for (std::size_t k = 0; k < critical_bands; ++k) {
        if (core_[k] == 0.0 && next[k] == 0.0 && decayed_[k] == 0.0 && charge_[k] == 0.0) continue;
        const double rise = (next[k] - core_[k]) / steps;
        double input = core_[k];
        for (int n = 0; n < steps; ++n, input += rise) {
            step_of(input, decayed_[k], charge_[k], d);
            if (n == 0) here[k] = decayed_[k];
        }
        if (next[k] == 0.0 && decayed_[k] < nothing) decayed_[k] = charge_[k] = 0.0;
    }
    const double sum = total_loudness(here);
    if (has_sum_) weigh(sum);
    sum_ = sum;
    has_sum_ = true;
}

// 0.47 of a low pass of 3.5 ms and 0.53 of one of 70 ms
void LoudnessOverTime::weigh(double next) {
    static const double fast_share = 1.0 - exponential(-step / 3.5e-3);
    static const double slow_share = 1.0 - exponential(-step / 70e-3);
    const double rise = (next - sum_) / steps;
    double input = sum_;
    for (int n = 0; n < steps; ++n, input += rise) {
        fast_ += fast_share * (input - fast_);
        slow_ += slow_share * (input - slow_);
        if (n == 0) heard_.count(0.47 * fast_ + 0.53 * slow_);
    }
    if (next == 0.0 && slow_ < nothing) fast_ = slow_ = 0.0;
}

}  // namespace stridor::sound
