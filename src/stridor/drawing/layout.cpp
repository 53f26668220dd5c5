#include "stridor/drawing/layout.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/labels.hpp"
#include "stridor/drawing/legend.hpp"
#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace stridor::drawing {

namespace {

constexpr double margin = sheet_margin;
constexpr double least_gap = 2.0;       // [mm] between neighbouring panels
constexpr double bar_width = 3.5;       // [mm] of a colour bar
constexpr double least_panels = 0.4;    // [1] of the height that a scene asks for
constexpr double longest_label = 0.33;  // [1] of the sheet's width that a label beside an axis may take
constexpr int most_passes = 6;          // lines follow from widths, and widths from heights that lines leave

using Lines = std::vector<StyledText>;

// room needed on the four sides of a panel or, as the largest of them, of a row or column [mm]
struct Needs {
    double left = 0.0;
    double right = 0.0;
    double bottom = 0.0;
    double top = 0.0;
};

// what is written around a panel, in lines
struct PanelWords {
    Lines title;
    Lines x;
    Lines y;
    double before = 0.0;    // [mm] of the first number beyond the beginning of the x axis
    double overhang = 0.0;  // [mm] of the last number beyond its end
    bool operator==(const PanelWords&) const = default;
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
bool has_label(const PanelAxis& axis, const Tick& tick) {
    const double share = position(axis, tick.value);
    return share >= -1e-9 && share <= 1.0 + 1e-9 && !is_empty(tick.label);
}

double widest_label(const TickSet& set, double font_size) {
    double width = 0.0;
    for (const Tick& tick : set.ticks)
        width = std::max(width, text_width(tick.label, font_size));
    return width;
}

double lines_of(const Lines& lines) {
    return static_cast<double>(lines.size());
}

class Arranger {
public:
    Arranger(const Scene& scene, double height) : scene_(scene), mm_(measures(scene.font_size)) {
        layout_.height = height;
        layout_.panels.resize(scene.panels.size());
        words_.resize(scene.panels.size());
        for (std::size_t i = 0; i < scene.panels.size(); ++i)
            words_[i] = words_within(scene.panels[i], layout_.panels[i], {1e9, 1e9});
    }

    // once
    Layout arranged() {
        const double top = place_head();
        const double bottom = place_legend(scene_, layout_);
        for (int pass = 0; pass < most_passes; ++pass) {
            place_rows({bottom, top});
            place_columns({margin, scene_.width - margin});
            std::vector<PanelWords> words;
            for (std::size_t i = 0; i < words_.size(); ++i)
                words.push_back(words_within(scene_.panels[i], layout_.panels[i], room_of(layout_.panels[i].area)));
            if (std::exchange(words_, words) == words) break;
        }
        for (std::size_t i = 0; i < scene_.panels.size(); ++i)
            place_texts(scene_.panels[i], words_[i], layout_.panels[i]);
        if (layout_.colour_bar) place_bar_texts();
        return std::move(layout_);
    }

    // what all rows have for their panels [mm]; negative where the texts alone take more than the sheet
    double panels_height() const { return panels_height_; }

private:
    // [mm] along x and y
    struct Room {
        double width = 0.0;
        double height = 0.0;
    };

    const Scene& scene_;
    Measures mm_;
    Layout layout_;
    std::vector<PanelWords> words_;     // shape [panel]
    std::vector<double> y_title_left_;  // [mm] of each column's y titles
    double panels_height_ = 0.0;        // [mm]

    // an axis title may stand out a little at either end
    static Room room_of(const Rectangle& area) { return {width_of(area), height_of(area) + least_gap}; }

    PanelWords words_within(const Panel& panel, const PlacedPanel& placed, const Room& room) const {
        const double size = scene_.font_size;
        const auto lines = [&](const PanelAxis& axis, const TickSet& set, double length) {
            if (axis.text == AxisText::hidden || is_empty(axis.label)) return Lines{};
            return wrapped(axis_title(axis.label, axis.unit, set.exponent), size, length);
        };
        PanelWords words{wrapped(panel.title, size, room.width), lines(panel.x, placed.x, room.width + least_gap),
                         lines(panel.y, placed.y, room.height)};
        if (panel.x.text == AxisText::hidden) return words;
        for (const Tick& tick : placed.x.ticks) {
            if (!has_label(panel.x, tick)) continue;
            const double half = 0.5 * text_width(tick.label, size), share = position(panel.x, tick.value);
            words.before = std::max(words.before, half - share * room.width);
            words.overhang = std::max(words.overhang, half - (1.0 - share) * room.width);
        }
        return words;
    }

    void place(const StyledText& text, double x, double y, Align align) {
        layout_.texts.push_back({text, x, y, align, scene_.font_size, ink});
    }

    // title and caption; returns where the panels may begin
    double place_head() {
        const double width = scene_.width - 2.0 * margin;
        double y = layout_.height - margin;
        const double title_size = scene_.font_size + 1.0;
        if (scene_.title_text == TitleText::printed)
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

    // rows from the top down; y ticks follow from the heights
    void place_rows(Extent room) {
        std::vector<Needs> rows(scene_.row_heights.size());
        for (std::size_t i = 0; i < words_.size(); ++i) {
            const Panel& panel = scene_.panels[i];
            STRIDOR_EXPECT(panel.row < rows.size());
            Needs& row = rows[panel.row];
            row.top = std::max(row.top, mm_.line * lines_of(words_[i].title));
            if (panel.x.text == AxisText::shown)
                row.bottom = std::max(row.bottom, mm_.to_tick + mm_.em + mm_.line * lines_of(words_[i].x));
        }
        std::vector<double> gaps;
        for (std::size_t r = 0; r + 1 < rows.size(); ++r)
            gaps.push_back(rows[r].bottom + rows[r + 1].top + least_gap);
        room = {room.from + rows.back().bottom, room.to - rows.front().top};
        panels_height_ = room.to - room.from - std::accumulate(gaps.begin(), gaps.end(), 0.0);
        // counted downwards, then turned over
        const std::vector<Extent> parts = divided({0.0, room.to - room.from}, scene_.row_heights, gaps);
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            const Panel& panel = scene_.panels[i];
            PlacedPanel& placed = layout_.panels[i];
            placed.area.top = room.to - parts[panel.row].from;
            placed.area.bottom = room.to - parts[panel.row].to;
            placed.y = ticks(panel.y, height_of(placed.area), 1.6 * mm_.em);
            for (Tick& tick : placed.y.ticks)
                if (!panel.y.ticks.empty())
                    tick.label = fitted(tick.label, scene_.font_size, longest_label * scene_.width);
        }
        if (!scene_.colour_bar) return;
        const std::optional<std::size_t> row = scene_.colour_bar->row;
        const Extent along = row ? parts[*row] : Extent{0.0, parts.back().to};
        PlacedPanel bar;
        bar.area.bottom = room.to - along.to;
        bar.area.top = room.to - along.from;
        bar.y = ticks(bar_axis(), height_of(bar.area), 1.6 * mm_.em);
        layout_.colour_bar = bar;
    }

    Needs horizontal_needs(const Panel& panel, const PlacedPanel& placed, const PanelWords& words) const {
        Needs needs;
        if (panel.x.text == AxisText::shown) needs.right = std::max(1.2 * mm_.em, words.overhang + 0.2 * mm_.em);
        if (panel.y.text == AxisText::shown)
            needs.left = mm_.to_tick + widest_label(placed.y, scene_.font_size) + mm_.line * lines_of(words.y);
        if (panel.x.text == AxisText::shown) needs.left = std::max(needs.left, words.before + 0.2 * mm_.em);
        return needs;
    }

    // columns from the left; x ticks follow from the widths
    void place_columns(Extent room) {
        std::vector<Needs> columns(scene_.column_widths.size());
        for (std::size_t i = 0; i < scene_.panels.size(); ++i) {
            STRIDOR_EXPECT(scene_.panels[i].column < columns.size());
            const Needs needs = horizontal_needs(scene_.panels[i], layout_.panels[i], words_[i]);
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
            for (Tick& tick : layout_.panels[i].x.ticks)
                if (!panel.x.ticks.empty()) tick.label = fitted(tick.label, scene_.font_size, 0.5 * width_of(area));
        }
        y_title_left_.clear();
        for (std::size_t c = 0; c < columns.size(); ++c)
            y_title_left_.push_back(parts[c].from - columns[c].left + 0.5 * mm_.line);
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

    Lines bar_title() const {
        const PlacedPanel& bar = *layout_.colour_bar;
        return wrapped(axis_title(scene_.colour_bar->label, scene_.colour_bar->unit, bar.y.exponent), scene_.font_size,
                       height_of(bar.area) + least_gap);
    }

    // returns where the columns must end
    double place_bar_columns(double right) {
        PlacedPanel& bar = *layout_.colour_bar;
        const double numbers = mm_.to_tick + widest_label(bar.y, scene_.font_size);
        bar.area.right = right - numbers - mm_.line * lines_of(bar_title());
        bar.area.left = bar.area.right - bar_width;
        return bar.area.left - 1.2 * mm_.em;
    }

    void place_bar_texts() {
        const PlacedPanel& bar = *layout_.colour_bar;
        place_y_numbers(bar_axis(), bar, Align::left);
        const double numbers = mm_.to_tick + widest_label(bar.y, scene_.font_size);
        place_turned(bar_title(), bar.area.right + numbers + 0.5 * mm_.line, bar.area);
    }

    void place_x_numbers(const PanelAxis& axis, const PlacedPanel& placed) {
        const Rectangle& area = placed.area;
        std::vector<const Tick*> labelled;
        std::vector<Extent> ends;
        for (const Tick& tick : placed.x.ticks) {
            if (!has_label(axis, tick)) continue;
            const double half = 0.5 * text_width(tick.label, scene_.font_size);
            const double x = std::clamp(area.left + width_of(area) * position(axis, tick.value), margin + half,
                                        std::max(margin + half, scene_.width - margin - half));
            labelled.push_back(&tick);
            ends.push_back({x - half, x + half});
        }
        for (const std::size_t k : thinned(ends, 0.4 * mm_.em))
            place(labelled[k]->label, 0.5 * (ends[k].from + ends[k].to), area.bottom - mm_.to_tick - 0.4 * mm_.em,
                  Align::centre);
    }

    // right of the panel where they are aligned to the left
    void place_y_numbers(const PanelAxis& axis, const PlacedPanel& placed, Align align) {
        const Rectangle& area = placed.area;
        const double x = align == Align::left ? area.right + 0.8 * mm_.to_tick : area.left - 0.8 * mm_.to_tick;
        const double step = 1.1 * mm_.em;
        std::vector<const Tick*> labelled;
        for (const Tick& tick : placed.y.ticks)
            if (has_label(axis, tick)) labelled.push_back(&tick);
        std::sort(labelled.begin(), labelled.end(),
                  [&](const Tick* a, const Tick* b) { return position(axis, a->value) < position(axis, b->value); });
        const auto most = static_cast<std::size_t>(std::max(1.0, height_of(area) / step + 1.0));
        const std::size_t every = (labelled.size() + most - 1) / most;
        std::vector<double> places;
        for (std::size_t k = 0; k < labelled.size(); k += every)
            places.push_back(area.bottom + height_of(area) * position(axis, labelled[k]->value));
        places = spread(std::move(places), step);
        for (std::size_t k = 0; k < places.size(); ++k)
            place(labelled[k * every]->label, x, places[k], align);
    }

    // lines of a title that is read from below to above, the first at x
    void place_turned(const Lines& lines, double x, const Rectangle& beside) {
        for (std::size_t k = 0; k < lines.size(); ++k)
            layout_.texts.push_back({lines[k], x + static_cast<double>(k) * mm_.line,
                                     0.5 * (beside.bottom + beside.top), Align::centre, scene_.font_size, ink,
                                     PlacedText::Turn::quarter});
    }

    void place_texts(const Panel& panel, const PanelWords& words, PlacedPanel& placed) {
        const Rectangle& area = placed.area;
        if (panel.x.text == AxisText::shown) place_x_numbers(panel.x, placed);
        if (panel.y.text == AxisText::shown) place_y_numbers(panel.y, placed, Align::right);
        for (std::size_t k = 0; k < words.title.size(); ++k)
            place(words.title[k], area.left,
                  area.top + (lines_of(words.title) - static_cast<double>(k) - 0.45) * mm_.line, Align::left);
        for (std::size_t k = 0; k < words.x.size(); ++k)
            place(words.x[k], 0.5 * (area.left + area.right),
                  area.bottom - mm_.to_tick - mm_.em - (static_cast<double>(k) + 0.5) * mm_.line, Align::centre);
        place_turned(words.y, y_title_left_[panel.column], area);
        placed.notes = placed_notes(panel, area, scene_.font_size);
    }
};

}  // namespace

Layout arrange(const Scene& scene) {
    STRIDOR_EXPECT(!scene.column_widths.empty() && !scene.row_heights.empty());
    Arranger arranger(scene, scene.height);
    Layout layout = arranger.arranged();
    const double missing = least_panels * scene.height - arranger.panels_height();
    return missing > 0.0 ? Arranger(scene, scene.height + missing).arranged() : layout;
}

}  // namespace stridor::drawing
