#include "commands.hpp"
#include "sound_options.hpp"
#include "terminal.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <memory>

namespace stridor::app {

namespace {

using classification::RecordingVerdict;
using classification::SoundSegment;

struct ClassifyOptions {
    SoundOptions input;
    bool json = false;
};

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

std::string report_text(const io::SoundReport& report) {
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

void classify(const ClassifyOptions& options) {
    const io::SoundReport report = listen_to(options.input);
    print(options.json ? io::classify_json(report) + "\n" : report_text(report));
}

}  // namespace

void add_classify(CLI::App& program) {
    auto options = std::make_shared<ClassifyOptions>();
    CLI::App* command = program.add_subcommand(
        "classify", "Hear whether a recording squeals, squeaks, creaks or is quiet, part by part and as a whole.");
    add_sound_options(*command, options->input);
    command->add_flag("--json", options->json, "print one JSON document (schema stridor.classify/1)");
    std::string names;
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        names +=
            fmt::format("\n  {:<20} {:>6g} {:<5} {}", threshold.name, parameters::SoundThresholds{}.*(threshold.member),
                        threshold.unit == "1" ? "" : threshold.unit, threshold.sentence);
    command->footer(
        "Examples:\n  stridor classify squeak.wav\n  stridor classify rig.uff --channel 2 --json\n"
        "  stridor classify door.flac --set squeal_regularity=0.7\n\nThresholds for --set:" +
        names);
    command->callback([options] { classify(*options); });
}

}  // namespace stridor::app
