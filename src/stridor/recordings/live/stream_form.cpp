#include "stridor/recordings/live/stream_form.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/audio/riff.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace stridor::recordings {

namespace {

struct CodingWord {
    SampleCoding coding;
    std::string_view word;
    std::size_t bytes;
    std::string_view sentence;
};

constexpr std::array coding_words{
    CodingWord{SampleCoding::u8, "u8", 1, "8 bit"},
    CodingWord{SampleCoding::s16, "s16le", 2, "16 bit"},
    CodingWord{SampleCoding::s24, "s24le", 3, "24 bit"},
    CodingWord{SampleCoding::s32, "s32le", 4, "32 bit"},
    CodingWord{SampleCoding::f32, "f32le", 4, "32 bit float"},
    CodingWord{SampleCoding::f64, "f64le", 8, "64 bit float"},
};

const CodingWord& word_of(SampleCoding coding) {
    return coding_words[static_cast<std::size_t>(coding)];
}

std::uint64_t number_at(const char* bytes, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t k = count; k-- > 0;)
        value = value << 8U | static_cast<unsigned char>(bytes[k]);
    return value;
}

double sample_at(const char* bytes, SampleCoding coding) {
    const std::size_t count = bytes_of(coding);
    const std::uint64_t number = number_at(bytes, count);
    if (coding == SampleCoding::u8) return (static_cast<double>(number) - 128.0) / 128.0;
    if (coding == SampleCoding::f32)
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(number)));
    if (coding == SampleCoding::f64) return std::bit_cast<double>(number);
    // the sign of a shorter number is moved to the place of a long one's
    const auto bits = static_cast<unsigned>(64 - 8 * count);
    const std::int64_t whole = static_cast<std::int64_t>(number << bits) >> bits;
    return static_cast<double>(whole) / static_cast<double>(std::uint64_t{1} << (8 * count - 1));
}

// the format's own number, behind the one that says so
std::uint16_t coding_number(const RiffData& data) {
    constexpr std::uint16_t extensible = 0xFFFE;
    constexpr std::size_t place = 8 + 24;  // of the first two bytes of the subformat
    const std::size_t format = data.kept.find("fmt ");
    const bool has_room = format != std::string::npos && format + place + 2 <= data.kept.size();
    if (data.coding != extensible || !has_room) return data.coding;
    return static_cast<std::uint16_t>(number_at(data.kept.data() + format + place, 2));
}

std::optional<SampleCoding> coding_of(const RiffData& data) {
    const std::uint16_t number = coding_number(data);
    const bool fits = data.channels > 0 && data.frame_bytes == data.channels * (data.bits / 8);
    if (!fits) return std::nullopt;
    if (number == 3 && data.bits == 32) return SampleCoding::f32;
    if (number == 3 && data.bits == 64) return SampleCoding::f64;
    if (number != 1) return std::nullopt;
    switch (data.bits) {
        case 8:
            return SampleCoding::u8;
        case 16:
            return SampleCoding::s16;
        case 24:
            return SampleCoding::s24;
        case 32:
            return SampleCoding::s32;
        default:
            return std::nullopt;
    }
}

// 32 bits cannot tell more than 4 GiB, and programs that cannot know write the largest number, or sox a half of it
std::optional<std::uint64_t> promised_bytes(const RiffData& data, std::string_view mark) {
    constexpr std::uint64_t largest_disk = std::uint64_t{1} << 60U;
    const bool is_long = mark != "RIFF" && data.claimed > 0xFFFFFFFFU && data.claimed < largest_disk;
    if (data.has_unknown_length() && !is_long) return std::nullopt;
    return data.claimed;
}

std::string description_in(const RiffData& data) {
    constexpr std::size_t longest = 256;
    const std::size_t place = data.kept.find("bext");
    if (place == std::string::npos || place + 8 > data.kept.size()) return "";
    const std::string text = data.kept.substr(place + 8, longest);
    return text.substr(0, text.find('\0'));
}

}  // namespace

std::vector<std::string> sample_coding_names() {
    std::vector<std::string> names;
    for (const CodingWord& each : coding_words)
        names.emplace_back(each.word);
    return names;
}

SampleCoding sample_coding_of(std::string_view name) {
    std::string names;
    for (const CodingWord& each : coding_words) {
        if (each.word == name) return each.coding;
        names += (names.empty() ? "" : ", ") + std::string(each.word);
    }
    throw Error(ErrorKind::input,
                {"\"" + std::string(name) + "\" is no form of samples", "", "Known are " + names + "."});
}

std::size_t bytes_of(SampleCoding coding) {
    return word_of(coding).bytes;
}

std::string stream_form_text(const StreamForm& form) {
    return std::string(word_of(form.coding).sentence) + ", " + base::shortest(form.rate) + " Hz, " +
           std::to_string(form.channels) + (form.channels == 1 ? " channel" : " channels");
}

void decode(const StreamForm& form, std::span<const char> bytes, std::span<double> samples) {
    const std::size_t size = bytes_of(form.coding);
    STRIDOR_EXPECT(bytes.size() == samples.size() * size);
    for (std::size_t k = 0; k < samples.size(); ++k)
        samples[k] = sample_at(bytes.data() + k * size, form.coding);
}

bool is_wav_stream(std::string_view bytes) {
    return is_riff_mark(bytes.substr(0, 4));
}

std::optional<WavStreamHead> wav_stream_head(std::string_view bytes, const std::string& name) {
    constexpr std::size_t longest_head = 1U << 20U;
    const std::optional<RiffData> data = find_riff_data(*bytes_of(std::string(bytes.substr(0, longest_head))));
    if (!data && bytes.size() >= longest_head)
        throw refusal(name, "the WAV stream has no samples", "there is no data chunk in its first MiB", "");
    if (!data) return std::nullopt;
    if (!data->has_format)
        throw refusal(name, "the WAV stream does not say what its samples are", "no fmt chunk before them", "");
    const std::optional<SampleCoding> coding = coding_of(*data);
    if (!coding)
        throw refusal(name,
                      "the WAV stream has samples of format " + std::to_string(coding_number(*data)) + ", " +
                          std::to_string(data->bits) + " bits in frames of " + std::to_string(data->frame_bytes) +
                          " bytes",
                      "8, 16, 24 and 32 bits and floats are read as they come",
                      "Convert it on the way: ... | sox -t wav - -t wav -e signed -b 24 - | stridor listen-in");
    WavStreamHead head;
    head.form = {*coding, static_cast<double>(data->rate), data->channels};
    head.bytes = static_cast<std::size_t>(data->offset);
    head.promised = promised_bytes(*data, bytes.substr(0, 4));
    head.description = description_in(*data);
    return head;
}

}  // namespace stridor::recordings
