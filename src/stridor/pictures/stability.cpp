#include "stridor/pictures/stability.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/elementary.hpp"
#include "stridor/drawing/palette.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stridor::pictures {

namespace {

using analysis::Eigenmode;

// one mode followed from value to value
struct ModeBranch {
    std::vector<double> x;
    std::vector<Eigenmode> modes;
};

double distance(const Eigenmode& a, const Eigenmode& b) {
    return std::hypot(a.growth - b.growth, base::two_pi * (a.frequency - b.frequency));
}

// each mode goes on with the nearest of the modes at the next value; modes beyond the branches' number begin new ones
std::vector<ModeBranch> branches_of(const analysis::StabilityPath& path) {
    std::vector<ModeBranch> branches;
    double before = 0.0;
    for (const analysis::StabilityPoint& point : path.points) {
        std::vector<Eigenmode> left = point.stability.modes;
        for (ModeBranch& branch : branches) {
            if (left.empty() || branch.x.back() != before) continue;
            const Eigenmode last = branch.modes.back();
            const auto nearest = std::min_element(
                left.begin(), left.end(),
                [&](const Eigenmode& a, const Eigenmode& b) { return distance(a, last) < distance(b, last); });
            branch.x.push_back(point.value);
            branch.modes.push_back(*nearest);
            left.erase(nearest);
        }
        for (const Eigenmode& mode : left)
            branches.push_back({{point.value}, {mode}});
        before = point.value;
    }
    return branches;
}

// stretches of the quantity in which sliding is unstable
std::vector<drawing::Extent> unstable_stretches(const analysis::StabilityPath& path) {
    std::vector<drawing::Extent> stretches;
    if (path.points.empty()) return stretches;
    double from = path.points.front().value;
    analysis::StabilityKind kind = path.points.front().stability.kind;
    const auto add = [&](double to) {
        if (kind != analysis::StabilityKind::stable) stretches.push_back({from, to});
    };
    for (const analysis::StabilityBoundary& boundary : path.boundaries) {
        add(boundary.value);
        from = boundary.value;
        kind = boundary.above;
    }
    add(path.points.back().value);
    return stretches;
}

drawing::Extent extent(const analysis::StabilityScan& scan, double Eigenmode::*member) {
    drawing::Extent range{0.0, 0.0};
    for (const analysis::DirectionScan& direction : scan.directions)
        for (const analysis::StabilityPoint& point : direction.path.points)
            for (const Eigenmode& mode : point.stability.modes)
                range = {std::min(range.from, mode.*member), std::max(range.to, mode.*member)};
    const double air = range.to > range.from ? 0.08 * (range.to - range.from) : 1.0;
    return {range.from < 0.0 ? range.from - air : 0.0, range.to + air};
}

constexpr drawing::Colour mode_colours[] = {
    {0x00, 0x66, 0x99}, {0xC4, 0x6A, 0x00}, {0x5A, 0x5A, 0x5A}, {0x7B, 0x3F, 0x8C}};

drawing::Panel mode_panel(const analysis::StabilityPath& path, double Eigenmode::*member, const drawing::Extent& y) {
    drawing::Panel panel;
    panel.grid = drawing::Grid::both;
    panel.y.range = y;
    for (const drawing::Extent& stretch : unstable_stretches(path))
        panel.layers.emplace_back(
            drawing::Boxes{{{stretch, y}}, {drawing::tint({0xBB, 0x55, 0x66}, 0.14), drawing::Texture::none, {}}});
    if (y.from < 0.0)
        panel.layers.emplace_back(
            drawing::Rule{0.0, drawing::Orientation::horizontal, {drawing::quiet_ink, 0.5, drawing::Dash::solid}});
    const std::vector<ModeBranch> branches = branches_of(path);
    for (std::size_t b = 0; b < branches.size(); ++b) {
        drawing::Line line{branches[b].x,
                           {},
                           {mode_colours[b % std::size(mode_colours)], 1.3,
                            b % 2 == 0 ? drawing::Dash::solid : drawing::Dash::dashed}};
        for (const Eigenmode& mode : branches[b].modes)
            line.y.push_back(mode.*member);
        panel.layers.emplace_back(std::move(line));
    }
    return panel;
}

void mark_boundaries(drawing::Panel& panel, const analysis::StabilityPath& path) {
    for (const analysis::StabilityBoundary& boundary : path.boundaries)
        panel.layers.emplace_back(
            drawing::Rule{boundary.value, drawing::Orientation::vertical, {drawing::ink, 0.6, drawing::Dash::dashed}});
}

// "going: α = 61.9°, 87.13°": beside their lines they would stand on the curves
drawing::StyledText direction_title(const analysis::DirectionScan& scan, const drawing::StyledText& name,
                                    const std::string& unit) {
    drawing::StyledText title(parameters::direction_names[static_cast<std::size_t>(scan.direction)]);
    for (const analysis::StabilityBoundary& boundary : scan.path.boundaries) {
        const double rounded = std::stod(fmt::format("{:.4g}", boundary.value));
        const bool is_first = &boundary == &scan.path.boundaries.front();
        title = title + (is_first ? ": " + name + " = " : drawing::StyledText(", ")) +
                with_unit(drawing::number_text(rounded), unit);
    }
    return title;
}

}  // namespace

drawing::Scene stability(const analysis::StabilityScan& scan) {
    const parameters::Field* field = parameters::field_of(scan.key);
    STRIDOR_EXPECT(field != nullptr && std::holds_alternative<parameters::Quantity>(field->kind));
    const drawing::StyledText name = field->symbol.empty() ? field_label(*field) : drawing::symbol(field->symbol);
    const std::string& title = scan.base.title;
    drawing::Scene scene;
    scene.title = "Stability of steady sliding" + (title.empty() ? "" : ": " + title);
    scene.caption = {
        conditions(scan.base, std::array<std::string_view, 1>{scan.key}),
        "Lines: the modes of the sliding contact. Tinted: sliding is unstable; dashed: where that changes."};
    scene.height = 105.0;
    scene.column_widths.assign(std::max<std::size_t>(1, scan.directions.size()), 1.0);
    scene.row_heights = {1.0, 1.0};
    for (std::size_t c = 0; c < scan.directions.size(); ++c)
        for (std::size_t row = 0; row < 2; ++row) {
            const analysis::StabilityPath& path = scan.directions[c].path;
            double Eigenmode::*const member = row == 0 ? &Eigenmode::frequency : &Eigenmode::growth;
            drawing::Panel panel = mode_panel(path, member, extent(scan, member));
            panel.row = row;
            panel.column = c;
            panel.x.label = field_label(*field);
            panel.x.unit = parameters::unit_of(*field);
            if (!path.points.empty()) panel.x.range = {path.points.front().value, path.points.back().value};
            panel.y.label = row == 0 ? "frequency" : "growth rate";
            panel.y.unit = row == 0 ? "Hz" : "1/s";
            if (row == 0) {
                panel.x.text = drawing::AxisText::hidden;
                panel.title = lettered(c, direction_title(scan.directions[c], name, panel.x.unit));
            }
            if (c > 0) panel.y.text = drawing::AxisText::hidden;
            mark_boundaries(panel, path);
            scene.panels.push_back(std::move(panel));
        }
    return scene;
}

}  // namespace stridor::pictures
