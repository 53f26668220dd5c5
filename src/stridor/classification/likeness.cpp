#include "stridor/classification/likeness.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/sound/feature_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::classification {

namespace {

using sound::SoundFeatures;
using sound::SoundStretch;

constexpr double level_step = 3.0;    // [dB]
constexpr double level_weight = 2.0;  // [1]

double share(double value) {
    return std::clamp(value, 0.0, 1.0);
}

double tonality(const SoundProfile& p) {
    return share(p.features.tonality);
}

double repetition(const SoundProfile& p) {
    return share(p.features.repetition);
}

double tone(const SoundProfile& p) {
    return p.features.frequency > 0.0 ? tonality(p) : 0.0;
}

// the envelope of a steady tone repeats, too, after any number of cycles: only a sound that is more impulsive than
// noise has impulses
double impulsiveness(const SoundProfile& p) {
    constexpr double noise = 3.0;
    constexpr double impulses = 10.0;
    return share((p.features.kurtosis - noise) / (impulses - noise));
}

// a feature as it is
template <double SoundFeatures::*member>
double feature(const SoundProfile& p) {
    return p.features.*member;
}

double sure_interval(const SoundProfile& p) {
    return p.impulse_interval > 0.0 ? impulsiveness(p) * share(p.impulse_regularity) : 0.0;
}

// its row, with what makes it comparable
template <double SoundFeatures::*member>
constexpr LikenessFigure of_feature(std::string_view sentence, FigureScale scale, double step, double weight,
                                    double (*sureness)(const SoundProfile&) = nullptr) {
    constexpr const sound::SoundFeature& row = sound::feature_of(member);
    return {row.name, row.unit, sentence, scale, step, weight, feature<member>, sureness};
}

constexpr std::array likeness_table{
    of_feature<&SoundFeatures::frequency>("strongest line; as sure as the sound is tonal", FigureScale::octaves,
                                          1.0 / 6.0, 3.0, tone),
    LikenessFigure{"tonality", "1", "share of the power in the strongest line", FigureScale::linear, 0.2, 2.0,
                   tonality},
    LikenessFigure{"repetition", "1", "likeness of cycles", FigureScale::linear, 0.2, 1.0, repetition},
    of_feature<&SoundFeatures::movement>("movement of the strongest line", FigureScale::linear, 0.1, 1.0, tone),
    of_feature<&SoundFeatures::unsteadiness>("deviation of the level from a line", FigureScale::linear, 3.0, 1.0),
    of_feature<&SoundFeatures::abruptness>("largest change of the level within 20 ms", FigureScale::linear, 6.0, 1.0),
    of_feature<&SoundFeatures::rest>("share of time at rest", FigureScale::linear, 0.15, 2.0),
    of_feature<&SoundFeatures::kurtosis>("impulsiveness", FigureScale::octaves, 0.5, 2.0),
    LikenessFigure{"impulse_interval", "s", "time between impulses; as sure as there are any, and they are regular",
                   FigureScale::octaves, 0.25, 2.0, [](const SoundProfile& p) { return p.impulse_interval; },
                   sure_interval},
    LikenessFigure{"impulse_regularity", "1", "likeness of the intervals between impulses; as sure as there are any",
                   FigureScale::linear, 0.25, 1.0, [](const SoundProfile& p) { return p.impulse_regularity; },
                   impulsiveness},
};

double difference(const LikenessFigure& figure, double first, double second) {
    if (figure.scale == FigureScale::linear) return second - first;
    // a figure that does not exist has no sureness; neither has its difference then
    if (!(first > 0.0 && second > 0.0)) return 0.0;
    return base::logarithm_2(second / first);
}

FigureDifference compared(const LikenessFigure& figure, const SoundProfile& first, const SoundProfile& second) {
    FigureDifference result{figure.name, figure.unit, figure.value(first), figure.value(second), 0.0, 0.0};
    result.steps = std::clamp(difference(figure, result.first, result.second) / figure.step, -most_steps, most_steps);
    const double sureness =
        figure.sureness == nullptr ? 1.0 : std::sqrt(figure.sureness(first) * figure.sureness(second));
    result.share = figure.weight * sureness * result.steps * result.steps;
    return result;
}

FigureDifference compared_levels(const SoundProfile& first, const SoundProfile& second) {
    FigureDifference result{"level", "dB", 0.0, 0.0, 0.0, 0.0};
    result.second = 0.5 * base::decibels(second.features.mean_square / first.features.mean_square);
    result.steps = std::clamp(result.second / level_step, -most_steps, most_steps);
    result.share = level_weight * result.steps * result.steps;
    return result;
}

struct Weighted {
    double value = 0.0;
    double weight = 0.0;
};

// the value below and above which half of the weight lies; the lower one of two
double median(std::vector<Weighted> values) {
    std::sort(values.begin(), values.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
    double whole = 0.0;
    for (const Weighted& each : values)
        whole += each.weight;
    double sum = 0.0;
    for (const Weighted& each : values) {
        sum += each.weight;
        if (2.0 * sum >= whole) return each.value;
    }
    return 0.0;
}

// those that are heard
std::vector<SoundFeatures> loud_ones(std::span<const SoundStretch> stretches, double quiet_depth) {
    double loudest = 0.0;
    for (const SoundStretch& stretch : stretches)
        loudest = std::max(loudest, stretch.features.mean_square);
    const double least = loudest * base::power_of_2(-0.1 * quiet_depth * base::logarithm_2(10.0));
    std::vector<SoundFeatures> loud;
    for (const SoundStretch& stretch : stretches)
        if (stretch.features.mean_square > 0.0 && stretch.features.mean_square >= least)
            loud.push_back(stretch.features);
    return loud;
}

SoundFeatures typical(const std::vector<SoundFeatures>& loud) {
    const auto middle = [&](double SoundFeatures::*member) {
        std::vector<Weighted> values;
        for (const SoundFeatures& f : loud)
            values.push_back({f.*member, sound::energy(f)});
        return median(std::move(values));
    };
    SoundFeatures result;
    for (const sound::SoundFeature& feature : sound::feature_table)
        result.*feature.member = middle(feature.member);
    double energy = 0.0;
    for (const SoundFeatures& f : loud) {
        energy += sound::energy(f);
        result.duration += f.duration;
        result.peak = std::max(result.peak, f.peak);
        result.impulses += f.impulses;
    }
    result.from = loud.front().from;
    result.mean_square = energy / result.duration;
    return result;
}

}  // namespace

std::span<const LikenessFigure> likeness_figures() {
    return likeness_table;
}

SoundProfile profile_of(std::span<const SoundStretch> stretches, const RecordingVerdict& verdict,
                        const parameters::SoundThresholds& thresholds) {
    SoundProfile profile;
    const std::vector<SoundFeatures> loud = loud_ones(stretches, thresholds.quiet_depth);
    if (loud.empty()) return profile;
    profile.features = typical(loud);
    profile.impulse_interval = profile.features.impulse_interval;
    profile.impulse_regularity = profile.features.impulse_periodicity;
    // impulses further apart than a stretch is long are seen by their instants only
    const SoundSegment* loudest = verdict.loudest();
    const bool is_slow = loudest != nullptr && loudest->impulse_interval > 0.0 &&
                         profile.impulse_regularity < thresholds.creak_periodicity;
    if (is_slow) {
        profile.impulse_interval = loudest->impulse_interval;
        profile.impulse_regularity = loudest->impulse_regularity;
    }
    return profile;
}

Likeness likeness(const SoundProfile& first, const SoundProfile& second, LevelUse level) {
    if (is_silent(first) || is_silent(second)) return {is_silent(first) == is_silent(second) ? 0.0 : most_steps, {}};
    Likeness result;
    double weights = 0.0;
    double sum = 0.0;
    for (const LikenessFigure& figure : likeness_table) {
        result.differences.push_back(compared(figure, first, second));
        weights += figure.weight;
    }
    if (level == LevelUse::counted) {
        result.differences.push_back(compared_levels(first, second));
        weights += level_weight;
    }
    for (const FigureDifference& each : result.differences)
        sum += each.share;
    result.distance = std::sqrt(sum / weights);
    for (FigureDifference& each : result.differences)
        each.share = sum > 0.0 ? each.share / sum : 0.0;
    std::stable_sort(result.differences.begin(), result.differences.end(),
                     [](const FigureDifference& a, const FigureDifference& b) { return a.share > b.share; });
    return result;
}

}  // namespace stridor::classification
