#include "stridor/console/results/sound_text.hpp"

#include "stridor/base/text.hpp"
#include "stridor/console/results/text_table.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/hearing/run_sound.hpp"
#include "stridor/io/sound/listening_texts.hpp"
#include "stridor/signal/level.hpp"
#include "stridor/signal/spectrum.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cmath>

namespace stridor::console {

namespace {

using classification::RecordingVerdict;
using classification::SoundSegment;

std::string segment_reasons(const SoundSegment& segment) {
    std::string text =
        fmt::format("\n{:.3f} s to {:.3f} s, {}: {}\n", segment.from, segment.to,
                    classification::name(segment.verdict.category), fmt::join(segment.verdict.reasons, "; "));
    if (segment.impulse_interval > 0.0)
        text += fmt::format("    {} impulses, {:.1f} ms apart (median), intervals regular to {:.2f}\n",
                            segment.impulses.size(), 1e3 * segment.impulse_interval, segment.impulse_regularity);
    text += margin_lines(segment.verdict.margins, 20, 19);
    return text;
}

// long recordings have hundreds of segments: each category is explained by its loudest
std::string explanations(const RecordingVerdict& verdict) {
    std::string text;
    for (std::size_t k = 0; k < classification::category_names.size(); ++k) {
        const SoundSegment* loudest = nullptr;
        for (const SoundSegment& segment : verdict.segments)
            if (static_cast<std::size_t>(segment.verdict.category) == k &&
                (loudest == nullptr || segment.mean_square > loudest->mean_square))
                loudest = &segment;
        if (loudest != nullptr && !loudest->verdict.reasons.empty()) text += segment_reasons(*loudest);
    }
    return text;
}

using sound::SoundAnalysis;

double level_of(const SoundAnalysis& analysis, double mean_square) {
    return signal::level_of(mean_square, signal::reference_of(analysis.unit));
}

std::string levels_text(const SoundAnalysis& analysis) {
    return fmt::format("levels [{}]: mean {:.1f}, greatest fast {:.1f}, peak {:.1f} ({:.4g} {})\n",
                       signal::level_unit(analysis.unit), level_of(analysis, analysis.mean_square),
                       analysis.level.greatest, level_of(analysis, analysis.peak * analysis.peak), analysis.peak,
                       analysis.unit);
}

std::string weighted_text(const SoundAnalysis& analysis) {
    const signal::Spectrum weighted = signal::a_weighted(analysis.spectrum);
    std::string text = fmt::format("A-weighted: mean {:.1f} dB(A), loudest frame {:.1f} dB(A)\n",
                                   level_of(analysis, signal::mean_square_between(weighted, 0.0, 0.5 * analysis.rate)),
                                   level_of(analysis, analysis.greatest_weighted));
    if (analysis.unit != "Pa")
        text += "(the signal is no calibrated sound pressure: dB(A) re " + signal::level_unit(analysis.unit).substr(6) +
                ")\n";
    return text;
}

std::string peaks_text(const SoundAnalysis& analysis) {
    const auto peaks = signal::strongest_peaks(analysis.spectrum);
    if (peaks.empty()) return "no peak of the spectrum stands out by 10 dB\n";
    std::string text = "strongest peaks of the spectrum:\n";
    for (const signal::SpectrumPeak& peak : peaks)
        text += fmt::format("{:>11.1f} Hz{:>9.1f} dB{:>9.1f} dB above its surroundings\n", peak.frequency,
                            level_of(analysis, peak.mean_square), peak.prominence);
    return text;
}

// nominal frequency [Hz] and level [dB]
using BandLevel = std::pair<double, double>;

// four in a line
std::string bands_text(const std::vector<BandLevel>& bands) {
    std::string text;
    for (std::size_t k = 0; k < bands.size(); ++k)
        text += fmt::format("{:>8g} Hz{:>8.1f} dB{}", bands[k].first, bands[k].second,
                            k % 4 == 3 || k + 1 == bands.size() ? "\n" : "");
    return text;
}

std::vector<BandLevel> bands_of(const SoundAnalysis& analysis, signal::BandWidth width) {
    std::vector<BandLevel> bands;
    for (const signal::Band& band : signal::bands(analysis.spectrum, width))
        bands.emplace_back(band.nominal, level_of(analysis, band.mean_square));
    return bands;
}

// levels by filters, from 25 Hz to 12.5 kHz
std::vector<BandLevel> filtered_bands(const SoundAnalysis& analysis) {
    std::vector<BandLevel> bands;
    for (std::size_t k = 0; k < signal::third_octave_count && sound::holds_third_octave(analysis.rate, k); ++k)
        bands.emplace_back(signal::third_octave_names[k], level_of(analysis, analysis.quality->third_octaves[k]));
    return bands;
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
    std::string text = "bands of the field:\n";
    for (const signal::NamedBand& band : signal::named_bands)
        text += fmt::format("  {:<15}{:>8.1f} dB  {}\n", band.name,
                            level_of(analysis, signal::mean_square_between(analysis.spectrum, band.low, band.high)),
                            band.source);
    return text;
}

// why a channel has its unit
std::string origin(recordings::Calibration calibration, const recordings::FullScale& scale) {
    if (calibration == recordings::Calibration::file) return "";
    if (calibration == recordings::Calibration::none) return " (not calibrated)";
    constexpr std::array<std::string_view, 3> who{"--full-scale", "the sidecar", "its description"};
    return fmt::format(" (1 in the file is {:.6g} {}, says {})", scale.value, scale.unit,
                       who[static_cast<std::size_t>(calibration)]);
}

}  // namespace

std::string channel_title(const io::SoundReport& report, std::size_t channel) {
    const sound::SoundAnalysis& analysis = report.channels[channel];
    const bool is_only = report.channels.size() == 1;
    std::string text = is_only ? report.file : fmt::format("{}, channel {}", report.file, channel + 1);
    if (!analysis.name.empty()) text += " (" + analysis.name + ")";
    return text;
}

std::string segment_table(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict) {
    TextTable table{{right("from", 9), right("to", 10), left("  category", 12), right("level", 9),
                     right("frequency", 11), right("tonal", 9), right("regularity", 11), right("moves", 9),
                     right("rest", 7), right("kurtosis", 9)}};
    for (const classification::SoundSegment& segment : verdict.segments) {
        const sound::SoundFeatures& f = segment.verdict.features;
        const bool is_noisy = segment.verdict.category != classification::Category::none;
        add_row(table, fmt::format("{:.3f} s", segment.from), fmt::format("{:.3f} s", segment.to),
                "  " + styled(classification::name(segment.verdict.category), is_noisy ? Style::bold : Style::plain,
                              STDOUT_FILENO));
        std::vector<std::string>& row = table.rows.back();
        if (f.mean_square > 0.0)
            row.insert(row.end(), {fmt::format("{:.1f} dB", level_of(analysis, segment.mean_square)),
                                   fmt::format("{:.0f} Hz", f.frequency), fmt::format("{:.2f}", f.tonality),
                                   fmt::format("{:.3f}", f.regularity), fmt::format("{:.1f} %", 100.0 * f.movement),
                                   fmt::format("{:.2f}", f.rest), fmt::format("{:.1f}", f.kurtosis)});
        else
            row.push_back("  nothing stands out of the background");
    }
    return text_of(table);
}

std::string verdict_text(const io::SoundReport& report) {
    std::string text;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const RecordingVerdict& verdict = report.verdicts[k];
        text += fmt::format("{}{}: {} ({})\n\n", k > 0 ? "\n" : "", channel_title(report, k),
                            styled(classification::name(verdict.category), Style::bold, STDOUT_FILENO),
                            fmt::join(verdict.reasons, "; "));
        text += segment_table(report.channels[k], verdict) + explanations(verdict);
    }
    if (report.channels.size() == 1) return text;
    text += fmt::format("\nthe verdict rests on channel {}, the loudest: {}\n", report.loudest + 1,
                        classification::name(report.verdicts[report.loudest].category));
    for (const io::DifferingChannel& other : io::differing_channels(report))
        text += io::sentence_of(other) + "\n";
    return text;
}

namespace {

using CategoryCounts = std::array<std::size_t, classification::category_names.size()>;

// " creak 2 none 1"
std::string counts_text(const CategoryCounts& counts) {
    std::string text;
    for (std::size_t k = 0; k < counts.size(); ++k)
        if (counts[k] > 0) text += fmt::format(" {} {}", classification::category_names[k], counts[k]);
    return text;
}

// a line for each note, and what it is of
std::string notes_text(std::span<const io::ClassifiedRecording> rows) {
    std::map<std::string, std::vector<std::string>> files;
    for (const io::ClassifiedRecording& row : rows)
        for (const std::string& note : row.notes)
            files[note].push_back(row.file);
    std::string text;
    for (const auto& [note, of] : files)
        text += fmt::format("note, {}: {}\n",
                            of.size() == 1 ? of.front() : counted(of.size(), "recording", "recordings"), note);
    return text;
}

}  // namespace

std::string classified_text(std::span<const io::ClassifiedRecording> rows) {
    TextTable table{
        {left("file"), left("category"), right("probability"), right("level"), right("duration"), left("reason")}};
    CategoryCounts counts{};
    CategoryCounts others{};  // of channels that differ
    std::size_t refused = 0;
    for (const io::ClassifiedRecording& row : rows) {
        if (!row.refusal.empty()) {
            ++refused;
            add_row(table, row.file, "-", "-", "-", "-", "not heard: " + row.refusal);
            continue;
        }
        ++counts[static_cast<std::size_t>(row.category)];
        for (const io::DifferingChannel& other : row.others)
            ++others[static_cast<std::size_t>(other.category)];
        const bool is_noisy = row.category != classification::Category::none;
        add_row(table, row.file,
                styled(classification::name(row.category), is_noisy ? Style::bold : Style::plain, STDOUT_FILENO),
                row.probability > 0.0 ? fmt::format("{:.2f}", row.probability) : "-",
                fmt::format("{:.1f} {}", row.level, row.level_unit), fmt::format("{:.3g} s", row.duration),
                fmt::format("{}", fmt::join(row.reasons, "; ")));
    }
    std::string text = text_of(table) + "\n" + counted(rows.size(), "recording", "recordings") + ":";
    text += counts_text(counts);
    if (refused > 0) text += fmt::format(" not heard {}", refused);
    if (const std::string told = counts_text(others); !told.empty()) text += "; further channels differ:" + told;
    return text + "\n" + notes_text(rows);
}

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
        text += "\noctave bands:\n" + bands_text(bands_of(analysis, signal::BandWidth::octave));
        text += analysis.quality
                    ? "\nthird-octave bands (filters of IEC 61260-1):\n" + bands_text(filtered_bands(analysis))
                    : "\nthird-octave bands:\n" + bands_text(bands_of(analysis, signal::BandWidth::third_octave));
        text += "\n" + named_bands_text(analysis);
        text += "\n" + segment_table(analysis, report.verdicts[k]);
    }
    return text;
}

std::string signal_text(const io::SignalSummary& summary) {
    const signal::ChannelLayout& layout = summary.layout;
    const auto frames = static_cast<double>(*layout.frames);
    std::string text =
        fmt::format("{}\n  format    {}\n  rate      {} Hz\n  duration  {:.6g} s ({} frames)\n", summary.facts.name,
                    summary.facts.format, base::shortest(layout.rate), frames / layout.rate, *layout.frames);
    if (!summary.facts.time.empty()) text += fmt::format("  time      {}\n", summary.facts.time);
    for (std::size_t k = 0; k < layout.channels.size(); ++k) {
        const signal::Channel& channel = layout.channels[k];
        const std::string name = channel.name.empty() ? "" : " " + channel.name;
        text += fmt::format("  channel {}{}: peak {:.6g} {}", k + 1, name, summary.peaks[k], channel.unit);
        const bool is_converted =
            summary.facts.calibrations[k] == recordings::Calibration::file && summary.facts.full_scales[k].value != 1.0;
        if (is_converted) text += fmt::format(" (written in {})", summary.facts.units_in_file[k]);
        text += origin(summary.facts.calibrations[k], summary.facts.full_scales[k]) + "\n";
    }
    for (const std::string& each : summary.facts.left_out)
        text += fmt::format("  left out  {}\n", each);
    return text;
}

std::string listening_text(const io::SoundInfo& info) {
    const double loudest = info.peak < hearing::least_motion ? 0.0 : info.peak;
    std::string text = fmt::format("{}, {:g} s at {:g} Hz", io::motion_words(info), info.duration, info.rate);
    if (!info.cell.empty()) text += "; cell " + info.cell;
    text += fmt::format("\npeak {:.4g} {}, rms {:.4g} {}; full scale {:.4g} {} ({})\n", loudest, info.unit, info.rms,
                        info.unit, info.full_scale, info.unit, info.level);
    if (loudest == 0.0) text += "nothing vibrates in this part of the motion: the sound is silence\n";
    if (!info.file.empty()) text += info.file + "\n";
    return text;
}

}  // namespace stridor::console
