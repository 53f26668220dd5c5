#include "stridor/recordings/calibration.hpp"

#include "stridor/base/elementary.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/quantity.hpp"
#include "stridor/base/text.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <algorithm>
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

/// How people and front ends write a unit, and how we do.
struct UnitSpelling {
    std::string_view word;  // in small letters, unless it is a letter alone
    std::string_view symbol;
};

constexpr std::array unit_spellings{
    UnitSpelling{"sec", "s"},          UnitSpelling{"secs", "s"},          UnitSpelling{"second", "s"},
    UnitSpelling{"seconds", "s"},      UnitSpelling{"sekunde", "s"},       UnitSpelling{"sekunden", "s"},
    UnitSpelling{"msec", "ms"},        UnitSpelling{"msecs", "ms"},        UnitSpelling{"millisec", "ms"},
    UnitSpelling{"millisecs", "ms"},   UnitSpelling{"millisecond", "ms"},  UnitSpelling{"milliseconds", "ms"},
    UnitSpelling{"millis", "ms"},      UnitSpelling{"usec", "us"},         UnitSpelling{"usecs", "us"},
    UnitSpelling{"microsec", "us"},    UnitSpelling{"microsecond", "us"},  UnitSpelling{"microseconds", "us"},
    UnitSpelling{"micros", "us"},      UnitSpelling{"nsec", "ns"},         UnitSpelling{"nsecs", "ns"},
    UnitSpelling{"nanosecond", "ns"},  UnitSpelling{"nanoseconds", "ns"},  UnitSpelling{"minute", "min"},
    UnitSpelling{"minutes", "min"},    UnitSpelling{"mins", "min"},        UnitSpelling{"hour", "h"},
    UnitSpelling{"hours", "h"},        UnitSpelling{"hrs", "h"},           UnitSpelling{"newton", "N"},
    UnitSpelling{"newtons", "N"},      UnitSpelling{"kilonewton", "kN"},   UnitSpelling{"kilonewtons", "kN"},
    UnitSpelling{"volt", "V"},         UnitSpelling{"volts", "V"},         UnitSpelling{"millivolt", "mV"},
    UnitSpelling{"millivolts", "mV"},  UnitSpelling{"pascal", "Pa"},       UnitSpelling{"pascals", "Pa"},
    UnitSpelling{"ampere", "A"},       UnitSpelling{"amperes", "A"},       UnitSpelling{"amp", "A"},
    UnitSpelling{"amps", "A"},         UnitSpelling{"meter", "m"},         UnitSpelling{"meters", "m"},
    UnitSpelling{"metre", "m"},        UnitSpelling{"metres", "m"},        UnitSpelling{"millimeter", "mm"},
    UnitSpelling{"millimeters", "mm"}, UnitSpelling{"millimetre", "mm"},   UnitSpelling{"millimetres", "mm"},
    UnitSpelling{"micron", "um"},      UnitSpelling{"microns", "um"},      UnitSpelling{"hertz", "Hz"},
    UnitSpelling{"degree", "deg"},     UnitSpelling{"degrees", "deg"},     UnitSpelling{"celsius", "degC"},
    UnitSpelling{"degc", "degC"},      UnitSpelling{"C", "degC"},          UnitSpelling{"percent", "%"},
    UnitSpelling{"inch", "in"},        UnitSpelling{"inches", "in"},       UnitSpelling{"feet", "ft"},
    UnitSpelling{"lbs", "lbf"},        UnitSpelling{"pound-force", "lbf"}, UnitSpelling{"kp", "kgf"},
    UnitSpelling{"G", "gn"},           UnitSpelling{"gs", "gn"},           UnitSpelling{"g's", "gn"},
    UnitSpelling{"gee", "gn"},         UnitSpelling{"g_n", "gn"},          UnitSpelling{"unitless", "-"},
    UnitSpelling{"none", "-"},
};

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

// the signs of Latin-1, in which many front ends write, are single bytes
std::string in_our_letters(std::string_view text) {
    std::string result;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const auto byte = static_cast<unsigned char>(text[k]);
        const auto before = static_cast<unsigned char>(k > 0 ? text[k - 1] : ' ');
        const bool is_alone = byte < 0x80U || before < 0x80U;
        if (is_alone && byte == 0xB5U)
            result += 'u';
        else if (is_alone && (byte == 0xB2U || byte == 0xB3U))
            result += byte == 0xB2U ? "^2" : "^3";
        else if (is_alone && byte == 0xB0U)
            result += "\xC2\xB0";
        else
            result += text[k];
    }
    replace_all(result, "\xC2\xB5", "u");  // the micro sign, and the Greek letter
    replace_all(result, "\xCE\xBC", "u");
    replace_all(result, "\xC2\xB2", "^2");
    replace_all(result, "\xC2\xB7", "*");
    replace_all(result, "**", "^");
    return result;
}

std::string_view symbol_of(std::string_view word) {
    const std::string small = word.size() > 1 ? csv_table::lower(word) : std::string(word);
    const auto found = std::find_if(unit_spellings.begin(), unit_spellings.end(),
                                    [&](const UnitSpelling& spelling) { return spelling.word == small; });
    return found == unit_spellings.end() ? word : found->symbol;
}

// word by word: "m/sec2" is m/s^2, "N.m" is N*m, "m.s-2" is m*s^-2
std::string respelt(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("/*.^ 0123456789+-", at), text.size());
        if (end > at) {
            result += symbol_of(text.substr(at, end - at));
            const std::size_t digit = end < text.size() && text[end] == '-' ? end + 1 : end;
            if (digit < text.size() && text[digit] >= '0' && text[digit] <= '9') result += '^';
            at = end;
        } else {
            result += text[at] == '.' ? '*' : text[at];
            ++at;
        }
    }
    return result;
}

// "(m/s^2)" and "[m/s^2]" are m/s^2
std::string_view without_brackets(std::string_view text) {
    text = base::trimmed(text);
    const bool is_enclosed = (text.starts_with('(') && text.ends_with(')') && text.find('(', 1) == text.npos) ||
                             (text.starts_with('[') && text.ends_with(']'));
    return is_enclosed && text.size() > 2 ? base::trimmed(text.substr(1, text.size() - 2)) : text;
}

bool is_gravity(std::string_view text) {
    return text == "g" || text == "gn";
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

std::string unit_as_written(std::string_view label) {
    const std::string text = in_our_letters(without_brackets(label));
    if (base::find_unit(text) || is_gravity(text)) return text;
    const std::string_view whole = symbol_of(text);
    if (whole != text) return std::string(whole);
    const std::string again = respelt(text);
    return base::find_unit(again) ? again : text;
}

bool is_known_unit(std::string_view label) {
    const std::string text = unit_as_written(label);
    const bool is_kept = text == "-" || text == "K" || text == signal::full_scale;  // K has its zero elsewhere
    return text.empty() || is_kept || is_gravity(text) || base::find_unit(text).has_value();
}

FullScale unit_of_label(std::string_view label) {
    const std::string text = unit_as_written(label);
    if (text.empty() || text == "-") return {};
    if (is_gravity(text)) return {standard_gravity, "m/s^2"};
    if (text == "mg") return {1e-3 * standard_gravity, "m/s^2"};
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
    const std::string label = unit_as_written(std::string_view(given).substr(end));
    if (label.empty()) throw refuse("it has no unit");
    const bool is_plain = label == signal::full_scale;
    if (!is_plain && !is_gravity(label)) base::parse_unit(label);  // throws with the nearest unit
    const FullScale one = unit_of_label(label);
    const double number = base::parse_quantity(given.substr(0, end), "1");
    const bool is_own_unit = is_plain || is_gravity(label) || label == "mg" || one.unit == label;
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
