#include "stridor/drawing/labels.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace stridor::drawing {

namespace {

// without its last letter, however many bytes it has
void shorten(StyledText& text) {
    std::string& last = text.runs.back().text;
    while (last.size() > 1 && (static_cast<unsigned char>(last.back()) & 0xC0U) == 0x80U)
        last.pop_back();
    last.pop_back();
    if (last.empty()) text.runs.pop_back();
}

// places that had to move together, around the mean of where they would stand
struct Cluster {
    double sum = 0.0;  // of the places, each less what the earlier ones of its cluster take
    std::size_t count = 0;

    double first() const { return sum / static_cast<double>(count); }
};

struct NamePlace {
    std::uint32_t row = 0;
    std::uint32_t column = 0;
};

// the cells of a map with their edges on paper [mm]
class Map {
public:
    Map(const CategoryCells& cells, const Panel& panel, const Rectangle& area) : cells_(cells) {
        for (const double edge : cells.x_edges)
            x_.push_back(area.left + width_of(area) * position(panel.x, edge));
        for (const double edge : cells.y_edges)
            y_.push_back(area.bottom + height_of(area) * position(panel.y, edge));
    }

    std::uint32_t columns() const { return static_cast<std::uint32_t>(x_.size() - 1); }
    std::uint32_t rows() const { return static_cast<std::uint32_t>(y_.size() - 1); }
    std::size_t index(NamePlace p) const { return std::size_t{p.row} * columns() + p.column; }
    std::size_t kind(NamePlace p) const { return cells_.kinds[index(p)]; }
    double left(NamePlace p) const { return x_[p.column]; }
    double right(NamePlace p) const { return x_[p.column + 1]; }
    double bottom(NamePlace p) const { return y_[p.row]; }
    double top(NamePlace p) const { return y_[p.row + 1]; }
    double surface(NamePlace p) const { return (x_[p.column + 1] - x_[p.column]) * (y_[p.row + 1] - y_[p.row]); }

    // first and last cell under a rectangle; nothing if it leaves the map
    std::optional<std::pair<NamePlace, NamePlace>> cells_under(const Rectangle& box) const {
        if (box.left < x_.front() || box.right > x_.back() || box.bottom < y_.front() || box.top > y_.back())
            return std::nullopt;
        return std::pair{NamePlace{before(y_, box.bottom), before(x_, box.left)},
                         NamePlace{before(y_, box.top), before(x_, box.right)}};
    }

private:
    const CategoryCells& cells_;
    std::vector<double> x_;  // [mm]
    std::vector<double> y_;  // [mm]

    static std::uint32_t before(const std::vector<double>& edges, double value) {
        const auto next = std::upper_bound(edges.begin(), edges.end(), value);
        return static_cast<std::uint32_t>(
            std::clamp<std::ptrdiff_t>(next - edges.begin() - 1, 0, static_cast<std::ptrdiff_t>(edges.size()) - 2));
    }
};

// the region that holds a cell; marks its cells as seen
std::vector<NamePlace> region_from(const Map& map, NamePlace start, std::vector<char>& seen) {
    std::vector<NamePlace> region{start};
    seen[map.index(start)] = 1;
    for (std::size_t i = 0; i < region.size(); ++i) {
        const NamePlace here = region[i];
        const auto visit = [&](std::uint32_t row, std::uint32_t column) {
            // unsigned steps below zero land beyond the other end
            if (row >= map.rows() || column >= map.columns()) return;
            const NamePlace next{row, column};
            if (seen[map.index(next)] != 0 || map.kind(next) != map.kind(start)) return;
            seen[map.index(next)] = 1;
            region.push_back(next);
        };
        visit(here.row + 1, here.column);
        visit(here.row - 1, here.column);
        visit(here.row, here.column + 1);
        visit(here.row, here.column - 1);
    }
    return region;
}

// counts a region's cells in any rectangle of cells at once: a summed-area table
class Counter {
public:
    Counter(const Map& map, const std::vector<NamePlace>& region) : width_(map.columns() + 1U) {
        sums_.assign(width_ * (map.rows() + 1U), 0);
        for (const NamePlace& p : region)
            at(p.row + 1, p.column + 1) = 1;
        for (std::size_t r = 1; r <= map.rows(); ++r)
            for (std::size_t c = 1; c < width_; ++c)
                at(r, c) += at(r - 1, c) + at(r, c - 1) - at(r - 1, c - 1);
    }

    bool is_full(NamePlace first, NamePlace last) {
        const long count = at(last.row + 1, last.column + 1) - at(first.row, last.column + 1) -
                           at(last.row + 1, first.column) + at(first.row, first.column);
        return count == static_cast<long>((last.row - first.row + 1) * (last.column - first.column + 1));
    }

private:
    std::size_t width_;
    std::vector<std::int32_t> sums_;  // a chart has at most 4096 by 4096 cells

    std::int32_t& at(std::size_t row, std::size_t column) { return sums_[row * width_ + column]; }
};

// middles and corners of a region's cells: where the middle of a name may stand
std::vector<Dot> candidates(const Map& map, const std::vector<NamePlace>& region) {
    std::vector<Dot> dots;
    dots.reserve(4 * region.size());
    for (const NamePlace& p : region)
        for (const double x : {0.5 * (map.left(p) + map.right(p)), map.right(p)})
            for (const double y : {0.5 * (map.bottom(p) + map.top(p)), map.top(p)})
                dots.push_back({x, y});
    return dots;
}

// what each mark that is larger than a dot of the cells takes of the paper
std::vector<Rectangle> large_marks(const Panel& panel, const Rectangle& area) {
    constexpr double large = 6.0;  // [pt]
    std::vector<Rectangle> marks;
    for (const Layer& layer : panel.layers)
        if (const Points* points = std::get_if<Points>(&layer); points != nullptr && points->diameter >= large)
            for (std::size_t k = 0; k < points->x.size(); ++k) {
                const double x = area.left + width_of(area) * position(panel.x, points->x[k]);
                const double y = area.bottom + height_of(area) * position(panel.y, points->y[k]);
                const double reach = 0.7 * points->diameter * millimetres_per_point;
                marks.push_back({x - reach, x + reach, y - reach, y + reach});
            }
    return marks;
}

// the place around which a box of this extent has most room; nothing if it fits nowhere
std::optional<Dot> roomiest(const Map& map, const std::vector<NamePlace>& region, const TextExtent& extent,
                            const std::vector<Rectangle>& marks) {
    Counter counter(map, region);
    std::vector<Dot> places = candidates(map, region);
    for (double growth = 1.0; !places.empty(); growth *= 1.1) {
        const double half_width = 0.5 * extent.width * growth;
        const double half_height = 0.5 * extent.height * growth;
        // of the last places with room the middle one
        const Dot middle = places[places.size() / 2];
        const auto has_no_room = [&](const Dot& at) {
            const Rectangle box{at.x - half_width, at.x + half_width, at.y - half_height, at.y + half_height};
            if (std::any_of(marks.begin(), marks.end(), [&](const Rectangle& mark) { return touch(box, mark); }))
                return true;
            const auto under = map.cells_under(box);
            return !under || !counter.is_full(under->first, under->second);
        };
        places.erase(std::remove_if(places.begin(), places.end(), has_no_room), places.end());
        if (places.empty()) return growth == 1.0 ? std::nullopt : std::optional(middle);
    }
    return std::nullopt;
}

}  // namespace

StyledText fitted(const StyledText& text, double size, double width) {
    if (text_width(text, size) <= width) return text;
    StyledText cut = text;
    while (!is_empty(cut) && text_width(cut + "...", size) > width)
        shorten(cut);
    return cut + "...";
}

std::vector<double> spread(std::vector<double> places, double least) {
    std::vector<Cluster> clusters;
    for (const double place : places) {
        clusters.push_back({place, 1});
        while (clusters.size() > 1) {
            Cluster& before = clusters[clusters.size() - 2];
            const Cluster& last = clusters.back();
            const double taken = least * static_cast<double>(before.count);
            if (before.first() + taken <= last.first()) break;
            before.sum += last.sum - taken * static_cast<double>(last.count);
            before.count += last.count;
            clusters.pop_back();
        }
    }
    auto place = places.begin();
    for (const Cluster& cluster : clusters)
        for (std::size_t k = 0; k < cluster.count; ++k)
            *place++ = cluster.first() + least * static_cast<double>(k);
    return places;
}

std::vector<std::size_t> thinned(const std::vector<Extent>& ends, double least) {
    std::vector<std::size_t> kept;
    for (std::size_t every = 1; every <= ends.size(); ++every) {
        kept.clear();
        for (std::size_t k = 0; k < ends.size(); k += every)
            kept.push_back(k);
        const auto touches = [&](std::size_t a, std::size_t b) { return ends[a].to + least > ends[b].from; };
        if (std::adjacent_find(kept.begin(), kept.end(), touches) == kept.end()) break;
    }
    return kept;
}

std::vector<PlacedNote> placed_notes(const Panel& panel, const Rectangle& area, double size) {
    std::vector<PlacedNote> placed;
    const CategoryCells* cells = nullptr;
    for (std::size_t layer = 0; layer < panel.layers.size(); ++layer) {
        if (const CategoryCells* map = std::get_if<CategoryCells>(&panel.layers[layer])) cells = map;
        std::vector<Note> notes;
        if (const Note* note = std::get_if<Note>(&panel.layers[layer])) notes = {*note};
        const RegionNames* regions = std::get_if<RegionNames>(&panel.layers[layer]);
        if (regions != nullptr && cells != nullptr) notes = region_names(*cells, regions->names, panel, area, size);
        for (const Note& note : notes) {
            const bool is_share = note.anchor == Anchor::panel;
            const double x = area.left + width_of(area) * (is_share ? note.x : position(panel.x, note.x));
            const double y = area.bottom + height_of(area) * (is_share ? note.y : position(panel.y, note.y));
            placed.push_back(
                {layer, {note.text, x, y, note.align, note.size > 0.0 ? note.size : size, note.colour}, note.ground});
        }
    }
    return placed;
}

std::vector<Rectangle> text_areas(const Layout& layout) {
    std::vector<Rectangle> areas;
    const auto add = [&](const PlacedText& text) {
        const double length = text_width(text.text, text.size);
        const double before = text.align == Align::left ? 0.0 : text.align == Align::centre ? 0.5 : 1.0;
        const double half = 0.45 * text.size * millimetres_per_point;  // of letters with their ups and downs
        if (text.turn == PlacedText::Turn::quarter)
            areas.push_back({text.x - half, text.x + half, text.y - before * length, text.y + (1.0 - before) * length});
        else
            areas.push_back({text.x - before * length, text.x + (1.0 - before) * length, text.y - half, text.y + half});
    };
    for (const PlacedText& text : layout.texts)
        add(text);
    for (const PlacedPanel& panel : layout.panels)
        for (const PlacedNote& note : panel.notes)
            add(note.text);
    return areas;
}

bool is_legible(const Layout& layout, double width) {
    const std::vector<Rectangle> areas = text_areas(layout);
    for (auto a = areas.begin(); a != areas.end(); ++a) {
        if (a->left < 0.0 || a->right > width || a->bottom < 0.0 || a->top > layout.height) return false;
        if (std::any_of(areas.begin(), a, [&](const Rectangle& b) { return touch(*a, b); })) return false;
    }
    return true;
}

std::vector<Note> region_names(const CategoryCells& cells, const std::vector<StyledText>& names, const Panel& panel,
                               const Rectangle& area, double size) {
    STRIDOR_EXPECT(names.size() == cells.fills.size());
    const Map map(cells, panel, area);
    const std::vector<Rectangle> marks = large_marks(panel, area);
    std::vector<TextExtent> extents;
    for (const StyledText& name : names)
        extents.push_back(note_extent(name, size));
    std::vector<char> seen(cells.kinds.size(), 0);
    std::vector<Note> notes;
    for (std::uint32_t row = 0; row < map.rows(); ++row)
        for (std::uint32_t column = 0; column < map.columns(); ++column) {
            const NamePlace start{row, column};
            if (seen[map.index(start)] != 0) continue;
            const std::vector<NamePlace> region = region_from(map, start, seen);
            const std::size_t kind = map.kind(start);
            if (is_empty(names[kind])) continue;
            const TextExtent& extent = extents[kind];
            double surface = 0.0;
            for (const NamePlace& p : region)
                surface += map.surface(p);
            if (surface < extent.width * extent.height) continue;
            const std::optional<Dot> best = roomiest(map, region, extent, marks);
            if (!best) continue;
            const auto share = [](double value, double from, double length) { return (value - from) / length; };
            notes.push_back({names[kind], share(best->x, area.left, width_of(area)),
                             share(best->y, area.bottom, height_of(area)), Anchor::panel, Align::centre,
                             text_colour_on(cells.fills[kind].colour), size, cells.fills[kind].colour});
        }
    return notes;
}

}  // namespace stridor::drawing
