#include "stridor/pictures/parts/shown_cells.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace stridor::pictures {

namespace {

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

}  // namespace

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

}  // namespace stridor::pictures
