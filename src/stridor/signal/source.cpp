#include "stridor/signal/source.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::signal {

namespace {

// frames that are moved at a time
constexpr std::size_t block_frames = 1U << 14U;

class InMemory final : public Source {
public:
    explicit InMemory(std::vector<Signal> channels) : channels_(std::move(channels)) {
        layout_.rate = channels_.front().rate;
        layout_.frames = channels_.front().samples.size();
        for (const Signal& channel : channels_) {
            STRIDOR_EXPECT(channel.rate == layout_.rate && channel.samples.size() == *layout_.frames);
            layout_.channels.push_back({"", channel.unit});
        }
    }

    const ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t width = channels_.size();
        STRIDOR_EXPECT(frames.size() % width == 0);
        const std::size_t count = std::min<std::size_t>(frames.size() / width, *layout_.frames - next_);
        for (std::size_t frame = 0; frame < count; ++frame)
            for (std::size_t channel = 0; channel < width; ++channel)
                frames[frame * width + channel] = channels_[channel].samples[next_ + frame];
        next_ += count;
        return count;
    }

private:
    std::vector<Signal> channels_;
    ChannelLayout layout_;
    std::size_t next_ = 0;
};

// so much of a name is told again; nobody knows a longer one by heart
constexpr std::size_t longest_told = 60;

std::string told(std::string_view name) {
    if (base::character_count(name) <= longest_told) return std::string(name);
    std::size_t end = longest_told;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U)  // not within a character
        --end;
    return std::string(name.substr(0, end)) + "...";
}

}  // namespace

base::Problem sample_problem(double value, const Channel& channel, std::uint64_t number) {
    std::string what = "sample " + std::to_string(number);
    if (!channel.name.empty()) what += " of the channel \"" + channel.name + "\"";
    what += " is " + base::shortest(value);
    if (!std::isfinite(value))
        return {std::move(what), "a recording has finite samples only",
                "Was it written by another program with an error?"};
    return {what + " " + channel.unit, "nothing that is measured exceeds " + base::shortest(largest_sample),
            "Is the file damaged, or its calibration wrong?"};
}

std::vector<Signal> read_all(Source& source, std::uint64_t limit) {
    const ChannelLayout& layout = source.layout();
    const std::size_t width = layout.channels.size();
    std::vector<Signal> channels(width);
    for (std::size_t channel = 0; channel < width; ++channel)
        channels[channel] = {layout.rate, layout.channels[channel].unit, {}};

    std::vector<double> block(block_frames * width);
    std::uint64_t held = 0;
    while (const std::size_t count = source.read(block)) {
        held += count * width;
        if (held > limit)
            throw Error(ErrorKind::input, {"the recording is too long to be held as a whole",
                                           "it has more than " + std::to_string(limit) + " samples", "Cut it?"});
        for (std::size_t channel = 0; channel < width; ++channel)
            for (std::size_t frame = 0; frame < count; ++frame)
                channels[channel].samples.push_back(block[frame * width + channel]);
    }
    return channels;
}

std::unique_ptr<Source> source_of(std::vector<Signal> channels) {
    STRIDOR_EXPECT(!channels.empty());
    return std::make_unique<InMemory>(std::move(channels));
}

std::size_t channel_named(const ChannelLayout& layout, std::string_view name) {
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (!name.empty() && layout.channels[k].name == name) return k;
    for (std::size_t k = 0; k < layout.channels.size(); ++k)
        if (std::to_string(k + 1) == name) return k;
    throw Error(ErrorKind::input,
                {"there is no channel \"" + told(name) + "\"", "the recording has " + channel_list(layout),
                 "Give its name, or its number from 1."});
}

std::string channel_list(const ChannelLayout& layout) {
    std::string text;
    for (std::size_t k = 0; k < layout.channels.size(); ++k) {
        const Channel& channel = layout.channels[k];
        const std::string name = channel.name.empty() ? "" : " \"" + channel.name + "\"";
        text += (k > 0 ? ", " : "") + std::to_string(k + 1) + name + " [" + channel.unit + "]";
    }
    return text;
}

}  // namespace stridor::signal
