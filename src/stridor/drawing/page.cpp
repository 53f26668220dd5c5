#include "stridor/drawing/page.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/escapes.hpp"
#include "stridor/drawing/lettering.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numbers>

namespace stridor::drawing {

namespace {

cairo_status_t append(void* file, const unsigned char* bytes, unsigned int count) {
    try {
        static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(bytes), count);
        return CAIRO_STATUS_SUCCESS;
    } catch (const std::bad_alloc&) {
        return CAIRO_STATUS_NO_MEMORY;
    }
}

void expect(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw Error(ErrorKind::io, {"the figure could not be drawn", cairo_status_to_string(status), ""});
}

struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* page) const { cairo_destroy(page); }
};

// cairo numbers its surfaces over the whole run of a program, and its SVG names them: without the name the same drawing
// gives the same bytes. Its letters are outlines: its words stand beside them, to be found and to be read aloud.
std::string described(std::string svg, std::string_view title, std::string_view words) {
    constexpr std::string_view name = " id=\"surface";
    if (const std::size_t at = svg.find(name); at != std::string::npos)
        svg.erase(at, svg.find('"', at + name.size()) + 1 - at);
    const std::size_t root = svg.find("<svg");
    return svg.insert(svg.find('>', root) + 1, "\n<title>" + base::markup_text(drawable(title)) + "</title>\n<desc>" +
                                                   base::markup_text(words) + "</desc>");
}

// corners around the origin with y upwards, as wide to the eye as a disc of radius 1 [1]
std::span<const Dot> corners(Mark mark) {
    static constexpr std::array<Dot, 4> square{{{-0.89, -0.89}, {0.89, -0.89}, {0.89, 0.89}, {-0.89, 0.89}}};
    static constexpr std::array<Dot, 4> diamond{{{0.0, -1.25}, {1.25, 0.0}, {0.0, 1.25}, {-1.25, 0.0}}};
    static constexpr std::array<Dot, 3> triangle{{{-1.3, -0.65}, {1.3, -0.65}, {0.0, 1.3}}};
    static constexpr std::array<Dot, 3> nabla{{{-1.3, 0.65}, {1.3, 0.65}, {0.0, -1.3}}};
    switch (mark) {
        case Mark::square:
            return square;
        case Mark::triangle:
            return triangle;
        case Mark::diamond:
            return diamond;
        case Mark::nabla:
            return nabla;
        case Mark::disc:
        case Mark::cross:
            break;
    }
    return {};
}

}  // namespace

struct Page::Surface {
    std::string file;
    std::string title;
    std::string words;  // of all texts, a line each
    Format format = Format::png;
    double height = 0.0;  // [pt]
    std::unique_ptr<cairo_surface_t, Destroy> paper;
    std::unique_ptr<cairo_t, Destroy> pen;

    double x(double millimetres) const { return millimetres / millimetres_per_point; }
    double y(double millimetres) const { return height - millimetres / millimetres_per_point; }

    void set(Colour colour) const {
        cairo_set_source_rgb(pen.get(), colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0);
    }

    void set(const Stroke& stroke, LineEnd end) const {
        set(stroke.colour);
        cairo_set_line_width(pen.get(), stroke.width);
        cairo_set_line_join(pen.get(), CAIRO_LINE_JOIN_ROUND);
        const bool is_solid = stroke.dash == Dash::solid;
        cairo_set_line_cap(pen.get(), is_solid && end == LineEnd::round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
        const double unit = std::max(0.5, stroke.width);  // [pt]
        const std::array<double, 2> lengths =
            stroke.dash == Dash::dashed ? std::array{4.0 * unit, 2.5 * unit} : std::array{1.0 * unit, 2.0 * unit};
        cairo_set_dash(pen.get(), lengths.data(), is_solid ? 0 : 2, 0.0);
    }

    void add(const Rectangle& area) const {
        cairo_rectangle(pen.get(), x(area.left), y(area.top), x(width_of(area)), x(height_of(area)));
    }
};

Page::Page(double width, double height, Format format, std::string_view title) : surface_(new Surface) {
    Surface& s = *surface_;
    s.title = title;
    s.format = format;
    s.height = height / millimetres_per_point;
    const double points = width / millimetres_per_point;
    const auto dots = [](double length) { return static_cast<int>(std::lround(length / 72.0 * png_resolution)); };
    if (format == Format::png)
        s.paper.reset(cairo_image_surface_create(CAIRO_FORMAT_RGB24, dots(points), dots(s.height)));
    else if (format == Format::svg)
        s.paper.reset(cairo_svg_surface_create_for_stream(append, &s.file, points, s.height));
    else
        s.paper.reset(cairo_pdf_surface_create_for_stream(append, &s.file, points, s.height));
    s.pen.reset(cairo_create(s.paper.get()));
    expect(cairo_status(s.pen.get()));
    if (format == Format::png) cairo_scale(s.pen.get(), png_resolution / 72.0, png_resolution / 72.0);
    if (format == Format::pdf) {
        cairo_pdf_surface_set_metadata(s.paper.get(), CAIRO_PDF_METADATA_TITLE, drawable(title).c_str());
        // no date: the same drawing gives the same bytes
        cairo_pdf_surface_set_metadata(s.paper.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
    }
    s.set(Colour{255, 255, 255});
    cairo_paint(s.pen.get());
}

Page::~Page() = default;

void Page::fill(std::span<const Rectangle> areas, Colour colour) {
    surface_->set(colour);
    for (const Rectangle& area : areas)
        surface_->add(area);
    cairo_fill(surface_->pen.get());
}

void Page::curve(std::span<const Dot> points, const Stroke& stroke, LineEnd end) {
    surface_->set(stroke, end);
    for (const Dot& point : points)
        cairo_line_to(surface_->pen.get(), surface_->x(point.x), surface_->y(point.y));
    cairo_stroke(surface_->pen.get());
}

void Page::segments(std::span<const Segment> lines, const Stroke& stroke) {
    surface_->set(stroke, LineEnd::butt);
    for (const Segment& line : lines) {
        cairo_move_to(surface_->pen.get(), surface_->x(line.x0), surface_->y(line.y0));
        cairo_line_to(surface_->pen.get(), surface_->x(line.x1), surface_->y(line.y1));
    }
    cairo_stroke(surface_->pen.get());
}

void Page::outline(const Rectangle& area, const Stroke& stroke) {
    surface_->set(stroke, LineEnd::butt);
    surface_->add(area);
    cairo_stroke(surface_->pen.get());
}

void Page::marks(std::span<const Dot> middles, Mark mark, double diameter, Colour colour) {
    cairo_t* pen = surface_->pen.get();
    const double radius = 0.5 * diameter;
    // a line of no length with round ends is a disc
    surface_->set({colour, mark == Mark::disc ? diameter : 0.3 * diameter, Dash::solid}, LineEnd::round);
    for (const Dot& middle : middles) {
        const double x = surface_->x(middle.x);
        const double y = surface_->y(middle.y);
        if (mark == Mark::disc) {
            cairo_move_to(pen, x, y);
            cairo_line_to(pen, x, y);
        } else if (mark == Mark::cross) {
            cairo_move_to(pen, x - radius, y - radius);
            cairo_line_to(pen, x + radius, y + radius);
            cairo_move_to(pen, x - radius, y + radius);
            cairo_line_to(pen, x + radius, y - radius);
        } else {
            cairo_new_sub_path(pen);
            for (const Dot& corner : corners(mark))
                cairo_line_to(pen, x + radius * corner.x, y - radius * corner.y);
            cairo_close_path(pen);
        }
    }
    if (corners(mark).empty())
        cairo_stroke(pen);
    else
        cairo_fill(pen);
}

void Page::text(const PlacedText& placed) {
    cairo_t* pen = surface_->pen.get();
    surface_->words += drawable(plain_text(placed.text)) + "\n";
    surface_->set(placed.colour);
    cairo_save(pen);
    cairo_translate(pen, surface_->x(placed.x), surface_->y(placed.y));
    if (placed.turn == PlacedText::Turn::quarter) cairo_rotate(pen, -0.5 * std::numbers::pi);
    const double before = placed.align == Align::left ? 0.0 : placed.align == Align::centre ? 0.5 : 1.0;
    cairo_translate(pen, -before * surface_->x(text_width(placed.text, placed.size)), 0.0);
    // an image would move each letter to the nearest dot
    draw_letters(pen, placed.text, placed.size, surface_->format == Format::png ? Letters::outlines : Letters::glyphs);
    cairo_restore(pen);
}

void Page::begin_clip(const Rectangle& area) {
    cairo_save(surface_->pen.get());
    surface_->add(area);
    cairo_clip(surface_->pen.get());
}

void Page::end_clip() {
    cairo_restore(surface_->pen.get());
}

std::string Page::finished() {
    Surface& s = *surface_;
    expect(cairo_status(s.pen.get()));
    if (s.format == Format::png) expect(cairo_surface_write_to_png_stream(s.paper.get(), append, &s.file));
    cairo_surface_finish(s.paper.get());
    expect(cairo_surface_status(s.paper.get()));
    return s.format == Format::svg ? described(std::move(s.file), s.title, s.words) : std::move(s.file);
}

}  // namespace stridor::drawing
