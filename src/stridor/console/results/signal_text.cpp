#include "stridor/console/results/signal_text.hpp"

#include "stridor/base/text.hpp"
#include "stridor/console/terminal.hpp"

#include <fmt/format.h>

namespace stridor::console {

namespace {

// why a channel has its unit
std::string origin(recordings::Calibration calibration, const recordings::FullScale& scale) {
    const std::string value = fmt::format(" (1 in the file is {:.6g} {}, says ", scale.value, scale.unit);
    switch (calibration) {
        case recordings::Calibration::option:
            return value + "--full-scale)";
        case recordings::Calibration::sidecar:
            return value + "the sidecar)";
        case recordings::Calibration::description:
            return value + "its description)";
        case recordings::Calibration::file:
            return "";
        case recordings::Calibration::none:
            return " (not calibrated)";
    }
    return "";
}

}  // namespace

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

}  // namespace stridor::console
