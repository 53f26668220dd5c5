#include "stridor/recordings/audio/riff.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace stridor::recordings {

namespace {

std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = bytes.size(); k-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[k]);
    return value;
}

std::string four_bytes(std::uint64_t value) {
    std::string text;
    for (unsigned shift = 0; shift < 32; shift += 8)
        text += static_cast<char>(value >> shift & 0xFFU);
    return text;
}

constexpr std::uint64_t largest_32 = 0xFFFFFFFFU;
constexpr int most_chunks = 1000;                  // before the samples; a file with more is no recording
constexpr std::uint64_t longest_kept = 1U << 20U;  // [bytes] of a chunk

/// A head of its own before a part of other bytes.
class Rehead final : public Bytes {
public:
    /// `is_raised`: of every four bytes the last is dropped, and a zero comes before the others.
    Rehead(std::string head, std::shared_ptr<const Bytes> bytes, std::uint64_t offset, std::uint64_t length,
           bool is_raised)
        : head_(std::move(head)),
          bytes_(std::move(bytes)),
          offset_(offset),
          length_(length),
          is_raised_(is_raised) {}

    std::uint64_t size() const override { return head_.size() + length_; }

    std::size_t read_at(std::uint64_t offset, std::span<char> into) const override {
        std::size_t done = 0;
        if (offset < head_.size()) {
            const auto from = static_cast<std::size_t>(offset);
            done = std::min(into.size(), head_.size() - from);
            std::copy_n(head_.begin() + static_cast<std::ptrdiff_t>(from), done, into.begin());
        }
        const std::uint64_t place = offset + done - head_.size();
        if (done == into.size() || place >= length_) return done;
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(into.size() - done, length_ - place));
        const std::span<char> samples = into.subspan(done, wanted);
        const std::size_t count = bytes_->read_at(offset_ + place - (is_raised_ ? 1 : 0), samples);
        for (std::size_t k = 0; is_raised_ && k < count; ++k)
            if ((place + k) % 4 == 0) samples[k] = '\0';
        return done + count;
    }

private:
    std::string head_;
    std::shared_ptr<const Bytes> bytes_;
    std::uint64_t offset_;
    std::uint64_t length_;
    bool is_raised_;
};

// Do the 24 bits stand in the lower three bytes, the fourth being their sign? Else they stand in the upper three.
bool stand_low(const Bytes& bytes, const RiffData& data) {
    const std::string samples = text_at(bytes, data.offset, 1U << 20U);
    bool is_sign_everywhere = true;
    bool has_low_byte = false;
    for (std::size_t k = 0; k + 4 <= samples.size(); k += 4) {
        const char sign = (static_cast<unsigned char>(samples[k + 2]) & 0x80U) != 0 ? '\xFF' : '\0';
        is_sign_everywhere = is_sign_everywhere && (samples[k + 3] == sign || samples[k + 3] == '\0');
        has_low_byte = has_low_byte || samples[k] != '\0';
    }
    return is_sign_everywhere && has_low_byte;
}

// an empty data chunk: what follows is one of those that stand behind samples, and fits the file
bool is_chunk_behind(const Bytes& bytes, std::uint64_t offset) {
    constexpr std::array<std::string_view, 14> names{"LIST", "bext", "iXML", "fact", "cue ", "id3 ", "ID3 ",
                                                     "smpl", "PEAK", "JUNK", "junk", "FLLR", "PAD ", "axml"};
    const std::string header = text_at(bytes, offset, 8);
    if (header.size() < 8 || std::find(names.begin(), names.end(), header.substr(0, 4)) == names.end()) return false;
    return little_endian(header.substr(4)) <= bytes.size() - offset - 8;
}

}  // namespace

bool RiffData::has_unknown_length() const {
    // sox writes the whole frames in 0x7FFFF000, ffmpeg and others 0xFFFFFFFF
    return claimed == 0 || claimed + frame_bytes > 0x7FFFF000U;
}

bool RiffData::has_wide_frames() const {
    return (coding == 1 || coding == 0xFFFE) && bits == 24 && frame_bytes == 4 * channels;
}

bool RiffData::has_sensible_frames() const {
    const bool is_plain = coding == 1 || coding == 3;
    return !is_plain || has_wide_frames() || (bits >= 8 && bits <= 64 && frame_bytes == channels * ((bits + 7) / 8));
}

bool is_riff_mark(std::string_view mark) {
    return mark == "RIFF" || mark == "RF64" || mark == "BW64";
}

std::optional<RiffData> find_riff_data(const Bytes& bytes) {
    RiffData data;
    std::optional<std::uint64_t> long_size;  // RF64
    std::uint64_t offset = 12;
    for (int chunk = 0; chunk < most_chunks && offset + 8 <= bytes.size(); ++chunk) {
        const std::string header = text_at(bytes, offset, 8 + 24);
        if (header.size() < 8) return std::nullopt;
        const std::string_view name = std::string_view(header).substr(0, 4);
        const std::uint64_t size = little_endian(std::string_view(header).substr(4, 4));
        const std::string_view content = std::string_view(header).substr(8);
        if (name == "fmt " && size >= 16 && content.size() >= 16) {
            data.has_format = true;
            data.coding = static_cast<std::uint16_t>(little_endian(content.substr(0, 2)));
            data.bits = static_cast<std::uint16_t>(little_endian(content.substr(14, 2)));
            data.channels = static_cast<std::uint16_t>(little_endian(content.substr(2, 2)));
            data.rate = static_cast<std::uint32_t>(little_endian(content.substr(4, 4)));
            data.frame_bytes = static_cast<std::uint16_t>(little_endian(content.substr(12, 2)));
        }
        const bool is_kept = (name == "fmt " || name == "bext") && size <= longest_kept;
        if (is_kept) data.kept += text_at(bytes, offset, 8 + static_cast<std::size_t>(size + size % 2));
        if (name == "ds64" && content.size() >= 16) long_size = little_endian(content.substr(8, 8));
        if (name == "data") {
            data.offset = offset + 8;
            data.claimed = size == largest_32 && long_size ? *long_size : size;
            data.available = bytes.size() - data.offset;
            if (data.claimed == 0 && is_chunk_behind(bytes, data.offset)) data.available = 0;
            return data;
        }
        offset += 8 + size + size % 2;
    }
    return std::nullopt;
}

std::shared_ptr<const Bytes> plain_wav(std::shared_ptr<const Bytes> bytes, const RiffData& data) {
    const bool is_told = data.claimed > 0 && data.claimed <= data.available && !data.has_unknown_length();
    std::uint64_t length = is_told ? data.claimed : data.available;
    length -= data.frame_bytes > 0 ? length % data.frame_bytes : 0;
    const std::uint64_t whole = 4 + data.kept.size() + 8 + length;
    std::string kept = data.kept;
    if (const std::size_t format = kept.find("fmt "); data.has_wide_frames() && format + 24 <= kept.size())
        kept[format + 22] = 32;  // bits of a sample
    const bool is_raised = data.has_wide_frames() && stand_low(*bytes, data);
    std::string head;
    if (whole <= largest_32) {
        head = "RIFF" + four_bytes(whole) + "WAVE" + kept + "data" + four_bytes(length);
    } else {
        const auto eight_bytes = [](std::uint64_t value) { return four_bytes(value) + four_bytes(value >> 32U); };
        const std::uint64_t frames = data.frame_bytes > 0 ? length / data.frame_bytes : 0;
        head = "RF64" + four_bytes(largest_32) + "WAVEds64" + four_bytes(28) + eight_bytes(whole + 36) +
               eight_bytes(length) + eight_bytes(frames) + four_bytes(0) + kept + "data" + four_bytes(largest_32);
    }
    return std::make_shared<Rehead>(std::move(head), std::move(bytes), data.offset, length, is_raised);
}

std::shared_ptr<const Bytes> with_head(std::string head, std::shared_ptr<const Bytes> bytes, std::uint64_t from) {
    const std::uint64_t length = bytes->size() - from;
    return std::make_shared<Rehead>(std::move(head), std::move(bytes), from, length, false);
}

}  // namespace stridor::recordings
