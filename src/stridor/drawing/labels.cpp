#include "stridor/drawing/labels.hpp"

#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/region_names.hpp"

#include <algorithm>

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

}  // namespace stridor::drawing
