#include "stridor/base/packed_bytes.hpp"

#include <array>
#include <cstring>
#include <limits>
#include <utility>

namespace stridor::base {

namespace {

template <typename Number>
void append(std::string& bytes, Number value) {
    std::array<char, sizeof value> own;
    std::memcpy(own.data(), &value, sizeof value);
    bytes.append(own.data(), own.size());
}

}  // namespace

void Packing::add(double value) {
    append(bytes_, value);
}

void Packing::add(std::uint64_t value) {
    append(bytes_, value);
}

void Packing::add(std::string_view words) {
    append(bytes_, static_cast<std::uint64_t>(words.size()));
    bytes_ += words;
}

std::string Packing::take() {
    return std::exchange(bytes_, {});
}

std::string_view Unpacking::next(std::size_t size) {
    is_good_ = is_good_ && size <= rest_.size();
    if (!is_good_) return {};
    const std::string_view item = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return item;
}

double Unpacking::number() {
    double value = std::numeric_limits<double>::quiet_NaN();
    if (const std::string_view item = next(sizeof value); is_good_) std::memcpy(&value, item.data(), sizeof value);
    return value;
}

std::uint64_t Unpacking::count() {
    std::uint64_t value = 0;
    if (const std::string_view item = next(sizeof value); is_good_) std::memcpy(&value, item.data(), sizeof value);
    return value;
}

std::string Unpacking::words() {
    return std::string(next(count()));
}

std::uint8_t Unpacking::kind_below(std::size_t kinds) {
    const std::string_view item = next(1);
    const std::uint8_t value = is_good_ ? static_cast<std::uint8_t>(item.front()) : 0;
    is_good_ = is_good_ && value < kinds;
    return is_good_ ? value : 0;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group = group << 8U | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= bytes.size() - k ? digits[group >> (18U - 6U * j) & 63U] : '=';
    }
    return text;
}

}  // namespace stridor::base
