#include "stridor/classification/sound_rules.hpp"

#include "stridor/base/decibels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace stridor::classification {

namespace {

using parameters::SoundThresholds;
using sound::SoundFeatures;
using sound::SoundStretch;

// What deviates from a straight fall of the level, as a share of the fall; infinite where the level does not fall.
double crookedness(const SoundFeatures& features) {
    const double fall = -features.trend * features.duration;
    return fall > 0.0 ? features.unsteadiness / fall : std::numeric_limits<double>::infinity();
}

std::vector<Margin> margins_of(const SoundFeatures& f, const SoundThresholds& t) {
    const auto margin = [](std::string_view threshold_name, std::string_view figure_name, double figure,
                           double threshold) {
        return Margin{threshold_name, figure_name, figure, threshold, figure - threshold};
    };
    return {
        margin("least_clearness", "clearness", f.clearness, t.least_clearness),
        margin("decay", "fall of the level", -f.trend, t.decay),
        margin("decay_straightness", "deviation from it", crookedness(f), t.decay_straightness),
        margin("creak_rest", "rest", f.rest, t.creak_rest),
        margin("creak_kurtosis", "kurtosis", f.kurtosis, t.creak_kurtosis),
        margin("rubbing_tonality", "tonality", f.tonality, t.rubbing_tonality),
        margin("rubbing_repetition", "repetition", f.repetition, t.rubbing_repetition),
        margin("least_frequency", "frequency", f.frequency, t.least_frequency),
        margin("creak_periodicity", "impulse periodicity", f.impulse_periodicity, t.creak_periodicity),
        margin("squeal_regularity", "regularity", f.regularity, t.squeal_regularity),
        margin("squeal_repetition", "repetition", f.repetition, t.squeal_repetition),
        margin("squeal_movement", "movement", f.movement, t.squeal_movement),
    };
}

}  // namespace

SoundVerdict classify_sound(const SoundFeatures& f, const SoundThresholds& t) {
    SoundVerdict verdict{Category::undecided, f, margins_of(f, t), {}};
    const auto decide = [&](Category category, std::string reason) {
        verdict.category = category;
        verdict.reasons.push_back(std::move(reason));
        return verdict;
    };
    if (!(f.mean_square > 0.0) || f.clearness < t.least_clearness)
        return decide(Category::none, "nothing stands out of the background");
    if (-f.trend >= t.decay && crookedness(f) <= t.decay_straightness)
        return decide(Category::none, fmt::format("dies away by itself, {:.1f} dB/s", -f.trend));
    if (f.rest >= t.creak_rest)
        return decide(Category::creak, fmt::format("rests {:.1f} % of the time between impulses", 100.0 * f.rest));
    if (f.kurtosis >= t.creak_kurtosis)
        return decide(Category::creak, fmt::format("impulses stand out (kurtosis {:.1f})", f.kurtosis));
    const bool is_broad = f.tonality < t.rubbing_tonality && f.repetition < t.rubbing_repetition;
    if (is_broad || f.frequency < t.least_frequency) {
        verdict.reasons.push_back(
            fmt::format("no tone: {:.1f} % of the power in the strongest line at {:.0f} Hz, cycles alike to {:.2f}",
                        100.0 * f.tonality, f.frequency, f.repetition));
        if (f.impulse_periodicity >= t.creak_periodicity)
            return decide(Category::creak, fmt::format("impulses every {:.1f} ms, alike to {:.2f}",
                                                       1e3 * f.impulse_interval, f.impulse_periodicity));
        return decide(Category::none, "and no impulses that repeat: mere rubbing");
    }
    const bool has_period = f.repetition >= t.squeal_repetition;
    if (f.regularity < t.squeal_regularity && !has_period)
        return decide(Category::squeak, fmt::format("a tone at {:.0f} Hz whose cycles are alike to {:.3f} only",
                                                    f.frequency, f.regularity));
    if (f.movement > t.squeal_movement)
        return decide(Category::squeak,
                      fmt::format("a tone that moves by {:.1f} % around {:.0f} Hz", 100.0 * f.movement, f.frequency));
    if (f.regularity < t.squeal_regularity)
        return decide(
            Category::squeal,
            fmt::format("a steady sound that comes again {:.1f} times a second, alike to {:.3f}, strongest at "
                        "{:.0f} Hz",
                        f.repetition_frequency, f.repetition, f.frequency));
    return decide(Category::squeal, fmt::format("a steady tone at {:.0f} Hz whose cycles are alike to {:.3f}",
                                                f.frequency, f.regularity));
}

void describe_impulses(SoundSegment& segment, std::span<const double> impulses) {
    std::vector<double> intervals(impulses.size());
    std::adjacent_difference(impulses.begin(), impulses.end(), intervals.begin());
    if (intervals.size() < 2) return;
    intervals.erase(intervals.begin());
    double change = 0.0;
    for (std::size_t k = 1; k < intervals.size(); ++k)
        change += std::abs(intervals[k] - intervals[k - 1]);
    const double sum = std::accumulate(intervals.begin(), intervals.end(), 0.0);
    const auto count = static_cast<double>(intervals.size());
    if (intervals.size() > 1) segment.impulse_regularity = std::max(0.0, 1.0 - change / (count - 1.0) / (sum / count));
    const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
    std::nth_element(intervals.begin(), middle, intervals.end());
    segment.impulse_interval = *middle;
}

namespace {

// the impulses of creaks with nothing but rest between them
struct Train {
    std::size_t first = 0;  // of its segments
    std::size_t last = 0;
    std::vector<double> impulses{};  // [s] shape [impulse]
    double from = 0.0;               // [s]
    double to = 0.0;                 // [s]
};

// One slip in half a second leaves a stretch of its own, with rest before and after it: knocks that come again within
// `creak_pause` are one train.
std::vector<Train> trains_of(std::span<const SoundSegment> segments, const SoundThresholds& t) {
    std::vector<Train> trains;
    bool is_open = false;
    for (std::size_t k = 0; k < segments.size(); ++k) {
        const SoundSegment& segment = segments[k];
        const Category category = segment.verdict.category;
        if (category == Category::none || category == Category::undecided) continue;
        const bool is_creak = category == Category::creak;
        if (is_creak) {
            const double begin = segment.impulses.empty() ? segment.from : segment.impulses.front();
            const double end = !is_open                         ? 0.0
                               : trains.back().impulses.empty() ? trains.back().to
                                                                : trains.back().impulses.back();
            if (!is_open || begin - end > t.creak_pause) trains.push_back({k, k, {}, segment.from, segment.to});
            Train& train = trains.back();
            train.last = k;
            train.to = segment.to;
            train.impulses.insert(train.impulses.end(), segment.impulses.begin(), segment.impulses.end());
        }
        is_open = is_creak;
    }
    return trains;
}

void append(SoundSegment& segment, const SoundStretch& stretch, SoundVerdict verdict) {
    const SoundFeatures& f = stretch.features;
    const double before = segment.to - segment.from;
    segment.to = f.from + f.duration;
    segment.mean_square = (segment.mean_square * before + sound::energy(f)) / (before + f.duration);
    for (const double instant : stretch.impulses)
        segment.impulses.push_back(f.from + instant);
    const bool is_louder = segment.verdict.margins.empty() || f.mean_square > segment.verdict.features.mean_square;
    if (is_louder) segment.verdict = std::move(verdict);
}

std::vector<SoundSegment> segments_of(std::span<const SoundStretch> stretches, const SoundThresholds& t) {
    double loudest = 0.0;
    for (const SoundStretch& stretch : stretches)
        loudest = std::max(loudest, stretch.features.mean_square);
    std::vector<SoundSegment> segments;
    for (const SoundStretch& stretch : stretches) {
        const SoundFeatures& f = stretch.features;
        SoundVerdict verdict = classify_sound(f, t);
        const double depth = base::decibels_of_power(loudest / f.mean_square);
        if (verdict.category != Category::none && depth > t.quiet_depth) {
            verdict.category = Category::none;
            verdict.reasons = {fmt::format("lies {:.1f} dB below the loudest stretch", depth)};
        }
        const bool continues = !segments.empty() && segments.back().verdict.category == verdict.category;
        if (!continues) segments.push_back({f.from, f.from, 0.0, {}, 0.0, 0.0, {}});
        append(segments.back(), stretch, std::move(verdict));
    }
    return segments;
}

void doubt_duration(SoundVerdict& verdict, double duration, const SoundThresholds& t) {
    if (verdict.category == Category::none || duration >= t.least_duration) return;
    verdict.category = Category::undecided;
    verdict.reasons.push_back(fmt::format("lasts only {:.0f} ms", 1e3 * duration));
}

void doubt(SoundSegment& segment, const Train& train, const SoundThresholds& t) {
    SoundVerdict& verdict = segment.verdict;
    const bool repeats = train.first < train.last;
    const double duration = repeats ? train.to - train.from : segment.to - segment.from;
    doubt_duration(verdict, duration, t);
    if (verdict.category != Category::creak) {
        segment.impulses.clear();
        return;
    }
    describe_impulses(segment, train.impulses);
    // impulses that run into each other are counted by their interval
    const SoundFeatures& f = verdict.features;
    const bool is_periodic = f.impulse_periodicity >= t.creak_periodicity && f.impulse_interval > 0.0;
    const double cycles = is_periodic ? std::floor((segment.to - segment.from) / f.impulse_interval) : 0.0;
    const double count = std::max(static_cast<double>(train.impulses.size()), cycles);
    verdict.margins.push_back({"least_impulses", "impulses", count, t.least_impulses, count - t.least_impulses});
    if (count < t.least_impulses) {
        verdict.category = Category::undecided;
        verdict.reasons.push_back(fmt::format("only {} impulses: a knock rather than a creak", train.impulses.size()));
    } else if (static_cast<double>(segment.impulses.size()) < t.least_impulses && repeats) {
        verdict.reasons.push_back(fmt::format("one of {} impulses with rest between them", train.impulses.size()));
    }
}

void doubt(std::span<SoundSegment> segments, const SoundThresholds& t) {
    for (SoundSegment& segment : segments) {
        if (segment.verdict.category == Category::creak) continue;
        segment.impulses.clear();
        doubt_duration(segment.verdict, segment.to - segment.from, t);
    }
    for (const Train& train : trains_of(segments, t))
        for (std::size_t k = train.first; k <= train.last; ++k)
            if (segments[k].verdict.category == Category::creak) doubt(segments[k], train, t);
}

}  // namespace

RecordingVerdict classify_recording(std::span<const SoundStretch> stretches, const SoundThresholds& t) {
    RecordingVerdict verdict;
    verdict.segments = segments_of(stretches, t);
    double whole = 0.0;
    doubt(verdict.segments, t);
    for (const SoundSegment& segment : verdict.segments) {
        const double energy = segment.mean_square * (segment.to - segment.from);
        verdict.shares[static_cast<std::size_t>(segment.verdict.category)] += energy;
        whole += energy;
    }
    if (stretches.empty()) {
        verdict.reasons.emplace_back("the recording is shorter than the shortest stretch that can be judged");
        return verdict;
    }
    if (!(whole > 0.0)) {
        verdict.category = Category::none;
        verdict.reasons.emplace_back("nothing stands out of the background anywhere");
        return verdict;
    }
    for (double& share : verdict.shares)
        share /= whole;
    const auto most = std::max_element(verdict.shares.begin(), verdict.shares.end());
    const auto category = static_cast<Category>(most - verdict.shares.begin());
    verdict.reasons.push_back(fmt::format("{:.1f} % of the energy is {}", 100.0 * *most, name(category)));
    if (*most >= t.majority)
        verdict.category = category;
    else
        verdict.reasons.emplace_back("no category has the majority");
    return verdict;
}

const SoundSegment* RecordingVerdict::loudest() const {
    const SoundSegment* best = nullptr;
    for (const SoundSegment& segment : segments)
        if (segment.verdict.category == category && (best == nullptr || segment.mean_square > best->mean_square))
            best = &segment;
    return best;
}

}  // namespace stridor::classification
