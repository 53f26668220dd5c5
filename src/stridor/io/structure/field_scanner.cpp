#include "stridor/io/structure/field_scanner.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/raw_signal.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace stridor::io::structure {

namespace {

constexpr std::string_view separators = " \t,";

}  // namespace

std::optional<double> real_in(std::string_view text) {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem == std::errc() && stop == end) return std::isfinite(value) ? std::optional(value) : std::nullopt;
    // exponents by D, or without their letter; what is too small is zero
    const std::optional<double> other = recordings::fortran_number(text);
    return other && std::isfinite(*other) ? other : std::nullopt;
}

std::optional<std::int64_t> integer_in(std::string_view text) {
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    std::int64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, value);
    if (problem != std::errc() || stop != end) return std::nullopt;
    return value;
}

std::string upper(std::string_view text) {
    std::string large(text);
    std::transform(large.begin(), large.end(), large.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return large;
}

std::string_view FieldScanner::word() {
    begin_ = std::min(line_.text.find_first_not_of(separators, at_), line_.text.size());
    at_ = std::min(line_.text.find_first_of(separators, begin_), line_.text.size());
    return line_.text.substr(begin_, at_ - begin_);
}

std::int64_t FieldScanner::integer(const char* what) {
    const std::string_view text = word();
    const std::optional<std::int64_t> value = integer_in(text);
    if (!value)
        throw refusal(
            text.empty() ? std::string(what) + " is missing" : "\"" + std::string(text) + "\" is no whole number",
            std::string("here stands ") + what);
    return *value;
}

double FieldScanner::real(const char* what) {
    const std::string_view text = word();
    const std::optional<double> value = real_in(text);
    if (!value)
        throw refusal(
            text.empty() ? std::string(what) + " is missing" : "\"" + std::string(text) + "\" is no finite number",
            std::string("here stands ") + what);
    return *value;
}

bool FieldScanner::is_at_end() const {
    return line_.text.find_first_not_of(separators, at_) == std::string_view::npos;
}

void FieldScanner::expect_end() {
    const std::string_view text = word();
    if (!text.empty()) throw refusal("\"" + std::string(text) + "\" is more than the line should hold");
}

base::Error FieldScanner::refusal(std::string what, std::string why, std::string suggestion) const {
    return recordings::refusal(recordings::place_of(file_, line_, static_cast<int>(begin_) + 1), std::move(what),
                               std::move(why), std::move(suggestion));
}

std::optional<FortranFormat> fortran_format(std::string_view text) {
    const std::string large = upper(text);
    const std::size_t kind = large.find_first_of("IEDFG");
    if (kind == std::string::npos) return std::nullopt;
    // the number that ends before a letter; 1 where there is none
    const auto number_before = [&](std::size_t end) {
        std::size_t begin = end;
        while (begin > 0 && large[begin - 1] >= '0' && large[begin - 1] <= '9')
            --begin;
        constexpr std::int64_t most = 10000;
        const auto number = integer_in(std::string_view(large).substr(begin, end - begin));
        return begin == end ? std::int64_t{1} : std::clamp(number.value_or(0), std::int64_t{0}, most);
    };
    // "1P," scales what is written, not what is read; "1P3E23.16" has no comma, and 3(1P,E24.16) repeats its group
    const std::size_t group = large.rfind('(', kind);
    const std::size_t blanks = large.rfind('X', kind);
    const std::int64_t repeated = group == std::string::npos ? 1 : number_before(group);
    const std::int64_t count = repeated * number_before(kind);
    const std::size_t end = std::min(large.find_first_not_of("0123456789", kind + 1), large.size());
    const auto width = integer_in(std::string_view(large).substr(kind + 1, end - kind - 1));
    const std::int64_t skipped = blanks == std::string::npos ? 0 : number_before(blanks);
    constexpr std::int64_t most = 60;
    if (!width || count < 1 || count > 1000 || *width < 1 || *width > most || skipped > most) return std::nullopt;
    return FortranFormat{static_cast<std::size_t>(count), static_cast<std::size_t>(*width),
                         static_cast<std::size_t>(skipped)};
}

std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format) {
    std::vector<std::string_view> fields;
    for (std::size_t from = format.skipped; from < line.size() && fields.size() < format.count; from += format.width)
        fields.push_back(base::trimmed(line.substr(from, format.width)));
    while (!fields.empty() && fields.back().empty())
        fields.pop_back();
    return fields;
}

}  // namespace stridor::io::structure
