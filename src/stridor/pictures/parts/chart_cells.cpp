#include "stridor/pictures/parts/chart_cells.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"
#include "stridor/pictures/parts/field_axis.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>

namespace stridor::pictures {

namespace {

using classification::Category;
using classification::Quiet;

constexpr std::array all_categories{Category::none, Category::squeak, Category::squeal, Category::creak,
                                    Category::undecided};
constexpr std::size_t stuck_kind = all_categories.size();  // quiet because it sticks
constexpr std::size_t locked_kind = stuck_kind + 1;        // silent, too, and no quiet design
constexpr std::size_t failed_kind = locked_kind + 1;

std::size_t step_of(const sweep::Axis& axis) {
    return static_cast<std::size_t>((axis.points + most_shown - 1) / most_shown);
}

sweep::Axis every(const sweep::Axis& axis, std::size_t step) {
    if (step == 1) return axis;
    sweep::Axis shown = axis;
    shown.points = (axis.points - 1) / static_cast<int>(step) + 1;
    shown.to = sweep::value_at(axis, (shown.points - 1) * static_cast<int>(step));
    return shown;
}

std::string ordinal(std::size_t number) {
    const std::size_t last = number % 10;
    const bool is_teen = number % 100 / 10 == 1;
    return std::to_string(number) + (is_teen ? "th" : last == 1 ? "st" : last == 2 ? "nd" : last == 3 ? "rd" : "th");
}

class EdgeLine {
public:
    explicit EdgeLine(const sweep::Study& study)
        : study_(study),
          x_edges_(cell_edges(study.x)),
          y_edges_(cell_edges(study.y)) {}

    void add(const sweep::Boundary& boundary) {
        if (!line_.x.empty()) point(line_.x.back(), std::numeric_limits<double>::quiet_NaN());
        std::vector<sweep::BoundaryVertex> vertices = boundary.vertices;
        if (boundary.form == sweep::LineForm::closed)
            vertices.push_back(vertices.front());
        else
            end(vertices.front());
        point(vertices.front().x, vertices.front().y);
        for (std::size_t k = 1; k < vertices.size(); ++k) {
            // around the corner of the cells
            const bool is_upright = vertices[k - 1].crossing == sweep::Crossing::along_x;
            const bool is_level = vertices[k - 1].crossing == sweep::Crossing::along_y;
            if (is_upright) point(vertices[k - 1].x, vertices[k].y);
            if (is_level) point(vertices[k].x, vertices[k - 1].y);
            point(vertices[k].x, vertices[k].y);
        }
        if (boundary.form == sweep::LineForm::open) end(vertices.back());
    }

    drawing::Line line() && { return std::move(line_); }

private:
    const sweep::Study& study_;
    std::vector<double> x_edges_;
    std::vector<double> y_edges_;
    drawing::Line line_{{}, {}, {drawing::ink, 0.6, drawing::Dash::solid}};

    void point(double x, double y) {
        line_.x.push_back(x);
        line_.y.push_back(y);
    }

    // the half cell from the outermost values to the frame
    void end(const sweep::BoundaryVertex& vertex) {
        const bool is_upright = vertex.crossing == sweep::Crossing::along_x;
        const bool is_level = vertex.crossing == sweep::Crossing::along_y;
        if (is_upright && vertex.y == study_.y.from) point(vertex.x, y_edges_.front());
        if (is_upright && vertex.y == study_.y.to) point(vertex.x, y_edges_.back());
        if (is_level && vertex.x == study_.x.from) point(x_edges_.front(), vertex.y);
        if (is_level && vertex.x == study_.x.to) point(x_edges_.back(), vertex.y);
    }
};

constexpr double mark_diameter = 9.0;  // [pt] found at a glance

drawing::StyledText design_words(const sweep::Study& study) {
    const std::array<std::string_view, 2> keys{study.x.parameter, study.y.parameter};
    const std::size_t axes = sweep::has_one_axis(study) ? 1 : 2;
    return settings(study.base, std::span(keys).first(axes));
}

}  // namespace

std::size_t kind_of(const sweep::CellVerdict& cell) {
    if (cell.status != sweep::Status::done) return failed_kind;
    if (cell.quiet == Quiet::sticks) return stuck_kind;
    if (cell.quiet == Quiet::locks) return locked_kind;
    const auto* const found = std::find(all_categories.begin(), all_categories.end(), cell.category);
    return static_cast<std::size_t>(found - all_categories.begin());
}

std::vector<drawing::Fill> kind_fills() {
    std::vector<drawing::Fill> fills;
    for (const Category category : all_categories)
        fills.push_back(category_fill(category));
    fills.push_back(stuck_fill());
    fills.push_back(locked_fill());
    fills.push_back(failed_fill());
    return fills;
}

std::vector<drawing::StyledText> kind_names() {
    std::vector<drawing::StyledText> names;
    for (const Category category : all_categories)
        names.emplace_back(classification::name(category));
    names.emplace_back("none (sticks)");
    names.emplace_back("locks");
    names.emplace_back("failed");
    return names;
}

std::string failure_words(const sweep::SweepResult& result) {
    std::string list;
    for (std::size_t status = 1; status < sweep::status_names.size(); ++status) {
        const bool occurs = std::any_of(result.cells.begin(), result.cells.end(), [&](const sweep::CellVerdict& cell) {
            return static_cast<std::size_t>(cell.status) == status;
        });
        if (!occurs) continue;
        std::string name(sweep::status_names[status]);
        std::replace(name.begin(), name.end(), '_', ' ');
        list += (list.empty() ? "" : ", ") + name;
    }
    return list.empty() || list == "failed" ? list : "failed (" + list + ")";
}

void add_kind_legend(drawing::Scene& scene, const sweep::SweepResult& result) {
    const std::vector<drawing::Fill> fills = kind_fills();
    const std::vector<drawing::StyledText> names = kind_names();
    const auto occurs = [&](std::size_t kind) {
        return std::any_of(result.cells.begin(), result.cells.end(),
                           [&](const sweep::CellVerdict& cell) { return kind_of(cell) == kind; });
    };
    for (std::size_t kind = 0; kind < fills.size(); ++kind) {
        const bool is_category = kind < 4;
        if (kind == failed_kind && occurs(kind))
            scene.legend.push_back({failure_words(result), fills[kind]});
        else if (is_category || occurs(kind))
            scene.legend.push_back(
                {kind == 0 && occurs(stuck_kind) ? drawing::StyledText("none (slides)") : names[kind], fills[kind]});
    }
}

ShownCells::ShownCells(const sweep::SweepResult& result)
    : all_(result),
      x_step_(step_of(result.study.x)),
      y_step_(step_of(result.study.y)) {
    if (is_all()) return;
    shown_.study = result.study;
    shown_.study.x = every(result.study.x, x_step_);
    shown_.study.y = every(result.study.y, y_step_);
    shown_.cells.reserve(sweep::cell_count(shown_.study));
    for (std::size_t shown = 0; shown < sweep::cell_count(shown_.study); ++shown)
        shown_.cells.push_back(result.cells[index_of_shown(shown)]);
}

std::size_t ShownCells::index_of_shown(std::size_t index) const {
    sweep::CellPlace place = sweep::place_of(shown_.study, index);
    place.ix *= static_cast<int>(x_step_);
    place.iy *= static_cast<int>(y_step_);
    return sweep::index_of(all_.study, place);
}

std::vector<double> ShownCells::values(const sweep::CellFigure& figure) const {
    if (is_all()) return sweep::figure_values(all_, figure);
    std::vector<double> values(shown_.cells.size(), sweep::Cell::unknown);
    if (all_.sources.empty()) {
        // row by row, those between are not read
        const auto row = static_cast<std::size_t>(all_.study.x.points);
        const auto columns = static_cast<std::size_t>(shown_.study.x.points);
        for (std::size_t shown = 0; shown < values.size(); shown += columns) {
            const std::size_t first = index_of_shown(shown);
            all_.computed->visit(first, first + row, [&](const sweep::IndexedCell& computed) {
                const std::size_t column = computed.index - first;
                if (column % x_step_ == 0) values[shown + column / x_step_] = figure_of(computed.cell, figure);
            });
        }
        return values;
    }
    // the cell that each takes after, in the order in which they are read
    std::vector<std::pair<std::size_t, std::size_t>> wanted;
    wanted.reserve(values.size());
    for (std::size_t shown = 0; shown < values.size(); ++shown)
        wanted.emplace_back(sweep::source_of(all_, index_of_shown(shown)), shown);
    std::sort(wanted.begin(), wanted.end());
    auto next = wanted.begin();
    all_.computed->visit(0, all_.cells.size(), [&](const sweep::IndexedCell& computed) {
        for (; next != wanted.end() && next->first < computed.index; ++next)
            continue;
        for (; next != wanted.end() && next->first == computed.index; ++next)
            values[next->second] = figure_of(computed.cell, figure);
    });
    return values;
}

std::vector<drawing::StyledText> ShownCells::caption() const {
    if (is_all()) return {};
    const auto every_one = [](std::size_t step) { return step == 1 ? std::string("each") : "every " + ordinal(step); };
    return {drawing::StyledText("Of the cells " + every_one(x_step_) + " in x and " + every_one(y_step_) +
                                " in y is drawn.")};
}

drawing::Line boundary_line(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries,
                            std::size_t direction) {
    EdgeLine line(study);
    for (const sweep::Boundary& boundary : boundaries)
        if (boundary.direction == direction) line.add(boundary);
    return std::move(line).line();
}

void mark_design(drawing::Scene& scene, const sweep::Study& study) {
    if (!sweep::holds_design(study)) {
        scene.caption.push_back(drawing::StyledText("The design, ") + design_words(study) +
                                ", lies outside of this chart.");
        return;
    }
    if (sweep::has_one_axis(study)) {
        const drawing::Stroke stroke{drawing::ink, 1.2, drawing::Dash::dashed};
        scene.legend.push_back({drawing::StyledText("design: ") + design_words(study), stroke});
        for (drawing::Panel& panel : scene.panels)
            panel.layers.emplace_back(
                drawing::Rule{sweep::own_value(study, study.x), drawing::Orientation::vertical, stroke});
        return;
    }
    drawing::Points mark{{}, {}, drawing::ink, mark_diameter, {}, drawing::Mark::diamond, drawing::white};
    scene.legend.push_back({drawing::StyledText("design: ") + design_words(study), mark});
    mark.x = {sweep::own_value(study, study.x)};
    mark.y = {sweep::own_value(study, study.y)};
    for (drawing::Panel& panel : scene.panels)
        panel.layers.emplace_back(mark);
}

}  // namespace stridor::pictures
