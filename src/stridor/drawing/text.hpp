#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stridor::drawing {

/// How a stretch of text is set.
enum class TextStyle { plain, italic, bold, subscript, superscript };

/// A stretch of UTF-8 text in one style.
struct TextRun {
    std::string text;
    TextStyle style = TextStyle::plain;
    bool operator==(const TextRun&) const = default;
};

/// Text of a scene. A user's text is taken literally ("mu_d" stays "mu_d"): subscripts and italics exist only if code
/// asks for them, with `symbol` and `unit_text`.
struct StyledText {
    std::vector<TextRun> runs;

    StyledText() = default;
    /// Makes text in the plain style.
    StyledText(const char* literal);
    /// Makes text in the plain style.
    StyledText(std::string_view literal);
    /// Makes text in the plain style.
    StyledText(const std::string& literal);
    /// Makes text in one style.
    StyledText(std::string_view literal, TextStyle style);
    bool operator==(const StyledText&) const = default;
};

/// Returns one text behind the other.
StyledText operator+(StyledText left, const StyledText& right);

/// Says whether it has no characters.
bool is_empty(const StyledText& text);

/// Returns the characters alone, without styles.
std::string plain_text(const StyledText& text);

/// Returns a symbol of the field table as it is printed: "mu_d" as an italic mu with subscript d; also "k1i", "m1",
/// "A_exc".
StyledText symbol(std::string_view name);

/// Returns a unit as it is printed: "m/s^2" with its superscript, "N*s/m" with a centred dot, "deg" as a degree sign,
/// "1" as an empty text.
StyledText unit_text(std::string_view unit);

/// Returns a number as it is printed, with six digits: "0.004", "10" with its power if it is very small or large.
StyledText number_text(double value);

}  // namespace stridor::drawing
