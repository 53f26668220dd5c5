#include "stridor/recordings/raw_signal.hpp"

#include "stridor/base/text.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stridor::recordings {

namespace {

constexpr std::uint64_t fewest_counted = 32;  // [1] fewer numbers may rise so by chance

/// What is known of a channel as far as it was read.
struct Survey {
    std::optional<double> step{};
    double last = 0.0;
    bool is_counter = true;
    ChannelFault fault{};
};

void take(Survey& survey, double value, std::uint64_t number) {
    if (survey.fault.why.empty() && !signal::is_sample(value))
        survey.fault = {FaultKind::no_samples, "is " + base::shortest(value) + " in sample " + std::to_string(number)};
    if (!survey.is_counter) return;
    survey.is_counter = value == std::round(value);
    if (number > 1) {
        const double step = value - survey.last;
        survey.is_counter = survey.is_counter && step > 0.0 && survey.step.value_or(step) == step;
        survey.step = step;
    }
    survey.last = value;
}

}  // namespace

std::vector<ChannelFault> channel_faults(signal::Source& source) {
    constexpr std::size_t block_frames = 4096;
    const std::size_t width = source.layout().channels.size();
    std::vector<Survey> surveys(width);
    std::vector<double> block(block_frames * width);
    std::uint64_t frames = 0;
    while (const std::size_t count = source.read(block)) {
        for (std::size_t k = 0; k < count * width; ++k)
            take(surveys[k % width], block[k], frames + k / width + 1);
        frames += count;
    }
    std::vector<ChannelFault> faults;
    for (const Survey& survey : surveys)
        faults.push_back(
            survey.is_counter && frames >= fewest_counted
                ? ChannelFault{FaultKind::counter, "grows by the same step in every sample, as a counter does"}
                : survey.fault);
    return faults;
}

}  // namespace stridor::recordings
