#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stridor::pictures {

// How a cell's verdict is drawn: one kind for each category, for a contact that is quiet because it sticks, for one
// that locks, and for cells without a result.

/// Returns the kind of a cell, into `kind_fills` and `kind_names`.
std::size_t kind_of(const sweep::CellVerdict& cell);

/// Returns the fill of each kind.
std::vector<drawing::Fill> kind_fills();

/// Returns the name of each kind, as legends have it.
std::vector<drawing::StyledText> kind_names();

/// Returns the statuses of failed cells that occur: "failed (invalid, diverged)"; empty if there are none.
std::string failure_words(const sweep::SweepResult& result);

/// Adds the four categories to the legend, and those of the other kinds that occur.
void add_kind_legend(drawing::Scene& scene, const sweep::SweepResult& result);

/// The largest number of values of an axis that a picture can show [1]: more are closer than its points.
inline constexpr int most_shown = 4096;

/// The cells that a picture shows: all or, in a large chart, every n-th in x and in y, from the first one on.
class ShownCells {
public:
    /// Chooses the cells. The result must outlive this object.
    explicit ShownCells(const sweep::SweepResult& result);

    /// Returns their verdicts, with a study whose axes have only their values. If cells are left out, nothing else is
    /// known.
    const sweep::SweepResult& chart() const { return is_all() ? all_ : shown_; }

    /// Returns one figure of each of them, as `sweep::figure_values` does.
    std::vector<double> values(const sweep::CellFigure& figure) const;

    /// Returns "Of the cells every 3rd in x and every 2nd in y is drawn."; empty if all are drawn.
    std::vector<drawing::StyledText> caption() const;

private:
    bool is_all() const { return x_step_ == 1 && y_step_ == 1; }
    std::size_t index_of_shown(std::size_t index) const;  // in the whole chart

    const sweep::SweepResult& all_;
    std::size_t x_step_ = 1;
    std::size_t y_step_ = 1;
    sweep::SweepResult shown_{};
};

/// Returns the boundaries of one direction as a line along the edges of the cells (`cell_edges`), with NaN between two
/// of them: it runs through their vertices, around the corners of the cells, and on to the frame if a boundary leaves
/// the chart.
drawing::Line boundary_line(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries,
                            std::size_t direction);

/// Marks the chart's design, its case's own values of the two axes, in every panel and in the legend: by a diamond, or
/// over one axis by a line. If it lies outside of the axes, the caption says so instead.
void mark_design(drawing::Scene& scene, const sweep::Study& study);

}  // namespace stridor::pictures
