// WAV files without libsndfile: the same samples as it gives, of the codings that recorders write.

#include "stridor/recordings/audio/audio.hpp"
#include "stridor/recordings/audio/riff.hpp"
#include "stridor/signal/source.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::recordings {

namespace {

constexpr std::uint16_t whole_numbers = 1, floats = 3, extensible = 0xFFFE;

class WavSamplesInMemory final : public signal::Source {
public:
    WavSamplesInMemory(std::shared_ptr<const Bytes> bytes, const RiffData& data)
        : bytes_(std::move(bytes)),
          data_(data),
          left_(std::min(data.available, data.has_unknown_length() ? data.available : data.claimed) /
                data.frame_bytes) {
        layout_.rate = data.rate;
        layout_.frames = left_;
        layout_.channels.assign(data.channels, {"", ""});
    }

    const signal::ChannelLayout& layout() const override { return layout_; }

    std::size_t read(std::span<double> frames) override {
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(frames.size() / data_.channels, left_));
        const std::string text = text_at(*bytes_, data_.offset + done_ * data_.frame_bytes, count * data_.frame_bytes);
        const std::size_t width = data_.frame_bytes / data_.channels;
        for (std::size_t k = 0; k < count * data_.channels; ++k)
            frames[k] = sample(text.data() + k * width, width);
        done_ += count;
        left_ -= count;
        return count;
    }

private:
    // divided by the largest magnitude that a whole number can have; 8 bits have no sign
    double sample(const char* from, std::size_t width) const {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < width; ++k)
            bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(from[k])) << (8 * k);
        if (data_.coding == floats)
            return width == 4 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits)) : std::bit_cast<double>(bits);
        if (data_.bits == 8) return (static_cast<double>(bits) - 128.0) / 128.0;
        const unsigned used = data_.bits;
        const auto number = static_cast<std::int64_t>(bits << (64U - used)) >> (64U - used);
        return static_cast<double>(number) / static_cast<double>(std::uint64_t{1} << (used - 1U));
    }

    std::shared_ptr<const Bytes> bytes_;
    RiffData data_;
    std::uint64_t left_;
    std::uint64_t done_ = 0;
    signal::ChannelLayout layout_;
};

// the text that begins the bext chunk
std::string description_in(const std::string& chunks) {
    constexpr std::size_t length = 256;
    const std::size_t at = chunks.find("bext");
    if (at == chunks.npos || chunks.size() < at + 8) return "";
    const std::string text = chunks.substr(at + 8, length);
    return text.substr(0, text.find('\0'));
}

RiffData checked(const SignalInput& input) {
    std::optional<RiffData> data = find_riff_data(*input.bytes);
    if (!data || !data->has_format || data->channels == 0 || data->rate == 0 || data->available == 0)
        throw refusal(input.name, "this is no whole WAV file", "its header or its samples are missing",
                      "Write it anew, or use stridor analyse.");
    if (!data->has_unknown_length() && data->claimed > data->available)
        throw refusal(input.name, "the WAV file is cut off",
                      "its header speaks of " + std::to_string(data->claimed) + " bytes of samples, " +
                          std::to_string(data->available) + " are there");
    // what an extensible format holds stands behind: 16 bytes of the chunk's size, then the coding
    if (data->coding == extensible) {
        const std::size_t at = data->kept.find("fmt ");
        data->coding = at != data->kept.npos && data->kept.size() > at + 33
                           ? static_cast<std::uint16_t>(static_cast<unsigned char>(data->kept[at + 32]))
                           : std::uint16_t{0};
    }
    const bool is_whole = data->coding == whole_numbers && data->bits % 8 == 0 && data->bits <= 32;
    const bool is_float = data->coding == floats && (data->bits == 32 || data->bits == 64);
    if ((!is_whole && !is_float) || !data->has_sensible_frames())
        throw refusal(input.name, "the page does not read this coding of WAV files", "it is packed, or not usual",
                      "Write 16, 24 or 32 bits, or use stridor analyse.");
    return *data;
}

}  // namespace

bool is_audio(std::string_view beginning) {
    return is_riff_mark(beginning.substr(0, 4));
}

RawSignal open_audio(const SignalInput& input) {
    RiffData data = checked(input);
    RawSignal raw;
    std::shared_ptr<const Bytes> bytes = input.bytes;
    if (data.has_wide_frames()) {
        bytes = plain_wav(bytes, data);
        data = checked({bytes, input.name, {}});
    }
    raw.format = "WAV";
    raw.description = description_in(data.kept);
    if (data.coding == floats) raw.doubt = Doubt::numbers;
    raw.source = std::make_unique<WavSamplesInMemory>(std::move(bytes), data);
    return raw;
}

}  // namespace stridor::recordings
