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

/// Text of a scene. What comes from a user is taken literally ("mu_d" stays "mu_d"): subscripts and italics exist only
/// where code asks for them, with `symbol` and `unit_text`.
struct StyledText {
    std::vector<TextRun> runs;

    StyledText() = default;
    /// In the plain style.
    StyledText(const char* literal);
    /// In the plain style.
    StyledText(std::string_view literal);
    /// In the plain style.
    StyledText(const std::string& literal);
    /// In one style.
    StyledText(std::string_view literal, TextStyle style);
    bool operator==(const StyledText&) const = default;
};

/// One text behind the other.
StyledText operator+(StyledText left, const StyledText& right);

/// Has it no characters?
bool is_empty(const StyledText& text);

/// The characters alone, without styles.
std::string plain_text(const StyledText& text);

/// A symbol of the field table as it is printed: "mu_d" as an italic mu with subscript d, "k1i",
/// "m1", "A_exc" likewise.
StyledText symbol(std::string_view name);

/// A unit as it is printed: "m/s^2" with its superscript, "N*s/m" with a centred dot,
/// "deg" as a degree sign, "1" as nothing.
StyledText unit_text(std::string_view unit);

/// A number as it is printed, with six digits: "0.004", "10" with its power where it is very small or large.
StyledText number_text(double value);

}  // namespace stridor::drawing
