#include "stridor/classification/compared_sound.hpp"

#include "stridor/signal/level.hpp"
#include "stridor/sound/feature_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace stridor::classification {

namespace {

using sound::SoundFeatures;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// a figure of the sound; silence has none
template <double SoundFeatures::*member>
double of_sound(const ComparedSound& sound) {
    return is_silent(sound.profile) ? unknown : sound.profile.features.*member;
}

// the same where 0 says that there is no such thing
template <double SoundFeatures::*member>
double if_any(const ComparedSound& sound) {
    return of_sound<member>(sound) > 0.0 ? of_sound<member>(sound) : unknown;
}

double level(const ComparedSound& sound) {
    if (is_silent(sound.profile)) return unknown;
    return signal::level_of(sound.profile.features.mean_square, signal::reference_of(sound.analysis.unit));
}

template <double analysis::Rates::*member>
double rate(const ComparedSound& sound) {
    const Verdict* verdict = loudest_phase(sound.contact);
    return verdict == nullptr ? unknown : verdict->evidence.rates.*member;
}

double contact_regularity(const ComparedSound& sound) {
    const Verdict* verdict = loudest_phase(sound.contact);
    return verdict == nullptr ? unknown : verdict->evidence.alternation.regularity;
}

double contact_frequency(const ComparedSound& sound) {
    const Verdict* verdict = loudest_phase(sound.contact);
    const bool alternates = verdict != nullptr && verdict->evidence.alternation.frequency > 0.0;
    return alternates ? verdict->evidence.alternation.frequency : unknown;
}

// what is no more impulsive than noise has none
bool has_impulses(const ComparedSound& sound) {
    constexpr double noise = 3.0;
    return sound.profile.features.kurtosis > noise && sound.profile.impulse_interval > 0.0;
}

double impulse_interval(const ComparedSound& sound) {
    return has_impulses(sound) ? sound.profile.impulse_interval : unknown;
}

double impulse_regularity(const ComparedSound& sound) {
    return has_impulses(sound) ? sound.profile.impulse_regularity : unknown;
}

using enum FigureStyle;

// the row of a feature, in words for people
template <double SoundFeatures::*member, double (*value)(const ComparedSound&) = of_sound<member>>
constexpr ComparedFigure feature(std::string_view words, FigureStyle style, int digits) {
    constexpr const sound::SoundFeature& row = sound::feature_of(member);
    return {row.name, row.unit, words, style, digits, value};
}

constexpr std::array table{
    ComparedFigure{"slip", "1", "slip", percent, 1, rate<&analysis::Rates::slip>},
    ComparedFigure{"stick", "1", "stick", percent, 1, rate<&analysis::Rates::stick>},
    ComparedFigure{"separation", "1", "separation", percent, 1, rate<&analysis::Rates::separation>},
    ComparedFigure{"contact_regularity", "1", "regularity of the states", fixed, 3, contact_regularity},
    ComparedFigure{"contact_frequency", "Hz", "frequency of the states", fixed, 0, contact_frequency},
    ComparedFigure{"level", "", "level", fixed, 1, level},
    feature<&SoundFeatures::clearness>("clearness", fixed, 1),
    feature<&SoundFeatures::frequency, if_any<&SoundFeatures::frequency>>("dominant frequency", fixed, 0),
    feature<&SoundFeatures::prominence>("prominence", fixed, 1),
    feature<&SoundFeatures::tonality>("tonality", fixed, 2),
    feature<&SoundFeatures::regularity>("regularity", fixed, 3),
    feature<&SoundFeatures::repetition_frequency, if_any<&SoundFeatures::repetition_frequency>>("best cycle", fixed, 0),
    feature<&SoundFeatures::repetition>("likeness of cycles", fixed, 3),
    feature<&SoundFeatures::movement>("movement", percent, 1),
    feature<&SoundFeatures::unsteadiness>("unsteadiness", fixed, 1),
    feature<&SoundFeatures::abruptness>("abruptness", fixed, 1),
    feature<&SoundFeatures::rest>("rest", fixed, 2),
    feature<&SoundFeatures::kurtosis>("kurtosis", fixed, 1),
    feature<&SoundFeatures::crest>("crest factor", fixed, 1),
    ComparedFigure{"impulse_interval", "s", "impulse interval", milliseconds, 1, impulse_interval},
    ComparedFigure{"impulse_regularity", "1", "impulse regularity", fixed, 2, impulse_regularity},
};

}  // namespace

const Verdict* loudest_phase(const KnownContact& contact) {
    const Verdict* best = nullptr;
    for (const Verdict& verdict : contact.verdicts)
        if (best == nullptr || verdict.evidence.levels.joint.rms > best->evidence.levels.joint.rms) best = &verdict;
    return best;
}

std::span<const ComparedFigure> compared_figures() {
    return table;
}

std::string figure_text(const ComparedFigure& figure, const ComparedSound& sound) {
    const double value = figure.value(sound);
    if (std::isnan(value)) return "-";
    switch (figure.style) {
        case FigureStyle::percent:
            return fmt::format("{:.{}f} %", 100.0 * value, figure.digits);
        case FigureStyle::milliseconds:
            return fmt::format("{:.{}f} ms", 1e3 * value, figure.digits);
        case FigureStyle::fixed:
            break;
    }
    const std::string_view unit = figure.unit.empty() ? "dB" : figure.unit;
    return fmt::format("{:.{}f}{}{}", value, figure.digits, unit == "1" ? "" : " ", unit == "1" ? "" : unit);
}

}  // namespace stridor::classification
