#include "commands.hpp"
#include "figures.hpp"
#include "sound_options.hpp"
#include "stridor/figures/sound.hpp"
#include "stridor/signal/bands.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <memory>

namespace stridor::app {

namespace {

using sound::SoundAnalysis;

struct AnalyseOptions {
    SoundOptions input;
    std::string figure;
    std::string field = "free";
    bool json = false;
    bool weighted = false;
};

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

std::string quality_text(const SoundAnalysis& analysis) {
    if (!analysis.quality)
        return analysis.unit == signal::full_scale
                   ? "no loudness, no sharpness: the recording is not calibrated (--full-scale \"2 Pa\")\n"
                   : "";
    const sound::SoundQuality& q = *analysis.quality;
    return fmt::format(
        "loudness in a {} field (ISO 532-1): N5 {:.3g} sone, N10 {:.3g} sone, greatest {:.3g} sone; "
        "of the mean spectrum {:.3g} sone ({:.1f} phon)\nsharpness (DIN 45692): {:.3g} acum\n",
        sound::sound_field_names[static_cast<std::size_t>(q.field)], q.loudness_5, q.loudness_10, q.greatest_loudness,
        q.loudness, sound::loudness_level(q.loudness), q.sharpness);
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

std::string report_text(const io::SoundReport& report, const AnalyseOptions& options) {
    std::string text;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const SoundAnalysis& analysis = report.channels[k];
        text += (k > 0 ? "\n" : "") + styled(channel_title(report, k), Style::bold, STDOUT_FILENO) + "\n";
        text += fmt::format("{}, {:.6g} s at {:g} Hz\n", report.format, analysis.duration, analysis.rate);
        text += levels_text(analysis);
        if (analysis.unit == "Pa" || options.weighted) text += weighted_text(analysis);
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

void analyse(const AnalyseOptions& options) {
    const auto field = options.field == "diffuse" ? sound::SoundField::diffuse : sound::SoundField::free;
    const io::SoundReport report = listen_to(options.input, field);
    if (!options.figure.empty()) {
        drawing::Scene scene = figures::sound(report.channels[report.loudest], report.verdicts[report.loudest]);
        scene.title = drawing::Text(channel_title(report, report.loudest));
        draw(scene, options.figure);
    }
    print(options.json ? io::analyse_json(report) + "\n" : report_text(report, options));
    if (!options.json && has_terminal())
        say(styled("next: stridor classify " + options.input.file, Style::dim, STDERR_FILENO));
}

}  // namespace

void add_analyse(CLI::App& program) {
    auto options = std::make_shared<AnalyseOptions>();
    CLI::App* command = program.add_subcommand(
        "analyse",
        "Level over time, spectrum, bands, loudness and features of a recording, and a figure with its spectrogram.");
    add_sound_options(*command, options->input);
    command->add_flag("--a-weighting", options->weighted, "A-weighted levels even where the unit is not Pa");
    command
        ->add_option("--field", options->field,
                     "how a sound in Pa comes to the listener, for its loudness and sharpness")
        ->check(CLI::IsMember({"free", "diffuse"}))
        ->capture_default_str();
    command
        ->add_option("--figure", options->figure,
                     "draw waveform, level, spectrogram and segments to FILE.png, FILE.svg or FILE.pdf")
        ->type_name("FILE");
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.analyse/1)");
    command->footer(
        "Examples:\n  stridor analyse squeak.wav\n  stridor analyse squeak.wav --full-scale \"2 Pa\" --figure "
        "squeak.png\n"
        "  stridor analyse rig.uff --channel 1 --json");
    command->callback([options] { analyse(*options); });
}

}  // namespace stridor::app
