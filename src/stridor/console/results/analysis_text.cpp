#include "stridor/console/results/analysis_text.hpp"

#include "stridor/console/results/verdict_text.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/signal/bands.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace stridor::console {

namespace {

using sound::SoundAnalysis;

std::string levels_text(const SoundAnalysis& analysis) {
    const double reference = signal::reference_of(analysis.unit);
    return fmt::format("levels [{}]: mean {:.1f}, greatest fast {:.1f}, peak {:.1f} ({:.4g} {})\n",
                       signal::level_unit(analysis.unit), signal::level_of(analysis.mean_square, reference),
                       analysis.level.greatest, signal::level_of(analysis.peak * analysis.peak, reference),
                       analysis.peak, analysis.unit);
}

std::string weighted_text(const SoundAnalysis& analysis) {
    const double reference = signal::reference_of(analysis.unit);
    const signal::Spectrum weighted = signal::a_weighted(analysis.spectrum);
    std::string text =
        fmt::format("A-weighted: mean {:.1f} dB(A), loudest frame {:.1f} dB(A)\n",
                    signal::level_of(signal::mean_square_between(weighted, 0.0, 0.5 * analysis.rate), reference),
                    signal::level_of(analysis.greatest_weighted, reference));
    if (analysis.unit != "Pa")
        text += "(the signal is no calibrated sound pressure: dB(A) re " + signal::level_unit(analysis.unit).substr(6) +
                ")\n";
    return text;
}

std::string peaks_text(const SoundAnalysis& analysis) {
    const auto peaks = signal::strongest_peaks(analysis.spectrum);
    if (peaks.empty()) return "no peak of the spectrum stands out by 10 dB\n";
    const double reference = signal::reference_of(analysis.unit);
    std::string text = "strongest peaks of the spectrum:\n";
    for (const signal::SpectrumPeak& peak : peaks)
        text += fmt::format("{:>11.1f} Hz{:>9.1f} dB{:>9.1f} dB above its surroundings\n", peak.frequency,
                            signal::level_of(peak.mean_square, reference), peak.prominence);
    return text;
}

std::string bands_text(const SoundAnalysis& analysis, signal::BandWidth width) {
    const double reference = signal::reference_of(analysis.unit);
    std::string text;
    std::size_t count = 0;
    for (const signal::Band& band : signal::bands(analysis.spectrum, width)) {
        text += fmt::format("{:>8g} Hz{:>8.1f} dB", band.nominal, signal::level_of(band.mean_square, reference));
        if (++count % 4 == 0) text += "\n";
    }
    if (count % 4 != 0) text += "\n";
    return text;
}

// levels by filters, from 25 Hz to 12.5 kHz
std::string filtered_bands_text(const SoundAnalysis& analysis) {
    const double reference = signal::reference_of(analysis.unit);
    std::string text;
    std::size_t count = 0;
    for (std::size_t k = 0; k < signal::third_octave_count; ++k) {
        if (!sound::holds_third_octave(analysis.rate, k)) break;
        text += fmt::format("{:>8g} Hz{:>8.1f} dB", signal::third_octave_names[k],
                            signal::level_of(analysis.quality->third_octaves[k], reference));
        if (++count % 4 == 0) text += "\n";
    }
    if (count % 4 != 0) text += "\n";
    return text;
}

std::string roughness_text(const sound::SoundQuality& q) {
    if (std::isnan(q.roughness)) return "no roughness: the recording is shorter than 0.2 s\n";
    return fmt::format("roughness (Daniel and Weber): {:.2f} asper, R5 {:.2f} asper\n", q.roughness, q.roughness_5);
}

std::string quality_text(const SoundAnalysis& analysis) {
    if (!analysis.quality)
        return analysis.unit == signal::full_scale
                   ? "no loudness, sharpness, roughness: the recording is not calibrated (--full-scale \"2 Pa\")\n"
                   : "";
    const sound::SoundQuality& q = *analysis.quality;
    return fmt::format(
        "loudness in a {} field (ISO 532-1): N5 {:.3g} sone, N10 {:.3g} sone, greatest {:.3g} sone; "
        "of the mean spectrum {:.3g} sone ({:.1f} phon)\nsharpness (DIN 45692): {:.3g} acum\n{}",
        sound::sound_field_names[static_cast<std::size_t>(q.field)], q.loudness_5, q.loudness_10, q.greatest_loudness,
        q.loudness, sound::loudness_level(q.loudness), q.sharpness, roughness_text(q));
}

std::string named_bands_text(const SoundAnalysis& analysis) {
    const double reference = signal::reference_of(analysis.unit);
    std::string text = "bands of the field:\n";
    for (const signal::NamedBand& band : signal::named_bands)
        text += fmt::format(
            "  {:<15}{:>8.1f} dB  {}\n", band.name,
            signal::level_of(signal::mean_square_between(analysis.spectrum, band.low, band.high), reference),
            band.source);
    return text;
}

}  // namespace

std::string analysis_text(const io::SoundReport& report, Weighting weighting) {
    std::string text;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const SoundAnalysis& analysis = report.channels[k];
        text += (k > 0 ? "\n" : "") + styled(channel_title(report, k), Style::bold, STDOUT_FILENO) + "\n";
        text += fmt::format("{}, {:.6g} s at {:g} Hz\n", report.format, analysis.duration, analysis.rate);
        text += levels_text(analysis);
        if (analysis.unit == "Pa" || weighting == Weighting::of_all) text += weighted_text(analysis);
        text += quality_text(analysis);
        text += "\n" + peaks_text(analysis);
        text += "\noctave bands:\n" + bands_text(analysis, signal::BandWidth::octave);
        text += analysis.quality ? "\nthird-octave bands (filters of IEC 61260-1):\n" + filtered_bands_text(analysis)
                                 : "\nthird-octave bands:\n" + bands_text(analysis, signal::BandWidth::third_octave);
        text += "\n" + named_bands_text(analysis);
        text += "\n" + segment_table(analysis, report.verdicts[k]);
    }
    return text;
}

}  // namespace stridor::console
