#include "stridor/classification/ear.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/classification/ear_weights.hpp"

#include <algorithm>
#include <numeric>

namespace stridor::classification {

namespace {

using sound::Passage;

constexpr double most_deviations = 2.5;  // [1] beyond which a figure says no more

// how sure what is said of tones is: nothing is known of the pitch of what has none
double tone_sureness(const Passage& p) {
    return std::min(1.0, p.tones.presence / 0.4);
}

double presence(const Passage& p) {
    return p.tones.presence;
}

double tone_length(const Passage& p) {
    return tone_sureness(p) * base::logarithm_2(1.0 + p.tones.length / 0.06);
}

double wander(const Passage& p) {
    return tone_sureness(p) * std::min(p.tones.wander, 1.2);
}

// voices and engines have many lines close together
double comb(const Passage& p) {
    return p.tones.spacing > 0.0 ? tone_sureness(p) * std::clamp(base::logarithm_2(400.0 / p.tones.spacing), -1.0, 2.0)
                                 : 0.0;
}

double centre(const Passage& p) {
    return p.tones.centre > 0.0 ? base::logarithm_2(p.tones.centre / 1000.0) : 0.0;
}

double spread(const Passage& p) {
    return p.tones.spread;
}

double onset_rate(const Passage& p) {
    return std::min(6.0, base::logarithm_2(2.0 + p.onsets.rate));
}

// rows at any pace
double train(const Passage& p) {
    return std::max(p.onsets.train, p.onsets.fast_train);
}

// impulses count against a creak only where they are in no row
double lone_impulses(const Passage& p) {
    return (1.0 - train(p)) * std::clamp(base::logarithm_2(std::max(p.onsets.kurtosis, 1e-3)), 0.0, 6.0);
}

// the wave of a row repeats as its bodies ring, and says nothing of the row
double lone_fundamental(const Passage& p) {
    if (!(p.tones.fundamental > 0.0)) return 0.0;
    return (1.0 - train(p)) * tone_sureness(p) * base::logarithm_2(p.tones.fundamental / 300.0);
}

// a pace counts against a creak only where it is that of no row
double lone_rhythm(const Passage& p) {
    return (1.0 - train(p)) * p.onsets.rhythm;
}

// of a row of seven or more in which the level rises fast and falls slowly
double jerks_of(double skewness, double longest_train) {
    const double asymmetry = std::max(0.0, skewness);
    return asymmetry / (1.0 + asymmetry) * std::min(1.0, base::logarithm_2(1.0 + longest_train) / 3.0);
}

// releases of stick and slip, at the pace that shows them: a room takes of their height, less of their shape
double jerks(const Passage& p) {
    return std::max(jerks_of(p.onsets.skewness, p.onsets.longest_train),
                    jerks_of(p.onsets.fast_skewness, p.onsets.longest_fast_train));
}

double joint_jerks(const Passage& p) {
    return jerks_of(p.onsets.joint_skewness, p.onsets.joint_train);
}

double beat(const Passage& p) {
    return std::min(p.onsets.beat, 10.0);
}

double level_spread(const Passage& p) {
    return p.onsets.level_spread;
}

double sounding(const Passage& p) {
    return p.onsets.sounding;
}

constexpr std::array<EarFigure, ear_figure_count> figure_table{
    EarFigure{"tone_presence", "1", presence},
    EarFigure{"tone_length", "octave", tone_length},
    EarFigure{"tone_wander", "octave", wander},
    EarFigure{"comb", "octave", comb},
    EarFigure{"centre", "octave", centre},
    EarFigure{"spread", "octave", spread},
    EarFigure{"lone_fundamental", "octave", lone_fundamental},
    EarFigure{"lone_impulses", "octave", lone_impulses},
    EarFigure{"onset_rate", "octave", onset_rate},
    EarFigure{"train", "1", train},
    EarFigure{"jerks", "1", jerks},
    EarFigure{"joint_jerks", "1", joint_jerks},
    EarFigure{"beat", "dB", beat},
    EarFigure{"lone_rhythm", "dB", lone_rhythm},
    EarFigure{"level_spread", "dB", level_spread},
    EarFigure{"sounding", "1", sounding},
};

double sum_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

std::span<const EarFigure, ear_figure_count> ear_figures() {
    return figure_table;
}

EarVerdict hear(const Passage& passage) {
    EarVerdict verdict;
    EarValues deviations;
    for (std::size_t k = 0; k < ear_figure_count; ++k) {
        verdict.values[k] = figure_table[k].value(passage);
        deviations[k] =
            std::clamp((verdict.values[k] - ear_means[k]) / ear_scales[k], -most_deviations, most_deviations);
    }
    auto& probabilities = verdict.probabilities;
    for (std::size_t h = 0; h < probabilities.size(); ++h)
        probabilities[h] =
            std::inner_product(deviations.begin(), deviations.end(), ear_weights[h].begin(), ear_biases[h]);
    const double greatest = *std::max_element(probabilities.begin(), probabilities.end());
    for (double& p : probabilities)
        p = base::exponential(p - greatest);
    const double whole = sum_of(probabilities);
    for (double& p : probabilities)
        p /= whole;

    const auto best = std::max_element(probabilities.begin(), probabilities.end());
    const auto first = static_cast<std::size_t>(best - probabilities.begin());
    verdict.heard = static_cast<EarOutcome>(first);
    std::size_t second = probabilities.size();
    for (std::size_t h = 0; h < probabilities.size(); ++h) {
        const bool is_rival = category_of(static_cast<EarOutcome>(h)) != category_of(verdict.heard);
        if (is_rival && (second == probabilities.size() || probabilities[h] > probabilities[second])) second = h;
    }
    verdict.rival = static_cast<EarOutcome>(second);
    for (std::size_t k = 0; k < ear_figure_count; ++k)
        verdict.reasons[k] = deviations[k] * (ear_weights[first][k] - ear_weights[second][k]);
    return verdict;
}

}  // namespace stridor::classification
