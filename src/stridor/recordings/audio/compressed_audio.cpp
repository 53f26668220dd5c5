#include "stridor/recordings/audio/compressed_audio.hpp"

#include "stridor/recordings/audio/riff.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

#if STRIDOR_HAS_FFMPEG
#    include "stridor/recordings/audio/ffmpeg_source.hpp"
#endif

namespace stridor::recordings {

namespace {

/// A kind of file.
struct Kind {
    std::string_view name;     // for people
    std::string_view demuxer;  // ffmpeg's name
    std::size_t offset;        // [bytes] of the mark
    std::string_view mark;
};

constexpr std::array kinds{Kind{"MPEG-4", "mov", 4, "ftyp"},    Kind{"QuickTime", "mov", 4, "moov"},
                           Kind{"QuickTime", "mov", 4, "wide"}, Kind{"QuickTime", "mov", 4, "mdat"},
                           Kind{"AMR", "amr", 0, "#!AMR"},      Kind{"Matroska", "matroska", 0, "\x1A\x45\xDF\xA3"}};

// the mark of AAC in a stream is twelve set bits and two clear ones
bool is_adts(std::string_view beginning) {
    return beginning.size() > 1 && beginning[0] == '\xFF' &&
           (static_cast<unsigned char>(beginning[1]) & 0xF6U) == 0xF0U;
}

std::optional<Kind> kind_of(std::string_view beginning) {
    if (is_adts(beginning)) return Kind{"AAC", "aac", 0, ""};
    for (const Kind& kind : kinds)
        if (beginning.size() > kind.offset && beginning.substr(kind.offset).starts_with(kind.mark)) return kind;
    return std::nullopt;
}

// A frame of MPEG layer III begins with 32 bits: 11 set, version, layer, no CRC, bit rate, rate, padding, ..., mode. It
// is 144 (version 1) or 72 times its bit rate over its rate long, in bytes. Source: ISO/IEC 11172-3, 13818-3.

constexpr std::array<int, 15> rates_1{0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320};  // [kbit/s]
constexpr std::array<int, 15> rates_2{0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160};      // [kbit/s]
constexpr std::array<int, 3> sampling{44100, 48000, 32000};  // [Hz] of version 1; half and a quarter of the others

unsigned byte_at(std::string_view text, std::size_t at) {
    return static_cast<unsigned char>(text[at]);
}

// how long the frame is that begins so [bytes]
std::optional<std::uint64_t> frame_length(std::string_view head) {
    if (head.size() < 4 || byte_at(head, 0) != 0xFFU || (byte_at(head, 1) & 0xE6U) != 0xE2U) return std::nullopt;
    const unsigned version = byte_at(head, 1) >> 3U & 3U;  // 3: 1, 2: 2, 0: 2.5
    const unsigned bit_rate = byte_at(head, 2) >> 4U;
    const unsigned rate = byte_at(head, 2) >> 2U & 3U;
    if (version == 1 || bit_rate == 0 || bit_rate == 15 || rate == 3) return std::nullopt;
    const int speed = 1000 * (version == 3 ? rates_1.at(bit_rate) : rates_2.at(bit_rate));
    const int sampled = sampling.at(rate) / (version == 3 ? 1 : version == 2 ? 2 : 4);
    return static_cast<std::uint64_t>((version == 3 ? 144 : 72) * speed / sampled) + (byte_at(head, 2) >> 1U & 1U);
}

std::uint64_t length_of_tag(std::string_view head) {
    if (head.size() < 10 || !head.starts_with("ID3")) return 0;
    std::uint64_t length = 0;
    for (std::size_t k = 6; k < 10; ++k)
        length = length << 7U | (byte_at(head, k) & 0x7FU);
    return length + 10;
}

std::uint64_t big_endian(std::string_view text) {
    std::uint64_t value = 0;
    for (std::size_t k = 0; k < text.size(); ++k)
        value = value << 8U | byte_at(text, k);
    return value;
}

std::string big_endian_bytes(std::uint64_t value) {
    std::string text;
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        text += static_cast<char>(value >> shift & 0xFFU);
    return text;
}

// one without sound, of the kind of a given one, that tells how many follow
std::string telling_frame(std::string_view like, std::uint64_t count) {
    std::string frame(like.substr(0, 4));
    frame[1] = static_cast<char>(byte_at(frame, 1) | 1U);               // no CRC
    frame[2] = static_cast<char>((byte_at(frame, 2) & 0x0CU) | 0x90U);  // long enough for what it tells
    const bool is_first = (byte_at(frame, 1) >> 3U & 3U) == 3;
    const bool is_mono = byte_at(frame, 3) >> 6U == 3;
    const std::size_t side = is_first ? (is_mono ? 17 : 32) : (is_mono ? 9 : 17);
    frame.resize(4 + side, '\0');
    frame += "Xing" + big_endian_bytes(1) + big_endian_bytes(count);
    frame.resize(static_cast<std::size_t>(frame_length(frame).value_or(frame.size())), '\0');
    return frame;
}

}  // namespace

bool is_compressed_audio(std::string_view beginning) {
    return kind_of(beginning).has_value();
}

RawSignal open_compressed_audio(const SignalInput& input) {
    const std::optional<Kind> kind = kind_of(text_at(*input.bytes, 0, 16));
    if (!kind) throw refusal(input.name, "this is no compressed sound that is known");
    const std::string what = "this is a compressed sound (" + std::string(kind->name) + ")";
#if STRIDOR_HAS_FFMPEG
    if (const Ffmpeg* ffmpeg = ffmpeg_library())
        return open_with_ffmpeg(*ffmpeg, input, std::string(kind->name), std::string(kind->demuxer));
    throw refusal(input.name, what, "ffmpeg's libraries, which read it, are not on this machine",
                  "Install them (Debian: apt-get install ffmpeg), or convert it elsewhere: ffmpeg -i IN OUT.wav");
#else
    throw refusal(input.name, what, "this program was built without ffmpeg's libraries, which read it",
                  "Convert it first: ffmpeg -i IN OUT.wav");
#endif
}

std::shared_ptr<const Bytes> with_frame_count(std::shared_ptr<const Bytes> bytes) {
    const std::uint64_t first = length_of_tag(text_at(*bytes, 0, 10));
    constexpr std::uint64_t longest_tag = 1U << 24U;  // [bytes] a picture fits into it
    if (first > longest_tag) return bytes;
    const std::string head = text_at(*bytes, first, 4);
    const auto length = frame_length(head);
    if (!length) return bytes;
    const std::string frame = text_at(*bytes, first, static_cast<std::size_t>(*length));
    std::size_t tag = frame.find("Xing");
    if (tag == std::string::npos) tag = frame.find("Info");
    const bool has_tag = tag != std::string::npos && tag + 12 <= frame.size();
    const bool has_count = has_tag && (byte_at(frame, tag + 7) & 1U) != 0;
    if (frame.find("VBRI") != std::string::npos) return bytes;
    const std::uint64_t sound = has_tag ? first + *length : first;
    const std::string kind = text_at(*bytes, sound, 4);
    std::uint64_t count = 0;
    bool is_even = true;  // then the guess is right
    for (std::uint64_t at = sound; at < bytes->size(); ++count) {
        const std::string each = text_at(*bytes, at, 4);
        const auto next = frame_length(each);
        if (!next || *next > bytes->size() - at) break;
        is_even = is_even && byte_at(each, 2) >> 4U == byte_at(kind, 2) >> 4U;
        at += *next;
    }
    // some count the first frame, too; fewer than are told were cut off
    const bool is_told = has_count && big_endian(frame.substr(tag + 8, 4)) + 1 >= count;
    if (is_told || count < 2 || (is_even && !has_tag)) return bytes;
    const std::string kept = text_at(*bytes, 0, static_cast<std::size_t>(first));
    if (!has_count) return with_head(kept + telling_frame(kind, count), bytes, sound);
    const std::string told = text_at(*bytes, 0, static_cast<std::size_t>(first + tag + 8)) + big_endian_bytes(count);
    return with_head(told, bytes, told.size());
}

}  // namespace stridor::recordings
