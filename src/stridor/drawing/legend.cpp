#include "stridor/drawing/legend.hpp"

#include "stridor/drawing/lettering.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <utility>

namespace stridor::drawing {

namespace {

constexpr double sample_width = 6.0;   // [mm]
constexpr double sample_height = 2.6;  // [mm]

// one entry, its text in lines
struct PlacedEntry {
    const LegendEntry* of = nullptr;
    std::vector<StyledText> lines;
    double width = 0.0;  // [mm] with what parts it from the next
};

PlacedEntry entry_of(const LegendEntry& legend, const Scene& scene, double em) {
    const double before = sample_width + 0.5 * em;
    PlacedEntry entry{&legend, wrapped(legend.text, scene.font_size, scene.width - 2.0 * sheet_margin - before), 0.0};
    for (const StyledText& line : entry.lines)
        entry.width = std::max(entry.width, text_width(line, scene.font_size));
    entry.width += before + 1.5 * em;
    return entry;
}

// side by side, in the middle of the sheet; y is the middle of the first line
void place_row(const std::vector<PlacedEntry>& row, double y, const Scene& scene, Layout& layout) {
    const Measures mm = measures(scene.font_size);
    double width = -1.5 * mm.em;
    for (const PlacedEntry& entry : row)
        width += entry.width;
    double x = std::max(sheet_margin, 0.5 * (scene.width - width));
    for (const PlacedEntry& entry : row) {
        const Rectangle area{x, x + sample_width, y - 0.5 * sample_height, y + 0.5 * sample_height};
        layout.samples.push_back({area, entry.of->sample});
        for (std::size_t k = 0; k < entry.lines.size(); ++k)
            layout.texts.push_back({entry.lines[k], area.right + 0.5 * mm.em, y - static_cast<double>(k) * mm.line,
                                    Align::left, scene.font_size, ink});
        x += entry.width;
    }
}

}  // namespace

Measures measures(double font_size) {
    const double em = font_size * millimetres_per_point;
    return {em, 1.35 * em, 0.75 * em};
}

double place_legend(const Scene& scene, Layout& layout) {
    const Measures mm = measures(scene.font_size);
    std::vector<std::vector<PlacedEntry>> rows;
    double width = 0.0;
    for (const LegendEntry& legend : scene.legend) {
        PlacedEntry entry = entry_of(legend, scene, mm.em);
        width += entry.width;
        if (rows.empty() || width - 1.5 * mm.em > scene.width - 2.0 * sheet_margin) {
            rows.emplace_back();
            width = entry.width;
        }
        rows.back().push_back(std::move(entry));
    }
    const double step = 1.25 * mm.line;
    double y = sheet_margin;
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
        std::size_t most = 1;
        for (const PlacedEntry& entry : *row)
            most = std::max(most, entry.lines.size());
        y += step + static_cast<double>(most - 1) * mm.line;
        place_row(*row, y - 0.5 * step, scene, layout);
    }
    return rows.empty() ? y : y + 0.5 * mm.em;
}

}  // namespace stridor::drawing
