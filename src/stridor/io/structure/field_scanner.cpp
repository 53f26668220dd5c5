#include "stridor/io/structure/field_scanner.hpp"

#include "stridor/base/text.hpp"
#include "stridor/recordings/fortran_text.hpp"
#include "stridor/recordings/refusal.hpp"

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

}  // namespace stridor::io::structure
