#include "stridor/console/results/verdict_text.hpp"

#include "stridor/console/terminal.hpp"
#include "stridor/signal/level.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>

namespace stridor::console {

namespace {

using classification::RecordingVerdict;
using classification::SoundSegment;

std::string joined(const std::vector<std::string>& reasons) {
    std::string text;
    for (std::size_t k = 0; k < reasons.size(); ++k)
        text += (k > 0 ? "; " : "") + reasons[k];
    return text;
}

std::string segment_reasons(const SoundSegment& segment) {
    std::string text = fmt::format("\n{:.3f} s to {:.3f} s, {}: {}\n", segment.from, segment.to,
                                   classification::name(segment.verdict.category), joined(segment.verdict.reasons));
    if (segment.impulse_interval > 0.0)
        text += fmt::format("    {} impulses, {:.1f} ms apart (median), intervals regular to {:.2f}\n",
                            segment.impulses.size(), 1e3 * segment.impulse_interval, segment.impulse_regularity);
    for (const classification::Margin& margin : segment.verdict.margins)
        if (std::isfinite(margin.figure))
            text += styled(
                fmt::format("    {:<20} {:>9.4g}  threshold {:<19} {:>7.4g}  distance {:+.4g}\n", margin.figure_name,
                            margin.figure, margin.threshold_name, margin.threshold, margin.distance),
                Style::dim, STDOUT_FILENO);
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
        if (loudest != nullptr) text += segment_reasons(*loudest);
    }
    return text;
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
    const double reference = signal::reference_of(analysis.unit);
    std::string text =
        fmt::format("{:>9}{:>10}  {:<10}{:>9}{:>11}{:>9}{:>11}{:>9}{:>7}{:>9}\n", "from", "to", "category", "level",
                    "frequency", "tonal", "regularity", "moves", "rest", "kurtosis");
    for (const classification::SoundSegment& segment : verdict.segments) {
        const sound::SoundFeatures& f = segment.verdict.features;
        const bool is_noisy = segment.verdict.category != classification::Category::none;
        const std::string category = styled(fmt::format("{:<10}", classification::name(segment.verdict.category)),
                                            is_noisy ? Style::bold : Style::plain, STDOUT_FILENO);
        text += fmt::format("{:>7.3f} s{:>8.3f} s  {}", segment.from, segment.to, category);
        if (f.mean_square > 0.0)
            text += fmt::format("{:>6.1f} dB{:>8.0f} Hz{:>9.2f}{:>11.3f}{:>7.1f} %{:>7.2f}{:>9.1f}\n",
                                signal::level_of(segment.mean_square, reference), f.frequency, f.tonality, f.regularity,
                                100.0 * f.movement, f.rest, f.kurtosis);
        else
            text += "  silence\n";
    }
    return text;
}

std::string verdict_text(const io::SoundReport& report) {
    std::string text;
    for (std::size_t k = 0; k < report.channels.size(); ++k) {
        const RecordingVerdict& verdict = report.verdicts[k];
        text += (k > 0 ? "\n" : "") + channel_title(report, k) + ": " +
                styled(std::string(classification::name(verdict.category)), Style::bold, STDOUT_FILENO) + " (" +
                joined(verdict.reasons) + ")\n\n";
        text += segment_table(report.channels[k], verdict) + explanations(verdict);
    }
    if (report.channels.size() > 1)
        text += fmt::format("\nthe loudest channel is {}: {}\n", report.loudest + 1,
                            classification::name(report.verdicts[report.loudest].category));
    return text;
}

}  // namespace stridor::console
