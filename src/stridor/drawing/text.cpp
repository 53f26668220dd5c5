#include "stridor/drawing/text.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace stridor::drawing {

namespace {

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

}  // namespace

StyledText::StyledText(const char* literal) : StyledText(std::string_view(literal)) {}
StyledText::StyledText(const std::string& literal) : StyledText(std::string_view(literal)) {}
StyledText::StyledText(std::string_view literal) : StyledText(literal, TextStyle::plain) {}
StyledText::StyledText(std::string_view literal, TextStyle style) {
    if (!literal.empty()) runs.push_back({std::string(literal), style});
}

StyledText operator+(StyledText left, const StyledText& right) {
    for (const TextRun& run : right.runs)
        if (!left.runs.empty() && left.runs.back().style == run.style)
            left.runs.back().text += run.text;
        else
            left.runs.push_back(run);
    return left;
}

bool is_empty(const StyledText& text) {
    return text.runs.empty();
}

std::string plain_text(const StyledText& text) {
    std::string characters;
    for (const TextRun& run : text.runs)
        characters += run.text;
    return characters;
}

StyledText symbol(std::string_view name) {
    std::size_t cut = name.find('_');
    std::string_view subscript = cut == std::string_view::npos ? "" : name.substr(cut + 1);
    if (cut == std::string_view::npos) {
        cut = name.find_first_of("0123456789");
        subscript = cut == std::string_view::npos ? "" : name.substr(cut);
    }
    return StyledText(letter_of(name.substr(0, cut)), TextStyle::italic) + StyledText(subscript, TextStyle::subscript);
}

StyledText unit_text(std::string_view unit) {
    if (unit == "1") return {};
    if (unit == "deg") return "°";
    if (unit == "degC") return "°C";
    constexpr std::string_view reference = "1e-9 m/s";  // of velocity levels
    const std::size_t at = unit.find(reference);
    if (at != std::string_view::npos)
        return StyledText(std::string(unit.substr(0, at)) + "1 nm/s") + unit_text(unit.substr(at + reference.size()));
    StyledText text;
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
            text = text + StyledText(power, TextStyle::superscript);
        } else {
            text = text + StyledText(unit.substr(i, 1));
        }
    }
    return text;
}

StyledText number_text(double value) {
    const std::string digits = fmt::format("{:.6g}", value);
    const std::size_t cut = digits.find('e');
    const auto with_minus = [](std::string number) {
        if (number.front() == '-') number.replace(0, 1, "−");
        return number;
    };
    if (cut == std::string::npos) return with_minus(digits);
    const std::string factor = digits.substr(0, cut);
    const StyledText power =
        StyledText("10") +
        StyledText(with_minus(fmt::format("{}", std::stoi(digits.substr(cut + 1)))), TextStyle::superscript);
    return factor == "1" ? power : StyledText(with_minus(factor) + "·") + power;
}

}  // namespace stridor::drawing
