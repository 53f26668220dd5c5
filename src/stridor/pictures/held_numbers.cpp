#include "stridor/pictures/held_numbers.hpp"

#include "stridor/base/check.hpp"
#include "stridor/drawing/palette.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace stridor::pictures {

namespace {

constexpr double axis_from = 1e-13;  // [1] smaller differences are rounding: they stand at the edge
constexpr double axis_to = 1.0;
constexpr double note_at = 3e-13;      // [1] where the numbers begin
constexpr double note_to = 1e-8;       // [1] where the longest end
constexpr double note_size = 6.5;      // [pt]
constexpr double number_height = 4.6;  // [mm] of a row

constexpr drawing::Mark kind_marks[] = {drawing::Mark::disc, drawing::Mark::square, drawing::Mark::triangle,
                                        drawing::Mark::diamond, drawing::Mark::nabla};
constexpr drawing::Colour kind_colours[] = {
    drawing::accent, {0xC4, 0x6A, 0x00}, {0x7B, 0x3F, 0x8C}, {0x5A, 0x5A, 0x5A}, drawing::ink};

double within_axis(double share) {
    return std::clamp(share, axis_from, axis_to);
}

// where the numbers of a row begin: at the left, or behind its bar where its point would lie on them
double note_of(const HeldPoint& point) {
    const bool lies_on_them = point.difference > 0.5 * note_at && point.difference < note_to;
    return lies_on_them ? 1.6 * std::max(within_axis(point.precision), note_to) : note_at;
}

}  // namespace

drawing::Scene held_numbers(std::span<const HeldPoint> points, std::span<const std::string_view> kinds) {
    STRIDOR_EXPECT(kinds.size() <= std::size(kind_marks));
    const drawing::Fill known{drawing::tint(drawing::quiet_ink, 0.25), drawing::Texture::none, drawing::ink};
    drawing::Panel panel;
    panel.grid = drawing::Grid::vertical;
    panel.x.label = "share of the published number";
    panel.x.unit = "1";
    panel.x.scale = drawing::AxisScale::logarithmic;
    panel.x.range.from = axis_from;
    panel.x.range.to = axis_to;
    panel.y.range.to = std::max(1.0, static_cast<double>(points.size()));
    drawing::Boxes bars{{}, known};
    std::vector<drawing::Note> notes;
    std::vector<drawing::Points> marks;
    for (std::size_t kind = 0; kind < kinds.size(); ++kind)
        marks.push_back({{}, {}, kind_colours[kind], 5.0, std::nullopt, kind_marks[kind], drawing::ink});
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double row = static_cast<double>(points.size() - k) - 0.5;  // the first at the top
        bars.boxes.push_back({{axis_from, within_axis(points[k].precision)}, {row - 0.28, row + 0.28}});
        panel.y.ticks.push_back({row, points[k].label, drawing::TickSize::major});
        notes.push_back({points[k].numbers, note_of(points[k]), row, drawing::Anchor::data, drawing::Align::left,
                         drawing::ink, note_size, std::nullopt});
        marks.at(points[k].kind).x.push_back(within_axis(points[k].difference));
        marks.at(points[k].kind).y.push_back(row);
    }
    panel.layers.emplace_back(std::move(bars));
    drawing::Scene scene;
    scene.legend.push_back({"theirs is known so well", known});
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
        if (marks[kind].x.empty()) continue;
        panel.layers.emplace_back(marks[kind]);
        scene.legend.push_back({"ours; theirs is a " + std::string(kinds[kind]), marks[kind]});
    }
    for (drawing::Note& note : notes)
        panel.layers.emplace_back(std::move(note));
    scene.title = "Published numbers and ours";
    scene.height = 34.0 + number_height * panel.y.range.to;
    scene.panels.push_back(std::move(panel));
    return scene;
}

}  // namespace stridor::pictures
