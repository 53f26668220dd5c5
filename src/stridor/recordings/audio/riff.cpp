#include "stridor/recordings/audio/riff.hpp"

#include <string>
#include <string_view>

namespace stridor::recordings {

namespace {

std::uint64_t little_endian(std::string_view bytes) {
    std::uint64_t value = 0;
    for (std::size_t k = bytes.size(); k-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[k]);
    return value;
}

constexpr std::uint64_t largest_32 = 0xFFFFFFFFU;
constexpr int most_chunks = 1000;  // before the samples; a file with more is no recording

}  // namespace

bool RiffData::has_unknown_length() const {
    // sox writes 0x7FFFFFFF less its header, ffmpeg and others 0xFFFFFFFF
    return claimed == 0 || claimed >= 0x7FFFF000U;
}

bool RiffData::has_sensible_frames() const {
    const bool is_plain = coding == 1 || coding == 3;
    return !is_plain || (bits >= 8 && bits <= 64 && frame_bytes == channels * ((bits + 7) / 8));
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
        if (name == "ds64" && content.size() >= 16) long_size = little_endian(content.substr(8, 8));
        if (name == "data") {
            data.offset = offset + 8;
            data.claimed = size == largest_32 && long_size ? *long_size : size;
            data.available = bytes.size() - data.offset;
            return data;
        }
        offset += 8 + size + size % 2;
    }
    return std::nullopt;
}

}  // namespace stridor::recordings
