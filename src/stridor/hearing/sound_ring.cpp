#include "stridor/hearing/sound_ring.hpp"

#include "stridor/base/check.hpp"

#include <algorithm>
#include <utility>

namespace stridor::hearing {

namespace {

class RingPart final : public signal::Source {
public:
    RingPart(signal::ChannelLayout layout, std::vector<float> samples)
        : layout_(std::move(layout)),
          samples_(std::move(samples)) {
        layout_.frames = samples_.size() / layout_.channels.size();
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const std::size_t count = std::min(frames.size(), samples_.size() - next_);
        for (std::size_t k = 0; k < count; ++k)
            frames[k] = static_cast<double>(samples_[next_ + k]);
        next_ += count;
        return count / layout_.channels.size();
    }

private:
    signal::ChannelLayout layout_;
    std::vector<float> samples_;
    std::size_t next_ = 0;
};

}  // namespace

SoundRing::SoundRing(std::size_t channels, std::size_t frames) : channels_(channels), frames_(frames) {}

void SoundRing::push(std::span<const double> frames) {
    const std::size_t whole = channels_ * frames_;
    std::size_t place = static_cast<std::size_t>(end_ % frames_) * channels_;
    for (const double x : frames) {
        if (place == samples_.size() && samples_.size() < whole)
            samples_.push_back(static_cast<float>(x));
        else
            samples_[place] = static_cast<float>(x);
        if (++place == whole) place = 0;
    }
    end_ += frames.size() / channels_;
}

std::uint64_t SoundRing::begin() const {
    return end_ > frames_ ? end_ - frames_ : 0;
}

std::unique_ptr<signal::Source> SoundRing::part(const signal::ChannelLayout& layout, std::uint64_t from,
                                                std::uint64_t to) const {
    STRIDOR_EXPECT(from >= begin() && from <= to && to <= end_);
    std::vector<float> samples;
    samples.reserve(static_cast<std::size_t>(to - from) * channels_);
    for (std::uint64_t frame = from; frame < to; ++frame) {
        const auto place = static_cast<std::ptrdiff_t>(static_cast<std::size_t>(frame % frames_) * channels_);
        samples.insert(samples.end(), samples_.begin() + place,
                       samples_.begin() + place + static_cast<std::ptrdiff_t>(channels_));
    }
    return std::make_unique<RingPart>(layout, std::move(samples));
}

}  // namespace stridor::hearing
