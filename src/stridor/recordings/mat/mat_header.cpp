#include "stridor/recordings/mat/mat_header.hpp"

// Version 4: variables, one after the other. Each has five words (type, rows, columns, is it complex, length of its
// name with a zero), its name, its numbers. Version 5: 128 bytes of header with the version and the order of bytes at
// their end; then variables, each with its type and its length in two words. Source: MathWorks, "MAT-File Format",
// 2019, chapters 1 and 2.

#include "stridor/recordings/mat/mat_answers.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

namespace stridor::recordings::mat {

namespace {

constexpr std::size_t header_5 = 128;  // [bytes]
constexpr std::size_t header_4 = 20;   // [bytes]

std::uint32_t word_at(std::string_view bytes, std::size_t place, std::endian order) {
    std::array<std::uint8_t, 4> raw{};
    std::memcpy(raw.data(), bytes.data() + place, raw.size());
    if (order == std::endian::big) std::reverse(raw.begin(), raw.end());
    return raw[0] | static_cast<std::uint32_t>(raw[1]) << 8U | static_cast<std::uint32_t>(raw[2]) << 16U |
           static_cast<std::uint32_t>(raw[3]) << 24U;
}

/// The header of a variable of version 4.
struct Header4 {
    std::uint32_t name_length = 0;  // [bytes] with the zero
    std::uint64_t size = 0;         // [bytes] of the numbers
};

std::optional<Header4> header_of(std::string_view bytes) {
    if (bytes.size() < header_4) return std::nullopt;
    // the type is MOPT: M is the order of bytes, O zero, P the numbers' format, T numbers, text or sparse
    const std::endian order = word_at(bytes, 0, std::endian::little) > 0xFFFFU ? std::endian::big : std::endian::little;
    const std::uint32_t type = word_at(bytes, 0, order);
    constexpr std::array<std::uint64_t, 6> sizes{8, 4, 4, 2, 2, 1};
    const std::uint32_t format = type / 10 % 10;
    const std::uint32_t is_complex = word_at(bytes, 12, order);
    const std::uint32_t name_length = word_at(bytes, 16, order);
    const bool is_sound = type / 1000 <= 1 && type / 100 % 10 == 0 && format < sizes.size() && type % 10 <= 2 &&
                          is_complex <= 1 && name_length >= 2 && name_length <= longest_name + 1;
    if (!is_sound) return std::nullopt;
    const std::uint64_t count = std::uint64_t{word_at(bytes, 4, order)} * word_at(bytes, 8, order);
    // keeps the sum of lengths within its type
    if (count >> 48U != 0) return std::nullopt;
    return Header4{name_length, count * sizes[format] * (1 + is_complex)};
}

bool is_name(std::string_view name) {
    const auto is_of_a_name = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !name.empty() && !(name[0] >= '0' && name[0] <= '9') && std::all_of(name.begin(), name.end(), is_of_a_name);
}

std::endian order_of(std::string_view header) {
    return header.substr(126, 2) == "MI" ? std::endian::big : std::endian::little;
}

base::Error damage(const SignalInput& input, const std::string& why) {
    return refusal(input.name, "the MAT file is damaged", why);
}

// of the variable at a place, with its header; zero where that makes no sense
std::uint64_t length_4(const SignalInput& input, std::uint64_t place) {
    const std::optional<Header4> header = header_of(text_at(*input.bytes, place, header_4));
    return header ? header_4 + header->name_length + header->size : 0;
}

std::uint64_t length_5(const SignalInput& input, std::uint64_t place, std::endian order) {
    const std::string tag = text_at(*input.bytes, place, 8);
    const bool is_whole = tag.size() == 8 && word_at(tag, 0, order) <= 0xFFFFU;
    return is_whole ? std::uint64_t{8} + word_at(tag, 4, order) : 0;
}

}  // namespace

std::optional<Version> version_of(std::string_view beginning) {
    if (beginning.starts_with("MATLAB ")) {
        const bool is_hdf5 =
            beginning.size() >= header_5 && (word_at(beginning, 124, order_of(beginning)) & 0xFFFFU) == 0x0200U;
        return is_hdf5 ? Version::seven_three : Version::five;
    }
    const std::optional<Header4> header = header_of(beginning);
    if (!header || beginning.size() < header_4 + header->name_length) return std::nullopt;
    const std::string_view name = beginning.substr(header_4, header->name_length);
    return is_name(name.substr(0, name.size() - 1)) && name.back() == '\0' ? std::optional(Version::four)
                                                                           : std::nullopt;
}

void check_length(const SignalInput& input, Version version) {
    if (version == Version::seven_three) return;
    const std::uint64_t size = input.bytes->size();
    const std::string header = text_at(*input.bytes, 0, header_5);
    if (version == Version::five && header.size() < header_5) throw damage(input, "it is cut off in its header");
    std::uint64_t place = version == Version::five ? header_5 : 0;
    for (std::uint32_t variable = 1; place < size; ++variable) {
        if (variable > most_variables)
            throw refusal(input.name, "the MAT file has too many variables",
                          "at most " + std::to_string(most_variables) + " are looked at");
        const std::uint64_t length =
            version == Version::five ? length_5(input, place, order_of(header)) : length_4(input, place);
        if (length == 0) throw damage(input, "its variable " + std::to_string(variable) + " has no sound header");
        if (length > size - place)
            throw damage(input, "it is cut off in its variable " + std::to_string(variable) + ", " +
                                    std::to_string(length - (size - place)) + " bytes short");
        place += length;
    }
}

}  // namespace stridor::recordings::mat
