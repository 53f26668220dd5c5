#include "stridor/chart/script.hpp"

#include "stridor/chart/layout.hpp"
#include "stridor/chart/palette.hpp"
#include "stridor/chart/panel_script.hpp"
#include "stridor/chart/texture.hpp"

#include <fmt/format.h>

#include <cmath>

namespace stridor::chart {

namespace {

std::string escaped(std::string_view text) {
    constexpr std::string_view enhanced = "\\_^{}@&~";
    std::string result;
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 0x20U || c == 0x7f) {
            result += ' ';
            continue;
        }
        if (enhanced.find(c) != std::string_view::npos) result += '\\';
        result += c;
        if (c == '\'') result += c;
    }
    return result;
}

std::string terminal(const Scene& scene, Format format) {
    // a line of width 1 is one dot wide, a letter of size 1 one dot high (svg)
    // or 1/72 inch at 96 dots per inch (pngcairo)
    const double resolution = format == Format::png ? png_resolution : 96.0;
    const double line_scale = resolution / 72.0;
    const double text_scale = format == Format::png ? resolution / 96.0 : line_scale;
    const auto dots = [&](double millimetres) { return std::lround(millimetres / 25.4 * resolution); };
    return fmt::format(
        "set terminal {0} size {1},{2} enhanced font '{3},{4:g}' fontscale {5:.6g} linewidth {6:.6g} {7}\n",
        format == Format::png ? "pngcairo" : "svg", dots(scene.width), dots(scene.height),
        // a browser has its own sans-serif; Pango takes the nearest font where this one is missing
        format == Format::png ? "DejaVu Sans" : "sans-serif", scene.font_size, text_scale, line_scale,
        format == Format::png ? "rounded background rgb '#FFFFFF'" : "dynamic rounded background rgb '#FFFFFF'");
}

// places on the whole paper
class Paper {
public:
    explicit Paper(const Scene& scene) : width_(scene.width), height_(scene.height) {}

    std::string at(double x, double y) const {
        return fmt::format("screen {:.6f},screen {:.6f}", x / width_, y / height_);
    }

    std::string text(const PlacedText& placed) const {
        constexpr std::string_view alignment[] = {"left", "center", "right"};
        return fmt::format("set label {} at {} {} font ',{:g}' tc rgb '{}'{} front\n", gnuplot_string(placed.text),
                           at(placed.x, placed.y), alignment[static_cast<std::size_t>(placed.align)], placed.size,
                           hex(placed.colour), placed.turn == PlacedText::Turn::quarter ? " rotate by 90" : "");
    }

    std::string segment(const Segment& s, const Stroke& stroke) const {
        return fmt::format("set arrow from {} to {} nohead {} front\n", at(s.x0, s.y0), at(s.x1, s.y1),
                           line_style(stroke));
    }

    // diameter in mm
    std::string disc(const Dot& middle, double diameter, Colour colour) const {
        return fmt::format("set object circle at {} size screen {:.6f} fc rgb '{}' fs solid 1 noborder front\n",
                           at(middle.x, middle.y), 0.5 * diameter / width_, hex(colour));
    }

    std::string mark(const Dot& middle, const std::string& style) const {
        return fmt::format("set label '' at {} point {} front\n", at(middle.x, middle.y), style);
    }

    std::string sample(const PlacedSample& placed) const {
        const Rectangle& area = placed.area;
        if (const Stroke* stroke = std::get_if<Stroke>(&placed.sample)) {
            const double y = 0.5 * (area.bottom + area.top);
            return segment({area.left, y, area.right, y}, *stroke);
        }
        if (const Points* points = std::get_if<Points>(&placed.sample)) {
            const Dot middle{0.5 * (area.left + area.right), 0.5 * (area.bottom + area.top)};
            std::string discs;
            if (points->mark != Mark::disc || points->outline) {
                if (points->outline) discs += mark(middle, point_style(*points, *points->outline, outline_width));
                return discs + mark(middle, point_style(*points, points->colour, 0.0));
            }
            if (points->rim) discs += disc(middle, rim_diameter(*points) * point_length, *points->rim);
            return discs + disc(middle, points->diameter * point_length, points->colour);
        }
        const Fill& fill = std::get<Fill>(placed.sample);
        std::string lines =
            fmt::format("set object rectangle from {} to {} fc rgb '{}' fs solid 1 border lc rgb '{}' lw 0.4\n",
                        at(area.left, area.bottom), at(area.right, area.top), hex(fill.colour), hex(quiet_ink));
        // a sample is small: a denser texture shows what it is
        const Rectangle inside{area.left + 0.3, area.right - 0.3, area.bottom + 0.3, area.top - 0.3};
        const Pattern strokes =
            pattern(fill.texture, {fill.texture == Texture::dots ? &inside : &area, 1}, legend_spacing);
        for (const Segment& line : strokes.lines)
            lines += segment(line, {fill.ink, texture_width, Dash::solid});
        for (const Dot& dot : strokes.dots)
            lines += disc(dot, 0.4, fill.ink);
        return lines;
    }

private:
    static constexpr double legend_spacing = 1.1;        // [mm]
    static constexpr double point_length = 25.4 / 72.0;  // [mm]

    double width_;   // [mm]
    double height_;  // [mm]
};

Panel colour_bar_panel(const ColourBar& bar) {
    constexpr std::size_t steps = 128;
    Panel panel;
    panel.frame = Frame::closed;
    panel.x.range = {0.0, 1.0};
    panel.x.text = AxisText::hidden;
    panel.y.scale = bar.colours.scale;
    panel.y.range = bar.colours.range;
    ValueCells cells;
    cells.x_edges = {0.0, 1.0};
    cells.colours = bar.colours;
    for (std::size_t i = 0; i <= steps; ++i)
        cells.y_edges.push_back(value_at_position(panel.y, static_cast<double>(i) / steps));
    for (std::size_t i = 0; i < steps; ++i)
        cells.values.push_back(value_at_position(panel.y, (static_cast<double>(i) + 0.5) / steps));
    panel.layers.emplace_back(std::move(cells));
    return panel;
}

}  // namespace

std::string gnuplot_string(const Text& text) {
    std::string result = "'";
    for (const TextRun& run : text.runs) {
        const std::string characters = escaped(run.text);
        switch (run.style) {
            case TextStyle::plain:
                result += characters;
                break;
            case TextStyle::italic:
                result += "{/:Italic " + characters + "}";
                break;
            case TextStyle::bold:
                result += "{/:Bold " + characters + "}";
                break;
            case TextStyle::subscript:
                result += "_{" + characters + "}";
                break;
            case TextStyle::superscript:
                result += "^{" + characters + "}";
                break;
        }
    }
    return result + "'";
}

std::string script(const Scene& scene, Format format) {
    const Layout layout = arrange(scene);
    const Paper paper(scene);
    std::string lines = terminal(scene, format) + "set encoding utf8\nset multiplot\n";
    std::string on_paper;
    for (const PlacedText& text : layout.texts)
        on_paper += paper.text(text);
    for (const PlacedSample& sample : layout.samples)
        on_paper += paper.sample(sample);
    for (std::size_t i = 0; i < scene.panels.size(); ++i) {
        // what belongs to the paper is drawn with the first panel, once
        lines += panel_script(scene, scene.panels[i], layout.panels[i], {on_paper, TickSide::left});
        on_paper.clear();
    }
    if (layout.colour_bar)
        lines +=
            panel_script(scene, colour_bar_panel(*scene.colour_bar), *layout.colour_bar, {on_paper, TickSide::right});
    return lines + "unset multiplot\n";
}

}  // namespace stridor::chart
