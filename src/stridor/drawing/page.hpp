#pragma once

#include "stridor/drawing/layout.hpp"
#include "stridor/drawing/palette.hpp"

#include <memory>
#include <span>
#include <string>

namespace stridor::drawing {

/// The kind of a picture's file.
enum class Format { png, svg, pdf };

/// Dots per inch of PNG files; SVG and PDF have none.
inline constexpr double png_resolution = 200.0;

/// How a solid line ends; dashes and dots always end butt.
enum class LineEnd { butt, round };

/// A sheet of paper drawn by cairo. Places are in mm from its lower left corner, widths of lines and marks in pt. Later
/// drawing covers earlier drawing.
class Page {
public:
    /// Makes a white page. `title` is the file's title; a PNG has none.
    Page(double width, double height, Format format, std::string_view title);
    ~Page();
    Page(const Page&) = delete;
    Page& operator=(const Page&) = delete;

    /// Fills areas with a colour.
    void fill(std::span<const Rectangle> areas, Colour colour);
    /// Fills one area with a colour.
    void fill(const Rectangle& area, Colour colour) { fill({&area, 1}, colour); }
    /// Draws one line through all points.
    void curve(std::span<const Dot> points, const Stroke& stroke, LineEnd end = LineEnd::round);
    /// Draws straight lines, each by itself.
    void segments(std::span<const Segment> lines, const Stroke& stroke);
    /// Draws the edges of an area.
    void outline(const Rectangle& area, const Stroke& stroke);

    /// Draws marks of one diameter [pt], all in one colour.
    void marks(std::span<const Dot> middles, Mark mark, double diameter, Colour colour);

    /// Writes a text at its place.
    void text(const PlacedText& placed);

    /// Limits drawing to the area until the matching `end_clip`.
    void begin_clip(const Rectangle& area);
    /// Ends the last clip that was begun.
    void end_clip();

    /// Returns the bytes of the file; nothing may be drawn afterwards. The same drawing gives the same bytes.
    ///
    /// Throws `Error` (io) if memory runs out or the page is too large for its format.
    std::string finished();

private:
    struct Surface;
    std::unique_ptr<Surface> surface_;
};

}  // namespace stridor::drawing
