#include "stridor/drawing/layout.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <numeric>

namespace stridor::drawing {

namespace {

constexpr double margin = 1.5;         // [mm] around everything
constexpr double least_gap = 2.0;      // [mm] between neighbouring panels
constexpr double bar_width = 3.5;      // [mm] of a colour bar
constexpr double sample_width = 6.0;   // [mm] in the legend
constexpr double sample_height = 2.6;  // [mm]

// lengths that follow from the text size [mm]
struct Measures {
    double em = 0.0;
    double line = 0.0;     // from one line of text to the next
    double to_tick = 0.0;  // from an axis line to its numbers
};

Measures measures(double font_size) {
    const double em = font_size * millimetres_per_point;
    return {em, 1.35 * em, 0.75 * em};
}

// room needed on the four sides of a panel or, as the largest of them, of a row or column [mm]
struct Needs {
    double left = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    double top = 0.0;
};

// one direction of the grid: where each row or column begins and ends [mm]
std::vector<Extent> divided(Extent room, const std::vector<double>& shares, const std::vector<double>& gaps) {
    const double total = std::accumulate(shares.begin(), shares.end(), 0.0);
    const double length = room.to - room.from - std::accumulate(gaps.begin(), gaps.end(), 0.0);
    std::vector<Extent> parts;
    double from = room.from;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double to = from + std::max(1.0, length * shares[i] / total);
        parts.push_back({from, to});
        from = to + (i < gaps.size() ? gaps[i] : 0.0);
    }
    return parts;
}

// a tick that the axis brought along may lie beyond its end
bool is_on(const PanelAxis& axis, const Tick& tick) {
    const double share = position(axis, tick.value);
    return share >= -1e-9 && share <= 1.0 + 1e-9;
}

double widest_label(const TickSet& set, double font_size) {
    double width = 0.0;
    for (const Tick& tick : set.ticks)
        width = std::max(width, text_width(tick.label, font_size));
    return width;
}

class Arranger {
public:
    explicit Arranger(const Scene& scene) : scene_(scene), mm_(measures(scene.font_size)) {
        layout_.panels.resize(scene.panels.size());
    }

    Layout arranged() && {
        const double top = place_head();
        const double bottom = place_legend();
        place_rows({bottom, top});
        place_columns({margin, scene_.width - margin});
        for (std::size_t i = 0; i < scene_.panels.size(); ++i)
            place_texts(scene_.panels[i], layout_.panels[i]);
        if (layout_.colour_bar) place_y_numbers(bar_axis(), *layout_.colour_bar, Align::left);
        return std::move(layout_);
    }

private:
    const Scene& scene_;
    Measures mm_;
    Layout layout_;
    std::vector<double> axis_title_left_;  // [mm] of each column's y titles

    // title and caption; returns where the panels may begin
    double place_head() {
        const double width = scene_.width - 2.0 * margin;
        double y = scene_.height - margin;
        const double title_size = scene_.font_size + 1.0;
        for (const StyledText& line : wrapped(bold(scene_.title), title_size, width)) {
            layout_.texts.push_back({line, margin, y - 0.6 * mm_.line, Align::left, title_size, ink});
            y -= 1.15 * mm_.line;
        }
        for (const StyledText& paragraph : scene_.caption)
            for (const StyledText& line : wrapped(paragraph, scene_.font_size, width)) {
                layout_.texts.push_back({line, margin, y - 0.5 * mm_.line, Align::left, scene_.font_size, quiet_ink});
                y -= mm_.line;
            }
        return y - mm_.em * 0.5;
    }

    static StyledText bold(StyledText text) {
        for (TextRun& run : text.runs)
            if (run.style == TextStyle::plain) run.style = TextStyle::bold;
        return text;
    }

    double entry_width(const LegendEntry& entry) const {
        return sample_width + 0.5 * mm_.em + text_width(entry.text, scene_.font_size) + 1.5 * mm_.em;
    }

    // entries side by side, in as many lines as they need; returns where the panels may end
    double place_legend() {
        std::vector<std::vector<const LegendEntry*>> lines;
        double width = 0.0;
        for (const LegendEntry& entry : scene_.legend) {
            width += entry_width(entry);
            if (lines.empty() || width > scene_.width - 2.0 * margin) {
                lines.emplace_back();
                width = entry_width(entry);
            }
            lines.back().push_back(&entry);
        }
        const double step = 1.25 * mm_.line;
        double y = margin + step * static_cast<double>(lines.size());
        const double top = lines.empty() ? y : y + 0.5 * mm_.em;
        for (const auto& line : lines) {
            place_legend_line(line, y - 0.5 * step);
            y -= step;
        }
        return top;
    }

    void place_legend_line(const std::vector<const LegendEntry*>& line, double y) {
        double width = -1.5 * mm_.em;
        for (const LegendEntry* entry : line)
            width += entry_width(*entry);
        double x = std::max(margin, 0.5 * (scene_.width - width));
        for (const LegendEntry* entry : line) {
            const Rectangle area{x, x + sample_width, y - 0.5 * sample_height, y + 0.5 * sample_height};
            layout_.samples.push_back({area, entry->sample});
            layout_.texts.push_back({entry->text, area.right + 0.5 * mm_.em, y, Align::left, scene_.font_size, ink});
            x += entry_width(*entry);
        }
    }

    Needs vertical_needs(const Panel& panel) const {
        Needs needs;
        if (!is_empty(panel.title)) needs.top = mm_.line;
        if (panel.x.text == AxisText::shown) {
            needs.bottom = mm_.to_tick + mm_.em;
            if (!is_empty(panel.x.label)) needs.bottom += mm_.line;
        }
        return needs;
    }

    // rows from the top down; y ticks follow from the heights
    void place_rows(Extent room) {
        std::vector<Needs> rows(scene_.row_heights.size());
        for (const Panel& panel : scene_.panels) {
            STRIDOR_EXPECT(panel.row < rows.size());
            const Needs needs = vertical_needs(panel);
            rows[panel.row].top = std::max(rows[panel.row].top, needs.top);
            rows[panel.row].bottom = std::max(rows[panel.row].bottom, needs.bottom);
        }
        std::vector<double> gaps;
        for (std::size_t r = 0; r + 1 < rows.size(); ++r)
            gaps.push_back(rows[r].bottom + rows[r + 1].top + least_gap);
        room = {room.from + rows.back().bottom, room.to - rows.front().top};
        // counted downwards, then turned over
        const std::vector<Extent> parts = divided({0.0, room.to - room.from}, scene_.row_heights, gaps);
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            Rectangle& area = layout_.panels[i].area;
            area.top = room.to - parts[scene_.panels[i].row].from;
            area.bottom = room.to - parts[scene_.panels[i].row].to;
            layout_.panels[i].y = ticks(scene_.panels[i].y, height_of(area), 1.6 * mm_.em);
        }
        if (!scene_.colour_bar) return;
        const std::optional<std::size_t> row = scene_.colour_bar->row;
        const Extent along = row ? parts[*row] : Extent{0.0, parts.back().to};
        place_bar_rows({room.to - along.to, room.to - along.from});
    }

    Needs horizontal_needs(const Panel& panel, const PlacedPanel& placed) const {
        Needs needs;
        if (panel.x.text == AxisText::shown) needs.right = 1.2 * mm_.em;
        if (panel.y.text == AxisText::shown) {
            needs.left = mm_.to_tick + widest_label(placed.y, scene_.font_size);
            if (!is_empty(panel.y.label)) needs.left += mm_.line;
        }
        return needs;
    }

    // columns from the left; x ticks follow from the widths
    void place_columns(Extent room) {
        std::vector<Needs> columns(scene_.column_widths.size());
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            STRIDOR_EXPECT(scene_.panels[i].column < columns.size());
            const Needs needs = horizontal_needs(scene_.panels[i], layout_.panels[i]);
            Needs& column = columns[scene_.panels[i].column];
            column.left = std::max(column.left, needs.left);
            column.right = std::max(column.right, needs.right);
        }
        std::vector<double> gaps;
        for (std::size_t c = 0; c + 1 < columns.size(); ++c)
            gaps.push_back(columns[c].right + columns[c + 1].left + least_gap);
        room = {room.from + columns.front().left, room.to - columns.back().right};
        if (scene_.colour_bar) room.to = place_bar_columns(room.to);
        const std::vector<Extent> parts = divided(room, scene_.column_widths, gaps);
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            const Panel& panel = scene_.panels[i];
            Rectangle& area = layout_.panels[i].area;
            area.left = parts[panel.column].from;
            area.right = parts[panel.column].to;
            layout_.panels[i].x = ticks(panel.x, width_of(area), 4.5 * mm_.em);
        }
        for (std::size_t c = 0; c < columns.size(); ++c)
            axis_title_left_.push_back(parts[c].from - columns[c].left + 0.5 * mm_.line);
    }

    PanelAxis bar_axis() const {
        const ColourBar& bar = *scene_.colour_bar;
        PanelAxis axis;
        axis.label = bar.label;
        axis.unit = bar.unit;
        axis.scale = bar.colours.scale;
        axis.range = bar.colours.range;
        return axis;
    }

    void place_bar_rows(Extent rows) {
        PlacedPanel bar;
        bar.area.bottom = rows.from;
        bar.area.top = rows.to;
        bar.y = ticks(bar_axis(), height_of(bar.area), 1.6 * mm_.em);
        layout_.colour_bar = bar;
    }

    // returns where the columns must end
    double place_bar_columns(double right) {
        PlacedPanel& bar = *layout_.colour_bar;
        const StyledText title = axis_title(scene_.colour_bar->label, scene_.colour_bar->unit, bar.y.exponent);
        const double numbers = mm_.to_tick + widest_label(bar.y, scene_.font_size);
        bar.area.right = right - numbers - (is_empty(title) ? 0.0 : mm_.line);
        bar.area.left = bar.area.right - bar_width;
        if (!is_empty(title))
            layout_.texts.push_back({title, right - 0.5 * mm_.line, 0.5 * (bar.area.bottom + bar.area.top),
                                     Align::centre, scene_.font_size, ink, PlacedText::Turn::quarter});
        return bar.area.left - 1.2 * mm_.em;
    }

    void place_x_numbers(const PanelAxis& axis, const PlacedPanel& placed) {
        const Rectangle& area = placed.area;
        for (const Tick& tick : placed.x.ticks)
            if (is_on(axis, tick) && !is_empty(tick.label))
                layout_.texts.push_back({tick.label, area.left + width_of(area) * position(axis, tick.value),
                                         area.bottom - mm_.to_tick - 0.4 * mm_.em, Align::centre, scene_.font_size,
                                         ink});
    }

    // right of the panel where they are aligned to the left
    void place_y_numbers(const PanelAxis& axis, const PlacedPanel& placed, Align align) {
        const Rectangle& area = placed.area;
        const double x = align == Align::left ? area.right + 0.8 * mm_.to_tick : area.left - 0.8 * mm_.to_tick;
        for (const Tick& tick : placed.y.ticks)
            if (is_on(axis, tick) && !is_empty(tick.label))
                layout_.texts.push_back({tick.label, x, area.bottom + height_of(area) * position(axis, tick.value),
                                         align, scene_.font_size, ink});
    }

    void place_texts(const Panel& panel, const PlacedPanel& placed) {
        if (panel.x.text == AxisText::shown) place_x_numbers(panel.x, placed);
        if (panel.y.text == AxisText::shown) place_y_numbers(panel.y, placed, Align::right);
        const Rectangle& area = placed.area;
        const double size = scene_.font_size;
        if (!is_empty(panel.title))
            layout_.texts.push_back({panel.title, area.left, area.top + 0.55 * mm_.line, Align::left, size, ink});
        if (panel.x.text == AxisText::shown && !is_empty(panel.x.label))
            layout_.texts.push_back({axis_title(panel.x.label, panel.x.unit, placed.x.exponent),
                                     0.5 * (area.left + area.right),
                                     area.bottom - mm_.to_tick - mm_.em - 0.5 * mm_.line, Align::centre, size, ink});
        if (panel.y.text == AxisText::shown && !is_empty(panel.y.label))
            layout_.texts.push_back({axis_title(panel.y.label, panel.y.unit, placed.y.exponent),
                                     axis_title_left_[panel.column], 0.5 * (area.bottom + area.top), Align::centre,
                                     size, ink, PlacedText::Turn::quarter});
    }
};

}  // namespace

Layout arrange(const Scene& scene) {
    STRIDOR_EXPECT(!scene.column_widths.empty() && !scene.row_heights.empty());
    return Arranger(scene).arranged();
}

}  // namespace stridor::drawing
