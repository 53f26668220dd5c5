#include "stridor/classification/recording_verdict.hpp"

#include "stridor/base/decibels.hpp"
#include "stridor/classification/ear_weights.hpp"
#include "stridor/classification/sound_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::classification {

namespace {

using parameters::SoundThresholds;
using sound::Passage;
using sound::SoundStretch;

constexpr double segment_depth = 20.0;     // [dB] below its passage's loudest stretch a noise has paused
constexpr double over_rubbing = 0.9;       // [1] share from which a noise is all there is
constexpr double no_friction = 0.8;        // [1] probability from which a quiet recording is said to be none
constexpr std::size_t told_reasons = 3;    // figures in a sentence
constexpr double least_told_reason = 0.2;  // [1] smaller ones explain nothing

double energy(const Passage& passage) {
    return passage.tones.mean_square * passage.duration;
}

std::size_t place_of(Category category) {
    return static_cast<std::size_t>(category);
}

std::array<double, category_names.size()> by_category(const EarVerdict& heard) {
    std::array<double, category_names.size()> probabilities{};
    for (std::size_t h = 0; h < heard.probabilities.size(); ++h)
        probabilities[place_of(category_of(static_cast<EarOutcome>(h)))] += heard.probabilities[h];
    return probabilities;
}

std::string_view name_of(EarOutcome heard) {
    return heard_names[static_cast<std::size_t>(heard)];
}

// "tone_length 5.52 (+2.2), beat 0.24 (+1.2)"
std::string reason_of(const EarVerdict& heard) {
    std::array<std::size_t, ear_figure_count> places{};
    std::iota(places.begin(), places.end(), std::size_t{0});
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return heard.reasons[a] > heard.reasons[b]; });
    std::string text;
    for (std::size_t k = 0; k < told_reasons && heard.reasons[places[k]] > least_told_reason; ++k) {
        const EarFigure& figure = ear_figures()[places[k]];
        text += fmt::format("{}{} {:.2f} ({:+.1f})", text.empty() ? "" : ", ", figure.name, heard.values[places[k]],
                            heard.reasons[places[k]]);
    }
    return text.empty() ? "no figure stands out" : text;
}

std::vector<HeardPassage> heard_passages(std::span<const Passage> passages, const SoundThresholds& t) {
    double loudest = 0.0;
    for (const Passage& passage : passages)
        loudest = std::max(loudest, passage.tones.mean_square);
    std::vector<HeardPassage> heard;
    for (const Passage& passage : passages) {
        HeardPassage here{passage.from, passage.from + passage.duration, energy(passage), Category::none,
                          hear(passage)};
        const bool is_background = !(passage.tones.mean_square > loudest * base::power_of_decibels(-t.quiet_depth));
        if (!is_background) here.category = category_of(here.ear.heard);
        heard.push_back(here);
    }
    return heard;
}

// --- the segments

struct PassageStretches {
    std::span<const SoundStretch> stretches;
    double loudest = 0.0;  // [unit²]
};

double middle_of(const SoundStretch& stretch) {
    return stretch.features.from + 0.5 * stretch.features.duration;
}

std::vector<PassageStretches> parted(std::span<const SoundStretch> stretches, std::span<const HeardPassage> heard) {
    std::vector<PassageStretches> parts;
    std::size_t first = 0;
    for (std::size_t k = 0; k < heard.size(); ++k) {
        std::size_t end = first;
        while (end < stretches.size() && (k + 1 == heard.size() || middle_of(stretches[end]) < heard[k].to))
            ++end;
        PassageStretches part{stretches.subspan(first, end - first), 0.0};
        for (const SoundStretch& stretch : part.stretches)
            part.loudest = std::max(part.loudest, stretch.features.mean_square);
        parts.push_back(part);
        first = end;
    }
    return parts;
}

void append(std::vector<SoundSegment>& segments, const SoundStretch& stretch, Category category,
            const HeardPassage& heard) {
    const sound::SoundFeatures& f = stretch.features;
    const bool continues = !segments.empty() && segments.back().verdict.category == category;
    if (!continues) {
        SoundSegment segment;
        segment.from = segment.to = f.from;
        segment.verdict.category = category;
        segments.push_back(std::move(segment));
    }
    SoundSegment& segment = segments.back();
    const double before = segment.to - segment.from;
    const bool is_louder = before == 0.0 || f.mean_square > segment.verdict.features.mean_square;
    segment.to = f.from + f.duration;
    segment.mean_square = (segment.mean_square * before + sound::energy(f)) / (before + f.duration);
    if (!is_louder) return;
    segment.verdict.features = f;
    segment.verdict.reasons = {category == heard.category
                                   ? fmt::format("{} with {:.0f} %, against {}: {}", name_of(heard.ear.heard),
                                                 100.0 * by_category(heard.ear)[place_of(category)],
                                                 name_of(heard.ear.rival), reason_of(heard.ear))
                                   : std::string("a pause of the noise")};
}

std::vector<SoundSegment> segments_of(std::span<const SoundStretch> stretches, std::span<const Passage> passages,
                                      std::span<const HeardPassage> heard) {
    std::vector<SoundSegment> segments;
    const std::vector<PassageStretches> parts = parted(stretches, heard);
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (const SoundStretch& stretch : parts[k].stretches) {
            const double least = parts[k].loudest * base::power_of_decibels(-segment_depth);
            const Category category = stretch.features.mean_square >= least ? heard[k].category : Category::none;
            append(segments, stretch, category, heard[k]);
        }
    for (SoundSegment& segment : segments) {
        if (segment.verdict.category != Category::creak) continue;
        for (const Passage& passage : passages)
            for (const double instant : passage.onsets.instants)
                if (instant >= segment.from && instant < segment.to) segment.impulses.push_back(instant);
        describe_impulses(segment, segment.impulses);
    }
    return segments;
}

// --- the whole

// Is what makes no noise likely no friction at all? Weighted by energy.
bool is_unlike_friction(std::span<const HeardPassage> heard) {
    double other = 0.0;
    double whole = 0.0;
    for (const HeardPassage& passage : heard) {
        whole += passage.energy;
        other += passage.energy * passage.ear.probabilities[static_cast<std::size_t>(EarOutcome::other)];
    }
    return other >= no_friction * whole;
}

// Which of a sound's figures argues against quiet, and what it shows.
struct QuietDoubt {
    std::string_view figure;
    std::string_view words;
    EarStanding fitted;
};

constexpr std::array quiet_doubts{
    QuietDoubt{"train", "a row of onsets stands in it", ear_row},
    QuietDoubt{"tone_presence", "a tone stands in it", ear_line},
};

// the greatest value of a figure in what is no background
double greatest_of(std::string_view figure, std::span<const HeardPassage> heard, const SoundThresholds& t) {
    const auto figures = ear_figures();
    const auto place = std::find_if(figures.begin(), figures.end(), [&](const auto& f) { return f.name == figure; });
    const auto power = [](const HeardPassage& passage) { return passage.energy / (passage.to - passage.from); };
    double loudest = 0.0;
    for (const HeardPassage& passage : heard)
        loudest = std::max(loudest, power(passage));
    double greatest = 0.0;
    for (const HeardPassage& passage : heard)
        if (power(passage) > loudest * base::power_of_decibels(-t.quiet_depth))
            greatest = std::max(greatest, passage.ear.values[static_cast<std::size_t>(place - figures.begin())]);
    return greatest;
}

// Quiet is not sure where a row or a tone stands in the sound: no more than such verdicts were right. Returns the
// words.
std::string doubt_quiet(RecordingVerdict& verdict, const SoundThresholds& t) {
    std::string words;
    for (const QuietDoubt& standing : quiet_doubts) {
        const double value = greatest_of(standing.figure, verdict.passages, t);
        if (value < standing.fitted.least) continue;
        verdict.probability = std::min(verdict.probability, standing.fitted.right);
        words += fmt::format(", though {}, {} {:.2f}: {:.0f} % of such verdicts were right", standing.words,
                             standing.figure, value, 100.0 * standing.fitted.right);
    }
    return words;
}

void decide(RecordingVerdict& verdict, const SoundThresholds& t) {
    const auto noises = {Category::squeal, Category::squeak, Category::creak};
    const Category strongest = std::max(
        noises, [&](Category a, Category b) { return verdict.shares[place_of(a)] < verdict.shares[place_of(b)]; });
    const double share = verdict.shares[place_of(strongest)];
    verdict.category = share >= t.least_share ? strongest : Category::none;
    double energy = 0.0;
    for (const HeardPassage& passage : verdict.passages) {
        if (passage.category != verdict.category) continue;
        energy += passage.energy;
        verdict.probability += passage.energy * by_category(passage.ear)[place_of(verdict.category)];
    }
    if (energy > 0.0) verdict.probability /= energy;
    const bool is_noise = verdict.category != Category::none;
    const std::string doubt = is_noise ? std::string() : doubt_quiet(verdict, t);
    const std::string_view quiet =
        is_unlike_friction(verdict.passages) ? "sounds like no friction" : "mere rubbing, or no friction";
    std::string reason = is_noise ? fmt::format("{:.0f} % of the energy", 100.0 * share) : std::string(quiet);
    reason += fmt::format(", probability {:.2f}{}", verdict.probability, doubt);
    if (is_noise && share < over_rubbing) reason += ", over rubbing or other sounds";
    verdict.reasons.push_back(std::move(reason));
    for (const Category other : noises)
        if (other != verdict.category && verdict.shares[place_of(other)] >= t.least_share)
            verdict.reasons.push_back(
                fmt::format("{} too, {:.0f} % of the energy", name(other), 100.0 * verdict.shares[place_of(other)]));
    if (verdict.probability >= t.certainty) return;
    verdict.reasons.push_back(fmt::format("{} is the likeliest, and not likely enough", name(verdict.category)));
    verdict.category = Category::undecided;
}

}  // namespace

RecordingVerdict classify_passages(std::span<const SoundStretch> stretches, std::span<const Passage> passages,
                                   const SoundThresholds& t) {
    RecordingVerdict verdict;
    verdict.passages = heard_passages(passages, t);
    verdict.segments = segments_of(stretches, passages, verdict.passages);
    double whole = 0.0;
    for (const HeardPassage& passage : verdict.passages) {
        verdict.shares[place_of(passage.category)] += passage.energy;
        whole += passage.energy;
    }
    if (!(whole > 0.0)) {
        verdict.category = Category::none;
        verdict.reasons.emplace_back("there is nothing to hear");
        for (SoundSegment& segment : verdict.segments)
            segment.verdict.reasons.clear();
        return verdict;
    }
    for (double& share : verdict.shares)
        share /= whole;
    decide(verdict, t);
    return verdict;
}

RecordingVerdict verdict_on(const sound::SoundAnalysis& channel, const SoundThresholds& t) {
    RecordingVerdict verdict = channel.passages.empty() ? classify_recording(channel.stretches, t)
                                                        : classify_passages(channel.stretches, channel.passages, t);
    const bool is_told = verdict.category == Category::squeal || verdict.category == Category::undecided;
    if (is_told || 0.5 * channel.rate >= t.least_band) return verdict;
    verdict.reasons.push_back(fmt::format(
        "{} is a guess: {:.0f} samples a second hold too little of an impulse, and nothing above {:.0f} Hz. "
        "Sample at {:.0f} Hz or more",
        name(verdict.category), channel.rate, 0.5 * channel.rate, 2.0 * t.least_band));
    verdict.category = Category::undecided;
    return verdict;
}

}  // namespace stridor::classification
