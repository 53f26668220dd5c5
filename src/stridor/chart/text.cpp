#include "stridor/chart/text.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <utility>

namespace stridor::chart {

namespace {

constexpr double millimetres_per_point = 25.4 / 72.0;

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> greek{{{"alpha", "α"},
                                                                               {"beta", "β"},
                                                                               {"gamma", "γ"},
                                                                               {"zeta", "ζ"},
                                                                               {"theta", "θ"},
                                                                               {"lambda", "λ"},
                                                                               {"mu", "μ"},
                                                                               {"pi", "π"},
                                                                               {"sigma", "σ"},
                                                                               {"tau", "τ"},
                                                                               {"phi", "φ"},
                                                                               {"omega", "ω"}}};

std::string_view letter_of(std::string_view name) {
    for (const auto& [word, letter] : greek)
        if (word == name) return letter;
    return name;
}

bool contains(std::string_view characters, char c) {
    return characters.find(c) != std::string_view::npos;
}

// advance of one character in ems, after DejaVu Sans, the widest of the usual sans-serif fonts
double advance(char c) {
    if (contains("ijlI|.,:;' ", c)) return 0.34;
    if (contains("frt()[]-/", c)) return 0.40;
    if (contains("mwMW%@", c)) return 0.93;
    // 0xE2 begins the minus sign and its kin
    if (contains("=+<>~\xE2", c)) return 0.84;
    return std::isupper(static_cast<unsigned char>(c)) != 0 ? 0.70 : 0.63;
}

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;  // UTF-8
}

double width_in_ems(const TextRun& run) {
    double width = 0.0;
    for (const char c : run.text)
        if (!continues_character(c)) width += advance(c);
    const bool is_small = run.style == TextStyle::subscript || run.style == TextStyle::superscript;
    return width * (is_small ? 0.8 : run.style == TextStyle::bold ? 1.12 : 1.0);
}

// a text in pieces that must stay together, each with its trailing blank
std::vector<Text> words_of(const Text& text) {
    std::vector<Text> words;
    bool is_open = false;
    for (const TextRun& run : text.runs)
        for (std::size_t from = 0; from < run.text.size();) {
            const std::size_t blank = run.text.find(' ', from);
            const std::size_t to = blank == std::string::npos ? run.text.size() : blank + 1;
            if (!is_open) words.emplace_back();
            words.back().runs.push_back({run.text.substr(from, to - from), run.style});
            is_open = blank == std::string::npos;
            from = to;
        }
    return words;
}

}  // namespace

Text::Text(const char* literal) : Text(std::string_view(literal)) {}
Text::Text(const std::string& literal) : Text(std::string_view(literal)) {}
Text::Text(std::string_view literal) : Text(literal, TextStyle::plain) {}
Text::Text(std::string_view literal, TextStyle style) {
    if (!literal.empty()) runs.push_back({std::string(literal), style});
}

Text operator+(Text left, const Text& right) {
    for (const TextRun& run : right.runs)
        if (!left.runs.empty() && left.runs.back().style == run.style)
            left.runs.back().text += run.text;
        else
            left.runs.push_back(run);
    return left;
}

bool is_empty(const Text& text) {
    return text.runs.empty();
}

std::string plain_text(const Text& text) {
    std::string characters;
    for (const TextRun& run : text.runs)
        characters += run.text;
    return characters;
}

Text symbol(std::string_view name) {
    std::size_t cut = name.find('_');
    std::string_view subscript = cut == std::string_view::npos ? "" : name.substr(cut + 1);
    if (cut == std::string_view::npos) {
        cut = name.find_first_of("0123456789");
        subscript = cut == std::string_view::npos ? "" : name.substr(cut);
    }
    return Text(letter_of(name.substr(0, cut)), TextStyle::italic) + Text(subscript, TextStyle::subscript);
}

Text unit_text(std::string_view unit) {
    if (unit == "1") return {};
    if (unit == "deg") return "°";
    if (unit == "degC") return "°C";
    constexpr std::string_view reference = "1e-9 m/s";  // of velocity levels
    const std::size_t at = unit.find(reference);
    if (at != std::string_view::npos)
        return Text(std::string(unit.substr(0, at)) + "1 nm/s") + unit_text(unit.substr(at + reference.size()));
    Text text;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        // "m/s^2", and the "1e-6 N" of a reference
        const bool is_power = unit[i] == '^' || unit.substr(i, 3) == "1e-";
        if (unit[i] == '*') {
            text = text + "·";
        } else if (is_power) {
            if (unit[i] == '1') {
                text = text + "10";
                ++i;
            }
            std::string power;
            while (i + 1 < unit.size() && contains("-0123456789", unit[i + 1]))
                power += unit[++i] == '-' ? std::string("−") : std::string(1, unit[i]);
            text = text + Text(power, TextStyle::superscript);
        } else {
            text = text + Text(unit.substr(i, 1));
        }
    }
    return text;
}

Text number_text(double value) {
    const std::string digits = fmt::format("{:.6g}", value);
    const std::size_t cut = digits.find('e');
    const auto with_minus = [](std::string number) {
        if (number.front() == '-') number.replace(0, 1, "−");
        return number;
    };
    if (cut == std::string::npos) return with_minus(digits);
    const std::string factor = digits.substr(0, cut);
    const Text power =
        Text("10") + Text(with_minus(fmt::format("{}", std::stoi(digits.substr(cut + 1)))), TextStyle::superscript);
    return factor == "1" ? power : Text(with_minus(factor) + "·") + power;
}

double text_width(const Text& text, double size) {
    double ems = 0.0;
    for (const TextRun& run : text.runs)
        ems += width_in_ems(run);
    return ems * size * millimetres_per_point;
}

std::vector<Text> wrapped(const Text& text, double size, double width) {
    std::vector<Text> lines;
    for (const Text& word : words_of(text)) {
        if (lines.empty() || text_width(lines.back() + word, size) > width)
            lines.push_back(word);
        else
            lines.back() = lines.back() + word;
    }
    return lines;
}

}  // namespace stridor::chart
