#include "stridor/io/sound/signal_report.hpp"

#include "stridor/base/version.hpp"
#include "stridor/io/json_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::io {

namespace {

using base::Json;

constexpr std::size_t block_frames = 1U << 14U;

Json channels_of(const SignalSummary& summary) {
    Json channels = Json::array();
    for (std::size_t k = 0; k < summary.layout.channels.size(); ++k) {
        const signal::Channel& channel = summary.layout.channels[k];
        channels.push_back({{"name", channel.name},
                            {"unit", channel.unit},
                            {"unit_in_file", base::text_or_null(summary.facts.units_in_file[k])},
                            {"full_scale", summary.facts.full_scales[k].value},
                            {"calibration", name(summary.facts.calibrations[k])},
                            {"peak", summary.peaks[k]}});
    }
    return channels;
}

}  // namespace

WatchedSource::WatchedSource(signal::Source& source) : source_(source), peaks_(source.layout().channels.size(), 0.0) {}

std::size_t WatchedSource::read(std::span<double> frames) {
    const std::size_t count = source_.read(frames);
    const std::size_t width = peaks_.size();
    for (std::size_t k = 0; k < count * width; ++k)
        peaks_[k % width] = std::max(peaks_[k % width], std::abs(frames[k]));
    frames_ += count;
    return count;
}

SignalSummary summary_of(recordings::SignalFile& file) {
    WatchedSource watched(file);
    std::vector<double> block(block_frames * watched.layout().channels.size());
    while (watched.read(block) > 0) {
    }
    SignalSummary summary{file.facts(), file.layout(), watched.peaks()};
    summary.layout.frames = watched.frames();
    return summary;
}

std::string_view name(recordings::Calibration calibration) {
    constexpr std::array<std::string_view, 5> names{"option", "sidecar", "description", "file", "none"};
    return names[static_cast<std::size_t>(calibration)];
}

std::string convert_json(const SignalSummary& summary, const std::optional<SignalOutput>& output) {
    const std::uint64_t frames = summary.layout.frames.value_or(0);
    Json document{{"schema", "stridor.convert/1"}, {"version", base::version()}, {"commit", base::commit()}};
    document["file"] = summary.facts.name;
    document["format"] = summary.facts.format;
    document["rate"] = summary.layout.rate;
    document["frames"] = frames;
    document["duration"] = static_cast<double>(frames) / summary.layout.rate;
    document["time"] = base::text_or_null(summary.facts.time);
    document["channels"] = channels_of(summary);
    document["left_out"] = summary.facts.left_out;
    document["notes"] = summary.facts.notes;
    document["metadata"] = Json::object();
    for (const auto& [key, value] : summary.facts.metadata)
        document["metadata"][key] = value;
    if (output) document["output"] = {{"file", output->name}, {"format", output->format}, {"clipped", output->clipped}};
    document["units"] = {{"rate", "Hz"}, {"duration", "s"}};
    return base::text_of(document);
}

}  // namespace stridor::io
