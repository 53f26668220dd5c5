#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <memory>

/// Charts of any size whose cells follow from their index: they are nowhere kept.
namespace stridor::io {

/// A figure of a cell: a number of its own, whose bits are not all alike.
inline double invented_value(std::size_t index, const sweep::CellFigure& figure) {
    return 1.0 / static_cast<double>(1 + index * 32 + figure.place);
}

/// A cell that is done, in 16 by 16 patches of the categories; every 9973rd is not.
inline sweep::Cell invented_cell(const sweep::Study& study, std::size_t index) {
    sweep::Cell cell;
    if (index % 9973 == 96) {
        cell.message = "invented";
        return cell;
    }
    const sweep::CellPlace place = sweep::place_of(study, index);
    cell.status = sweep::Status::done;
    cell.category =
        static_cast<classification::Category>((place.ix * 16 / study.x.points + place.iy * 16 / study.y.points) % 4);
    if (cell.category == classification::Category::none) cell.quiet = classification::Quiet::slides;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        set_figure(cell, figure, invented_value(index, figure));
    return cell;
}

/// The cells of a study, made when they are looked at.
class InventedCells final : public sweep::ComputedCells {
public:
    explicit InventedCells(sweep::Study study) : study_(std::move(study)) {}

    void visit(std::size_t first, std::size_t last, const std::function<void(sweep::IndexedCell&)>& use) override {
        last = std::min(last, sweep::cell_count(study_));
        for (std::size_t index = first; index < last; ++index) {
            sweep::IndexedCell indexed{index, invented_cell(study_, index)};
            use(indexed);
        }
    }

private:
    sweep::Study study_;
};

/// Figure 8's chart with so many points.
inline sweep::Study invented_study(int x_points, int y_points) {
    sweep::Study study = sweep::figure_8();
    study.x.points = x_points;
    study.y.points = y_points;
    return study;
}

/// All of its cells, of which the verdicts alone are in memory.
inline sweep::SweepResult invented_chart(const sweep::Study& study) {
    sweep::SweepResult result{study, {}};
    result.computed = std::make_shared<InventedCells>(study);
    result.cells.reserve(sweep::cell_count(study));
    for (std::size_t index = 0; index < sweep::cell_count(study); ++index)
        result.cells.push_back(verdict_of(invented_cell(study, index)));
    return result;
}

}  // namespace stridor::io
