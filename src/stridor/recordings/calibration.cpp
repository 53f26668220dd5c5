#include "stridor/recordings/calibration.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace stridor::recordings {

namespace {

constexpr double standard_gravity = 9.80665;  // [m/s^2] ISO 80000-3
constexpr double reference_pressure = 20e-6;  // [Pa] of dB SPL
constexpr double logarithm_2_of_10 = 3.3219280948873623;
constexpr double root_of_2 = 1.4142135623730951;

// what a dimension is called in SI, in the field's words
constexpr std::array si_units{std::pair{"Pa", base::Dimension{1, -1, -2}},
                              std::pair{"m/s^2", base::Dimension{0, 1, -2}},
                              std::pair{"m/s", base::Dimension{0, 1, -1}},
                              std::pair{"m", base::Dimension{0, 1}},
                              std::pair{"N", base::Dimension{1, 1, -2}},
                              std::pair{"V", base::Dimension{1, 2, -3, 0, -1}},
                              std::pair{"A", base::Dimension{0, 0, 0, 0, 1}},
                              std::pair{"Hz", base::Dimension{0, 0, -1}},
                              std::pair{"kg", base::Dimension{1}},
                              std::pair{"s", base::Dimension{0, 0, 1}},
                              std::pair{"N/m", base::Dimension{1, 0, -2}},
                              std::pair{"J", base::Dimension{1, 2, -2}},
                              std::pair{"deg", base::Dimension{0, 0, 0, 1}},
                              std::pair{"1", base::Dimension{}}};

std::string spelt(std::string_view label) {
    std::string text(base::trimmed(label));
    for (std::size_t stars = text.find("**"); stars != std::string::npos; stars = text.find("**"))
        text.replace(stars, 2, "^");
    return text;
}

// digits, a sign, a point or a decimal comma; moves `text` behind them
std::optional<double> take_number(std::string_view& text) {
    const std::size_t end = text.find_first_not_of("+-0123456789.,");
    std::string numeral(text.substr(0, end));
    if (numeral.ends_with('.') || numeral.ends_with(',')) numeral.pop_back();
    const std::optional<double> number = csv_table::number_in(numeral, {';'});
    if (number) text.remove_prefix(numeral.size());
    return number;
}

void skip_blanks(std::string_view& text) {
    text = base::trimmed(text);
}

bool take(std::string_view& text, std::string_view word) {
    skip_blanks(text);
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
}

// the number that ends where `text` does
std::optional<double> number_before(std::string_view text) {
    text = base::trimmed(text);
    const std::size_t last_other = text.find_last_not_of("+-0123456789.,");
    std::string_view numeral = last_other == std::string_view::npos ? text : text.substr(last_other + 1);
    const std::optional<double> number = take_number(numeral);
    return numeral.empty() ? number : std::nullopt;
}

// behind "dbfs": "= 109.7 dBSPL"
std::optional<double> level_behind(std::string_view text) {
    for (const std::string_view sign : {"=", ":", "is", "equals", "corresponds to", "≙", "≘"})
        if (take(text, sign)) break;
    skip_blanks(text);
    const std::optional<double> level = take_number(text);
    if (!level || !take(text, "db")) return std::nullopt;
    take(text, "(");
    return take(text, "spl") ? level : std::nullopt;
}

std::optional<FullScale> by_level(std::string_view text) {
    constexpr std::string_view word = "dbfs";
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::optional<double> digital = number_before(text.substr(0, at));
        const std::optional<double> level = level_behind(text.substr(at + word.size()));
        if (!digital || !level) continue;
        const double top = *level - *digital;  // [dB] of a sine that reaches full scale
        const bool makes_sense = std::abs(top) <= 300.0;
        if (!makes_sense) continue;
        return FullScale{root_of_2 * reference_pressure * base::power_of_2(top / 20.0 * logarithm_2_of_10), "Pa"};
    }
    return std::nullopt;
}

std::optional<FullScale> by_quantity(std::string_view text, std::string_view small) {
    for (const std::string_view word : {"full scale", "full-scale", "full_scale", "fullscale"}) {
        const std::size_t at = small.find(word);
        if (at == std::string_view::npos) continue;
        std::string_view rest = text.substr(at + word.size());
        if (!take(rest, "=") && !take(rest, ":")) continue;
        rest = rest.substr(0, rest.find_first_of(";\r\n"));
        try {
            return parse_full_scale(rest);
        } catch (const Error&) {
            continue;  // words that only look like ours
        }
    }
    return std::nullopt;
}

}  // namespace

bool is_known_unit(std::string_view label) {
    const std::string text = spelt(label);
    return text.empty() || text == "-" || text == signal::full_scale || base::find_unit(text).has_value();
}

FullScale unit_of_label(std::string_view label) {
    const std::string text = spelt(label);
    if (text.empty() || text == "-") return {};
    if (text == "g" || text == "gn") return {standard_gravity, "m/s^2"};
    const std::optional<base::Unit> unit = base::find_unit(text);
    if (!unit) return {1.0, text};
    for (const auto& [name, dimension] : si_units)
        if (dimension == unit->dimension) return {unit->factor, name};
    return {1.0, text};
}

FullScale parse_full_scale(std::string_view text) {
    const std::string given(base::trimmed(text));
    const auto refuse = [&](const std::string& why) {
        return Error(ErrorKind::input, {"\"" + given + "\" is no full scale", why,
                                        "Write what the number 1 in the file stands for: \"2 Pa\", \"50 m/s^2\"."});
    };
    const std::size_t digits = given.find_first_not_of("+-0123456789.eE");
    std::size_t end = digits == std::string::npos ? given.size() : digits;
    // "2e" of "2e V" belongs to the number only if digits follow it
    while (end > 0 && (given[end - 1] == 'e' || given[end - 1] == 'E'))
        --end;
    const std::string label = spelt(std::string_view(given).substr(end));
    if (label.empty()) throw refuse("it has no unit");
    const bool is_plain = label == signal::full_scale;
    if (!is_plain && label != "gn") base::parse_unit(label);  // throws with the nearest unit
    const FullScale one = unit_of_label(label);
    const double number = base::parse_quantity(given.substr(0, end), "1");
    const bool is_gravity = label == "g" || label == "gn";
    const bool is_own_unit = is_plain || is_gravity || one.unit == label;
    const double value =
        is_own_unit ? number * one.value : base::parse_quantity(given.substr(0, end) + " " + label, one.unit);
    if (!(value > 0.0) || !std::isfinite(value)) throw refuse("it is not positive");
    return {value, one.unit};
}

std::optional<FullScale> calibration_in(std::string_view description) {
    const std::string small = csv_table::lower(description);
    if (const auto exact = by_quantity(description, small)) return exact;
    return by_level(small);
}

std::string calibration_text(const FullScale& full_scale) {
    if (full_scale.unit == signal::full_scale) return "";
    const std::string exact = "full scale = " + base::shortest(full_scale.value) + " " + full_scale.unit;
    if (full_scale.unit != "Pa") return exact;
    const double level = base::decibels(full_scale.value / (root_of_2 * reference_pressure));
    const double hundredths = std::round(level * 100.0) / 100.0;
    return "0dBFS = " + base::shortest(hundredths) + " dBSPL; " + exact;
}

std::vector<FullScale> full_scales_in(const std::string& calibration) {
    std::vector<FullScale> scales;
    constexpr std::string_view mark = "full scale = ";
    std::size_t begin = 0;
    try {
        while (calibration.compare(begin, mark.size(), mark) == 0) {
            const std::size_t end = std::min(calibration.find(';', begin), calibration.size());
            scales.push_back(
                parse_full_scale(base::trimmed(calibration.substr(begin + mark.size(), end - begin - mark.size()))));
            begin = std::min(end + 2, calibration.size());
        }
    } catch (const Error&) {
        scales.clear();  // words of a person
    }
    if (scales.empty())
        if (const std::optional<FullScale> scale = calibration_in(calibration)) scales.push_back(*scale);
    return scales;
}

std::vector<FullScale> parse_full_scales(std::span<const std::string> texts) {
    std::vector<FullScale> full_scales;
    for (const std::string& text : texts)
        full_scales.push_back(parse_full_scale(text));
    return full_scales;
}

}  // namespace stridor::recordings
