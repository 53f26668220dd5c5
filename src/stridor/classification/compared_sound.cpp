#include "stridor/classification/compared_sound.hpp"

#include "stridor/signal/level.hpp"

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

constexpr std::array table{
    ComparedFigure{"slip", "1", "slip", percent, 1, rate<&analysis::Rates::slip>},
    ComparedFigure{"stick", "1", "stick", percent, 1, rate<&analysis::Rates::stick>},
    ComparedFigure{"separation", "1", "separation", percent, 1, rate<&analysis::Rates::separation>},
    ComparedFigure{"contact_regularity", "1", "regularity of the states", fixed, 3, contact_regularity},
    ComparedFigure{"contact_frequency", "Hz", "frequency of the states", fixed, 0, contact_frequency},
    ComparedFigure{"level", "", "level", fixed, 1, level},
    ComparedFigure{"clearness", "dB", "clearness", fixed, 1, of_sound<&SoundFeatures::clearness>},
    ComparedFigure{"frequency", "Hz", "dominant frequency", fixed, 0, if_any<&SoundFeatures::frequency>},
    ComparedFigure{"prominence", "dB", "prominence", fixed, 1, of_sound<&SoundFeatures::prominence>},
    ComparedFigure{"tonality", "1", "tonality", fixed, 2, of_sound<&SoundFeatures::tonality>},
    ComparedFigure{"regularity", "1", "regularity", fixed, 3, of_sound<&SoundFeatures::regularity>},
    ComparedFigure{"repetition_frequency", "Hz", "best cycle", fixed, 0, if_any<&SoundFeatures::repetition_frequency>},
    ComparedFigure{"repetition", "1", "likeness of cycles", fixed, 3, of_sound<&SoundFeatures::repetition>},
    ComparedFigure{"movement", "1", "movement", percent, 1, of_sound<&SoundFeatures::movement>},
    ComparedFigure{"unsteadiness", "dB", "unsteadiness", fixed, 1, of_sound<&SoundFeatures::unsteadiness>},
    ComparedFigure{"abruptness", "dB", "abruptness", fixed, 1, of_sound<&SoundFeatures::abruptness>},
    ComparedFigure{"rest", "1", "rest", fixed, 2, of_sound<&SoundFeatures::rest>},
    ComparedFigure{"kurtosis", "1", "kurtosis", fixed, 1, of_sound<&SoundFeatures::kurtosis>},
    ComparedFigure{"crest", "1", "crest factor", fixed, 1, of_sound<&SoundFeatures::crest>},
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
