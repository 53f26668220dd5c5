#include "stridor/chart/panel_script.hpp"

#include "stridor/chart/palette.hpp"
#include "stridor/chart/reduce.hpp"
#include "stridor/chart/script.hpp"
#include "stridor/chart/texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace stridor::chart {

namespace {

constexpr double columns_per_millimetre = png_resolution / 25.4;
constexpr std::size_t value_steps = 128;  // colours of a quantity; more are not told apart
// cells reach this far under the next ones above and to the right, which cover it again: no hairlines between [mm]
constexpr double overlap = 0.3;
// the palest shade of a strip: a state that is there for an instant only
constexpr double least_shade = 0.3;
constexpr double dot_diameter = 1.1;  // [pt] of a texture's dots

std::string number(double value) {
    return fmt::format("{:.9g}", value);
}

// the data blocks of a panel and the elements of the plot command that draws them
class LayerWriter {
public:
    LayerWriter(const Panel& panel, const Rectangle& area, double font_size)
        : panel_(panel),
          area_(area),
          font_size_(font_size) {}

    void operator()(const Line& line) {
        const Line kept = reduced(line, panel_.x, columns());
        std::string rows;
        for (std::size_t i = 0; i < kept.x.size(); ++i)
            rows += std::isnan(kept.y[i]) ? "\n" : number(kept.x[i]) + " " + number(kept.y[i]) + "\n";
        add(rows, "using 1:2 with lines " + line_style(line.stroke));
    }

    void operator()(const Points& points) {
        std::string rows;
        for (std::size_t i = 0; i < points.x.size(); ++i)
            if (!std::isnan(points.x[i]) && !std::isnan(points.y[i]))
                rows += number(points.x[i]) + " " + number(points.y[i]) + "\n";
        if (points.rim) add_dots(rows, *points.rim, rim_diameter(points));
        if (points.outline) add(rows, "using 1:2 with points " + point_style(points, *points.outline, outline_width));
        add(rows, "using 1:2 with points " + point_style(points, points.colour, 0.0));
    }

    void operator()(const Strip& strip) {
        std::string rows;
        for (const Shade& shade : shades(strip, panel_.x.range, columns())) {
            const auto row = static_cast<double>(shade.row);
            const Colour colour = tint(strip.rows[shade.row], least_shade + (1.0 - least_shade) * shade.share);
            rows += coloured_row({shade.x, {row + 0.1, row + 0.9}}, colour);
        }
        add(rows, coloured_boxes);
    }

    void operator()(const Boxes& boxes) {
        std::string rows;
        for (const Box& box : boxes.boxes)
            rows += coloured_row(clipped(box), boxes.fill.colour);
        add(rows, coloured_boxes);
        add_texture(boxes.boxes, boxes.fill);
    }

    void operator()(const CategoryCells& cells) {
        const std::vector<CellRun> runs = cell_runs(cells.x_edges, cells.y_edges, cells.kinds);
        std::string rows;
        for (const CellRun& run : runs)
            rows += coloured_row(grown(clipped(run.box)), cells.fills[run.kind].colour);
        add(rows, coloured_boxes);
        for (std::size_t kind = 0; kind < cells.fills.size(); ++kind) {
            std::vector<Box> boxes;
            for (const CellRun& run : runs)
                if (run.kind == kind) boxes.push_back(run.box);
            add_texture(boxes, cells.fills[kind]);
        }
    }

    void operator()(const ValueCells& cells) {
        std::vector<std::uint16_t> kinds;
        for (const double value : cells.values)
            kinds.push_back(static_cast<std::uint16_t>(colour_step(cells.colours, value)));
        std::string rows;
        std::vector<Box> missing;
        for (const CellRun& run : cell_runs(cells.x_edges, cells.y_edges, kinds)) {
            const bool is_missing = run.kind == value_steps;
            if (is_missing) missing.push_back(run.box);
            const double share = (static_cast<double>(run.kind) + 0.5) / static_cast<double>(value_steps);
            rows += coloured_row(grown(clipped(run.box)), is_missing ? cells.missing.colour : sequential(share));
        }
        add(rows, coloured_boxes);
        add_texture(missing, cells.missing);
    }

    void operator()(const Note& note) {
        constexpr std::string_view alignment[] = {"left", "center", "right"};
        const std::string place = note.anchor == Anchor::panel
                                      ? fmt::format("graph {:.6g},graph {:.6g}", note.x, note.y)
                                      : fmt::format("first {},first {}", number(note.x), number(note.y));
        commands_ += fmt::format("set label {} at {} {} font ',{:g}' tc rgb '{}' front\n", gnuplot_string(note.text),
                                 place, alignment[static_cast<std::size_t>(note.align)],
                                 note.size > 0.0 ? note.size : font_size_, hex(note.colour));
        if (note.ground) add_ground(note);
    }

    void operator()(const Rule& rule) {
        const Range& x = panel_.x.range;
        const Range& y = panel_.y.range;
        const std::string value = number(rule.value);
        const bool is_vertical = rule.orientation == Orientation::vertical;
        add(is_vertical ? fmt::format("{} {}\n{} {}\n", value, number(y.from), value, number(y.to))
                        : fmt::format("{} {}\n{} {}\n", number(x.from), value, number(x.to), value),
            "using 1:2 with lines " + line_style(rule.stroke));
    }

    std::string commands() const {
        std::string elements;
        for (const std::string& element : elements_)
            elements += (elements.empty() ? "" : ", \\\n     ") + element;
        // a panel without data still shows its axes
        return data_ + commands_ + "plot " + (elements.empty() ? "NaN notitle" : elements) + "\n";
    }

private:
    static constexpr std::string_view coloured_boxes =
        "using 1:2:3:4:5:6:7 with boxxyerror fs solid 1 noborder lc rgb variable";

    const Panel& panel_;
    const Rectangle& area_;
    double font_size_;
    std::size_t block_ = 0;
    std::string data_;
    std::string commands_;
    std::vector<std::string> elements_;

    std::size_t columns() const {
        return static_cast<std::size_t>(std::max(1.0, width_of(area_) * columns_per_millimetre));
    }

    void add(const std::string& rows, std::string_view style) {
        if (rows.find_first_not_of('\n') == std::string::npos) return;
        data_ += fmt::format("$data{} << END\n{}END\n", block_, rows);
        elements_.push_back(fmt::format("$data{} {} notitle", block_, style));
        ++block_;
    }

    void add_dots(const std::string& rows, Colour colour, double diameter) {
        Points disc;
        disc.diameter = diameter;
        add(rows, "using 1:2 with points " + point_style(disc, colour, 0.0));
    }

    static std::size_t colour_step(const ColourScale& colours, double value) {
        if (std::isnan(value)) return value_steps;
        Axis axis;
        axis.scale = colours.scale;
        axis.range = colours.range;
        const double share = position(axis, value);
        if (std::isnan(share)) return value_steps;
        return static_cast<std::size_t>(std::clamp(share, 0.0, 1.0 - 0.5 / value_steps) * value_steps);
    }

    Box clipped(const Box& box) const {
        const auto clip = [](const Range& part, const Range& whole) {
            return Range{std::clamp(part.from, whole.from, whole.to), std::clamp(part.to, whole.from, whole.to)};
        };
        return {clip(box.x, panel_.x.range), clip(box.y, panel_.y.range)};
    }

    // the box with `overlap` added above and to the right, but not beyond the panel
    Box grown(const Box& box) const {
        const auto grow = [](const Axis& axis, double to, double length) {
            return to >= axis.range.to ? to : value_at_position(axis, position(axis, to) + overlap / length);
        };
        return clipped({{box.x.from, grow(panel_.x, box.x.to, width_of(area_))},
                        {box.y.from, grow(panel_.y, box.y.to, height_of(area_))}});
    }

    std::string coloured_row(const Box& box, Colour colour) const {
        const unsigned rgb = colour.red * 0x10000U + colour.green * 0x100U + colour.blue;
        return fmt::format("{0} {2} {0} {1} {2} {3} {4}\n", number(box.x.from), number(box.x.to), number(box.y.from),
                           number(box.y.to), rgb);
    }

    Rectangle on_paper(const Box& box) const {
        const auto place = [](const Axis& axis, double value, double from, double length) {
            return from + length * position(axis, value);
        };
        return {place(panel_.x, box.x.from, area_.left, width_of(area_)),
                place(panel_.x, box.x.to, area_.left, width_of(area_)),
                place(panel_.y, box.y.from, area_.bottom, height_of(area_)),
                place(panel_.y, box.y.to, area_.bottom, height_of(area_))};
    }

    std::string data_point(double x, double y) const {
        return number(value_at_position(panel_.x, (x - area_.left) / width_of(area_))) + " " +
               number(value_at_position(panel_.y, (y - area_.bottom) / height_of(area_))) + "\n";
    }

    void add_texture(const std::vector<Box>& boxes, const Fill& fill) {
        std::vector<Rectangle> areas;
        for (const Box& box : boxes)
            areas.push_back(on_paper(clipped(box)));
        const Pattern strokes = pattern(fill.texture, areas);
        std::string lines;
        for (const Segment& s : strokes.lines)
            lines += data_point(s.x0, s.y0) + data_point(s.x1, s.y1) + "\n";
        add(lines, "using 1:2 with lines " + line_style({fill.ink, texture_width, Dash::solid}));
        std::string dots;
        for (const Dot& dot : strokes.dots)
            dots += data_point(dot.x, dot.y);
        add_dots(dots, fill.ink, dot_diameter);
    }

    // a patch that keeps a texture away from the letters
    void add_ground(const Note& note) {
        Axis unit;
        const bool is_data = note.anchor == Anchor::data;
        const double x = area_.left + width_of(area_) * position(is_data ? panel_.x : unit, note.x);
        const double y = area_.bottom + height_of(area_) * position(is_data ? panel_.y : unit, note.y);
        const double size = note.size > 0.0 ? note.size : font_size_;
        const Extent extent = note_extent(note.text, size);
        const double left = note.align == Align::left     ? x - 0.1 * extent.height
                            : note.align == Align::centre ? x - 0.5 * extent.width
                                                          : x - extent.width;
        const Rectangle patch{left, left + extent.width, y - 0.5 * extent.height, y + 0.5 * extent.height};
        const auto share = [](double value, double from, double length) { return (value - from) / length; };
        const Box box{{value_at_position(panel_.x, share(patch.left, area_.left, width_of(area_))),
                       value_at_position(panel_.x, share(patch.right, area_.left, width_of(area_)))},
                      {value_at_position(panel_.y, share(patch.bottom, area_.bottom, height_of(area_))),
                       value_at_position(panel_.y, share(patch.top, area_.bottom, height_of(area_)))}};
        add(coloured_row(clipped(box), *note.ground), coloured_boxes);
    }
};

std::string tick_list(const TickSet& set, AxisText text) {
    std::string list;
    for (const Tick& tick : set.ticks) {
        std::string label = text == AxisText::shown ? gnuplot_string(tick.label) : "''";
        // a tick's label is also a number format
        for (std::size_t at = label.find('%'); at != std::string::npos; at = label.find('%', at + 2))
            label.insert(at, 1, '%');
        list +=
            (list.empty() ? "" : ", ") + label + " " + number(tick.value) + (tick.size == TickSize::minor ? " 1" : "");
    }
    return "(" + list + ")";
}

std::string axis_commands(const Panel& panel, const PlacedPanel& placed, TickSide side) {
    const std::string_view y = side == TickSide::left ? "y" : "y2";
    std::string lines;
    lines += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset y2range [{}:{}]\n", number(panel.x.range.from),
                         number(panel.x.range.to), number(panel.y.range.from), number(panel.y.range.to),
                         number(panel.y.range.from), number(panel.y.range.to));
    if (panel.x.scale == AxisScale::logarithmic) lines += "set logscale x\n";
    if (panel.y.scale == AxisScale::logarithmic) lines += "set logscale y\nset logscale y2\n";
    const std::string look = fmt::format("out nomirror scale 0.5,0.3 textcolor rgb '{}'", hex(ink));
    lines += "unset xtics\nunset ytics\n";
    if (!placed.x.ticks.empty())
        lines += fmt::format("set xtics {} offset 0,0.25 {}\n", look, tick_list(placed.x, panel.x.text));
    if (!placed.y.ticks.empty())
        lines += fmt::format("set {}tics {} offset {},0 {}\n", y, look, side == TickSide::left ? "0.4" : "-0.4",
                             tick_list(placed.y, panel.y.text));
    if (panel.grid != Grid::none)
        lines += fmt::format("set grid xtics {} back lt 1 lc rgb '{}' lw 0.4 dt solid\n",
                             panel.grid == Grid::both ? "ytics" : "noytics", hex(grid_ink));
    return lines;
}

}  // namespace

std::string line_style(const Stroke& stroke) {
    constexpr std::string_view dashes[] = {"solid", "(9,5)", "(2,4)"};
    return fmt::format("lc rgb '{}' lw {:.4g} dt {}", hex(stroke.colour), stroke.width,
                       dashes[static_cast<std::size_t>(stroke.dash)]);
}

std::string point_style(const Points& points, Colour colour, double wider) {
    constexpr int types[] = {7, 5, 9, 13, 11, 2};  // gnuplot's, in the order of Mark
    // one unit of point size is about 6.6 pt wide for the disc
    return fmt::format("pt {} ps {:.4g} lc rgb '{}'", types[static_cast<std::size_t>(points.mark)],
                       (points.diameter + wider) / 6.6, hex(colour));
}

double rim_diameter(const Points& points) {
    return 2.0 * points.diameter;
}

Extent note_extent(const Text& text, double size) {
    const double em = size * 25.4 / 72.0;
    return {text_width(text, size) + 0.6 * em, 1.4 * em};
}

std::string panel_script(const Scene& scene, const Panel& panel, const PlacedPanel& placed,
                         const PanelContext& context) {
    const Rectangle& area = placed.area;
    LayerWriter layers(panel, area, scene.font_size);
    for (const Layer& layer : panel.layers)
        std::visit(layers, layer);
    return "reset\nunset key\n" +
           fmt::format("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n", area.left / scene.width,
                       area.right / scene.width) +
           fmt::format("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n", area.bottom / scene.height,
                       area.top / scene.height) +
           fmt::format("set border {} lc rgb '{}' lw 0.5\n", panel.frame == Frame::closed ? 15 : 3, hex(ink)) +
           axis_commands(panel, placed, context.y_ticks) + context.decorations + layers.commands();
}

}  // namespace stridor::chart
