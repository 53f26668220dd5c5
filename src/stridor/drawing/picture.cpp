#include "stridor/drawing/picture.hpp"

#include "stridor/base/error.hpp"
#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/drawing/reduce.hpp"
#include "stridor/drawing/ticks.hpp"

#include <algorithm>
#include <cmath>

namespace stridor::drawing {

namespace {

constexpr double columns_per_millimetre = png_resolution / 25.4;
constexpr std::size_t value_steps = 128;  // colours of a quantity; more are not told apart
// cells reach this far under the next ones above and to the right, which cover it again: no hairlines between [mm]
constexpr double overlap = 0.3;
// the palest shade of a strip: a state that is there for an instant only
constexpr double least_shade = 0.3;
constexpr double texture_width = 0.45;  // [pt] of the lines of a texture
constexpr double dot_diameter = 1.1;    // [pt] of a texture's dots
constexpr double outline_width = 0.9;   // [pt] added to a point's diameter by its outline
constexpr double frame_width = 0.5;     // [pt]
constexpr double hairline = 0.4;        // [pt] of the grid and around samples

bool is_within(double share) {
    return share >= -axis_slack && share <= 1.0 + axis_slack;
}

void draw_texture(Page& page, const Fill& fill, std::span<const Rectangle> areas, double spacing) {
    const Pattern strokes = pattern(fill.texture, areas, spacing);
    page.segments(strokes.lines, {fill.ink, texture_width, Dash::solid});
    page.marks(strokes.dots, Mark::disc, dot_diameter, fill.ink);
}

void draw_points(Page& page, std::span<const Dot> middles, const Points& points) {
    if (points.rim) page.marks(middles, Mark::disc, 2.0 * points.diameter, *points.rim);
    if (points.outline) page.marks(middles, points.mark, points.diameter + outline_width, *points.outline);
    page.marks(middles, points.mark, points.diameter, points.colour);
}

// fills areas in their order, neighbours of one colour at once
class Painter {
public:
    explicit Painter(Page& page) : page_(page) {}

    void add(const Rectangle& area, Colour colour) {
        if (!(width_of(area) > 0.0 && height_of(area) > 0.0)) return;
        if (!(colour == colour_)) flush();
        colour_ = colour;
        areas_.push_back(area);
    }

    void flush() {
        page_.fill(areas_, colour_);
        areas_.clear();
    }

private:
    Page& page_;
    std::vector<Rectangle> areas_;
    Colour colour_;
};

class LayerDrawer {
public:
    LayerDrawer(Page& page, const Panel& panel, const Rectangle& area) : page_(page), panel_(panel), area_(area) {}

    void operator()(const Line& line) const {
        // a thick line along an edge keeps its width
        const double rim = 0.5 * line.stroke.width * millimetres_per_point;
        page_.begin_clip({area_.left - rim, area_.right + rim, area_.bottom - rim, area_.top + rim});
        const Line kept = reduced(line, panel_.x, columns());
        std::vector<Dot> points;
        const auto end = [&] {
            page_.curve(points, line.stroke);
            points.clear();
        };
        for (std::size_t i = 0; i < kept.x.size(); ++i) {
            const Dot point = at(kept.x[i], kept.y[i]);
            if (std::isfinite(point.x) && std::isfinite(point.y))
                points.push_back(near(point));
            else
                end();
        }
        end();
        page_.end_clip();
    }

    void operator()(const Points& points) const {
        std::vector<Dot> middles;
        for (std::size_t i = 0; i < points.x.size(); ++i)
            if (is_within(position(panel_.x, points.x[i])) && is_within(position(panel_.y, points.y[i])))
                middles.push_back(at(points.x[i], points.y[i]));
        if (points.columns == 0 || points.rows == 0) return draw_points(page_, middles, points);
        const double cell = std::min(width_of(area_) / static_cast<double>(points.columns),
                                     height_of(area_) / static_cast<double>(points.rows));
        Points small = points;
        small.diameter = std::min(points.diameter, 0.35 * cell / millimetres_per_point);
        draw_points(page_, middles, small);
    }

    void operator()(const Strip& strip) const {
        std::vector<Shade> parts = shades(strip, panel_.x.range, columns());
        std::stable_sort(parts.begin(), parts.end(), [](const Shade& a, const Shade& b) {
            return a.row != b.row ? a.row < b.row : a.share < b.share;
        });
        Painter painter(page_);
        for (const Shade& shade : parts) {
            const auto row = static_cast<double>(shade.row);
            painter.add(on_paper({shade.x, {row + 0.1, row + 0.9}}),
                        tint(strip.rows[shade.row], least_shade + (1.0 - least_shade) * shade.share));
        }
        painter.flush();
    }

    void operator()(const Boxes& boxes) const {
        Painter painter(page_);
        for (const Box& box : boxes.boxes)
            painter.add(on_paper(box), boxes.fill.colour);
        painter.flush();
        add_texture(boxes.boxes, boxes.fill);
    }

    void operator()(const CategoryCells& cells) const {
        const std::vector<CellRun> runs = cell_runs(cells.x_edges, cells.y_edges, cells.kinds);
        Painter painter(page_);
        for (const CellRun& run : runs)
            painter.add(grown(on_paper(run.box)), cells.fills[run.kind].colour);
        painter.flush();
        for (std::size_t kind = 0; kind < cells.fills.size(); ++kind) {
            std::vector<Box> boxes;
            for (const CellRun& run : runs)
                if (run.kind == kind) boxes.push_back(run.box);
            add_texture(boxes, cells.fills[kind]);
        }
    }

    void operator()(const ValueCells& cells) const {
        std::vector<std::uint16_t> kinds;
        for (const double value : cells.values)
            kinds.push_back(static_cast<std::uint16_t>(colour_step(cells.colours, value)));
        std::vector<Box> missing;
        Painter painter(page_);
        for (const CellRun& run : cell_runs(cells.x_edges, cells.y_edges, kinds)) {
            const bool is_missing = run.kind == value_steps;
            if (is_missing) missing.push_back(run.box);
            const double share = (static_cast<double>(run.kind) + 0.5) / static_cast<double>(value_steps);
            painter.add(grown(on_paper(run.box)), is_missing ? cells.missing.colour : sequential(share));
        }
        painter.flush();
        add_texture(missing, cells.missing);
    }

    // their letters stand over all layers
    void operator()(const Note&) const {}
    void operator()(const RegionNames&) const {}

    void operator()(const Rule& rule) const {
        const bool is_vertical = rule.orientation == Orientation::vertical;
        const double share = position(is_vertical ? panel_.x : panel_.y, rule.value);
        if (!is_within(share)) return;
        const double x = area_.left + share * width_of(area_);
        const double y = area_.bottom + share * height_of(area_);
        const Dot ends[] = {is_vertical ? Dot{x, area_.bottom} : Dot{area_.left, y},
                            is_vertical ? Dot{x, area_.top} : Dot{area_.right, y}};
        page_.curve(ends, rule.stroke, LineEnd::butt);
    }

    // the patch that keeps lines and textures away from the letters of a note
    void draw_ground(const PlacedNote& note) const {
        if (!note.ground) return;
        const PlacedText& text = note.text;
        const TextExtent extent = note_extent(text.text, text.size);
        const double air = 0.5 * (extent.width - text_width(text.text, text.size));
        const double before = text.align == Align::left ? 0.0 : text.align == Align::centre ? 0.5 : 1.0;
        const double left = text.x - air - before * (extent.width - 2.0 * air);
        page_.fill(clipped({left, left + extent.width, text.y - 0.5 * extent.height, text.y + 0.5 * extent.height}),
                   *note.ground);
    }

private:
    Page& page_;
    const Panel& panel_;
    const Rectangle& area_;

    std::size_t columns() const {
        return static_cast<std::size_t>(std::max(1.0, width_of(area_) * columns_per_millimetre));
    }

    Dot at(double x, double y) const {
        return {area_.left + width_of(area_) * position(panel_.x, x),
                area_.bottom + height_of(area_) * position(panel_.y, y)};
    }

    // cairo counts in fixed-point numbers: what lies a kilometre away is drawn as if it lay nearer
    static Dot near(const Dot& point) {
        constexpr double far = 1e5;  // [mm]
        return {std::clamp(point.x, -far, far), std::clamp(point.y, -far, far)};
    }

    static std::size_t colour_step(const ColourScale& colours, double value) {
        if (std::isnan(value)) return value_steps;
        PanelAxis axis;
        axis.scale = colours.scale;
        axis.range = colours.range;
        const double share = position(axis, value);
        if (std::isnan(share)) return value_steps;
        return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0 - 0.5 / value_steps) * value_steps);
    }

    Rectangle clipped(const Rectangle& part) const {
        return {std::clamp(part.left, area_.left, area_.right), std::clamp(part.right, area_.left, area_.right),
                std::clamp(part.bottom, area_.bottom, area_.top), std::clamp(part.top, area_.bottom, area_.top)};
    }

    Rectangle on_paper(const Box& box) const {
        const Dot low = at(box.x.from, box.y.from);
        const Dot high = at(box.x.to, box.y.to);
        return clipped({low.x, high.x, low.y, high.y});
    }

    Rectangle grown(const Rectangle& part) const {
        return clipped({part.left, part.right + overlap, part.bottom, part.top + overlap});
    }

    void add_texture(const std::vector<Box>& boxes, const Fill& fill) const {
        std::vector<Rectangle> areas;
        for (const Box& box : boxes)
            areas.push_back(on_paper(box));
        draw_texture(page_, fill, areas, 1.3);
    }
};

// where the ticks of one size stand: shares of the axis
std::vector<double> places(const PanelAxis& axis, const TickSet& set, TickSize size) {
    std::vector<double> shares;
    for (const Tick& tick : set.ticks)
        if (tick.size == size && is_within(position(axis, tick.value))) shares.push_back(position(axis, tick.value));
    return shares;
}

void draw_grid(Page& page, const Panel& panel, const PlacedPanel& placed) {
    const Rectangle& area = placed.area;
    std::vector<Segment> lines;
    if (panel.grid != Grid::none)
        for (const double share : places(panel.x, placed.x, TickSize::major)) {
            const double x = area.left + share * width_of(area);
            lines.push_back({x, area.bottom, x, area.top});
        }
    if (panel.grid == Grid::both)
        for (const double share : places(panel.y, placed.y, TickSize::major)) {
            const double y = area.bottom + share * height_of(area);
            lines.push_back({area.left, y, area.right, y});
        }
    page.segments(lines, {grid_ink, hairline, Dash::solid});
}

void draw_frame(Page& page, const Panel& panel, const PlacedPanel& placed, TickSide side) {
    const Rectangle& area = placed.area;
    const Stroke stroke{ink, frame_width, Dash::solid};
    std::vector<Segment> ticks;
    for (const TickSize size : {TickSize::major, TickSize::minor}) {
        const double length = size == TickSize::major ? 0.8 : 0.5;  // [mm]
        for (const double share : places(panel.x, placed.x, size)) {
            const double x = area.left + share * width_of(area);
            ticks.push_back({x, area.bottom, x, area.bottom - length});
        }
        for (const double share : places(panel.y, placed.y, size)) {
            const double y = area.bottom + share * height_of(area);
            const double from = side == TickSide::left ? area.left : area.right;
            ticks.push_back({from, y, side == TickSide::left ? from - length : from + length, y});
        }
    }
    page.segments(ticks, stroke);
    if (panel.frame == Frame::closed) return page.outline(area, stroke);
    const Dot axes[] = {{area.left, area.top}, {area.left, area.bottom}, {area.right, area.bottom}};
    page.curve(axes, stroke);
}

Panel colour_bar_panel(const ColourBar& bar) {
    constexpr std::size_t steps = 128;
    Panel panel;
    panel.frame = Frame::closed;
    panel.x.range = {0.0, 1.0};
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

void draw_panel(Page& page, const Panel& panel, const PlacedPanel& placed, TickSide side) {
    draw_grid(page, panel, placed);
    const LayerDrawer drawer(page, panel, placed.area);
    for (std::size_t layer = 0; layer < panel.layers.size(); ++layer) {
        std::visit(drawer, panel.layers[layer]);
        for (const PlacedNote& note : placed.notes)
            if (note.layer == layer) drawer.draw_ground(note);
    }
    draw_frame(page, panel, placed, side);
    for (const PlacedNote& note : placed.notes)
        page.text(note.text);
}

void draw_sample(Page& page, const PlacedSample& placed) {
    const Rectangle& area = placed.area;
    const double y = 0.5 * (area.bottom + area.top);
    if (const Stroke* stroke = std::get_if<Stroke>(&placed.sample)) {
        const Dot ends[] = {{area.left, y}, {area.right, y}};
        page.curve(ends, *stroke, LineEnd::butt);
    } else if (const Points* points = std::get_if<Points>(&placed.sample)) {
        const Dot middle{0.5 * (area.left + area.right), y};
        draw_points(page, {&middle, 1}, *points);
    } else {
        const Fill& fill = std::get<Fill>(placed.sample);
        page.fill(area, fill.colour);
        // a sample is small: a denser texture shows what it is, and no dot is cut by its edge
        const Rectangle inside{area.left + 0.3, area.right - 0.3, area.bottom + 0.3, area.top - 0.3};
        draw_texture(page, fill, {fill.texture == Texture::dots ? &inside : &area, 1}, 1.1);
        page.outline(area, {quiet_ink, hairline, Dash::solid});
    }
}

Format format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".png") return Format::png;
    if (extension == ".svg") return Format::svg;
    if (extension == ".pdf") return Format::pdf;
    throw Error(ErrorKind::input, {"cannot draw into " + path.string(), "a picture is a .png, .svg or .pdf file",
                                   "Give the name one of these endings."});
}

std::string render(const Scene& scene, Format format) {
    const Layout layout = arrange(scene);
    Page page(scene.width, layout.height, format, plain_text(scene.title));
    for (std::size_t i = 0; i < scene.panels.size(); ++i)
        draw_panel(page, scene.panels[i], layout.panels[i], TickSide::left);
    if (layout.colour_bar) draw_panel(page, colour_bar_panel(*scene.colour_bar), *layout.colour_bar, TickSide::right);
    for (const PlacedSample& sample : layout.samples)
        draw_sample(page, sample);
    for (const PlacedText& text : layout.texts)
        page.text(text);
    return page.finished();
}

}  // namespace stridor::drawing
