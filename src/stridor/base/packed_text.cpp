#include "stridor/base/packed_text.hpp"

#include "stridor/base/text.hpp"

#include <charconv>
#include <limits>
#include <system_error>

namespace stridor::base {

void Packing::add(double value) {
    add(std::string_view(shortest(value)));
}

void Packing::add(std::uint64_t value) {
    add(std::string_view(std::to_string(value)));
}

void Packing::add(std::string_view words) {
    text_ += std::to_string(words.size()) + ":";
    text_ += words;
}

std::string Packing::take() {
    return std::move(text_);
}

std::string_view Unpacking::next() {
    std::size_t length = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto read = std::from_chars(rest_.data(), end, length);
    const bool has_mark = read.ec == std::errc{} && read.ptr != end && *read.ptr == ':';
    const auto begin = static_cast<std::size_t>(read.ptr - rest_.data()) + 1;
    if (!is_good_ || !has_mark || length > rest_.size() - begin) {
        is_good_ = false;
        return {};
    }
    const std::string_view item = rest_.substr(begin, length);
    rest_.remove_prefix(begin + length);
    return item;
}

double Unpacking::number() {
    const std::string_view item = next();
    double value = std::numeric_limits<double>::quiet_NaN();
    const auto read = std::from_chars(item.data(), item.data() + item.size(), value);
    is_good_ = is_good_ && read.ec == std::errc{} && read.ptr == item.data() + item.size();
    return value;
}

std::uint64_t Unpacking::count() {
    const std::string_view item = next();
    std::uint64_t value = 0;
    const auto read = std::from_chars(item.data(), item.data() + item.size(), value);
    is_good_ = is_good_ && read.ec == std::errc{} && read.ptr == item.data() + item.size();
    return value;
}

std::string Unpacking::words() {
    return std::string(next());
}

}  // namespace stridor::base
