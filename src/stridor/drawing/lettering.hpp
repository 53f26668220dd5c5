#pragma once

#include "stridor/drawing/text.hpp"

#include <string>
#include <string_view>
#include <vector>

struct _cairo;  // cairo_t

/// Texts set, measured and drawn by Pango: in DejaVu Sans if it is installed, else in the system's sans-serif font.
///
/// A text is taken literally. Each function throws `Error` (io) if no font is installed.
namespace stridor::drawing {

/// Returns the width of a text [mm]; `size` in pt.
double text_width(const StyledText& text, double size);

/// Returns a text cut into lines of at most `width` mm: at its blanks, and within a word that is wider alone.
std::vector<StyledText> wrapped(const StyledText& text, double size, double width);

/// The room of a note [mm], a little air included.
struct TextExtent {
    double width = 0.0;
    double height = 0.0;
};

/// Returns the room of a note of `size` [pt].
TextExtent note_extent(const StyledText& text, double size);

/// How letters are drawn: as glyphs, fitted to the raster of an image, or as the curves of their shapes.
enum class Letters { glyphs, outlines };

/// Draws a text from the origin of a page whose unit is a point, to the right; the middle of its height is at zero.
void draw_letters(_cairo* page, const StyledText& text, double size, Letters letters);

/// Returns a text as a picture can hold it: control characters become blanks, bytes that are not UTF-8 replacement
/// characters.
std::string drawable(std::string_view text);

}  // namespace stridor::drawing
