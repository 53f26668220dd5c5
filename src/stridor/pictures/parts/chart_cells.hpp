#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace stridor::pictures {

// How a cell's verdict is drawn: a kind for each category, for a contact that is quiet because it sticks, for one
// that locks, and for cells without a result.

/// The kind of a cell, into `kind_fills` and `kind_names`.
std::size_t kind_of(const sweep::CellVerdict& cell);

/// The fill of each kind.
std::vector<drawing::Fill> kind_fills();

/// The name of each kind, as legends have it.
std::vector<drawing::StyledText> kind_names();

/// "failed (invalid, diverged)": which ways to fail occur; empty if none does.
std::string failure_words(const sweep::SweepResult& result);

/// Adds the four categories to the legend, and of the other kinds those that occur.
void add_kind_legend(drawing::Scene& scene, const sweep::SweepResult& result);

/// Values of an axis that a picture can show [1]: more are closer than its points.
inline constexpr int most_shown = 4096;

/// The cells that a picture shows: all, or of a large chart every so manieth in x and in y, from the first one on.
class ShownCells {
public:
    /// The result must live as long.
    explicit ShownCells(const sweep::SweepResult& result);

    /// Their verdicts, with the study whose axes have their values only. Where cells are left out, no more is known.
    const sweep::SweepResult& chart() const { return is_all() ? all_ : shown_; }

    /// One figure of each, as of `sweep::figure_values`.
    std::vector<double> values(const sweep::CellFigure& figure) const;

    /// "Of the cells every 3rd in x and every 2nd in y is drawn."; nothing where all are.
    std::vector<drawing::StyledText> caption() const;

private:
    bool is_all() const { return x_step_ == 1 && y_step_ == 1; }
    std::size_t index_of_shown(std::size_t index) const;  // in the whole chart

    const sweep::SweepResult& all_;
    std::size_t x_step_ = 1;
    std::size_t y_step_ = 1;
    sweep::SweepResult shown_{};
};

/// The boundaries of one direction as a line along the edges of the cells (`cell_edges`), NaN between two of them: it
/// runs through their vertices, around the corners of the cells, and on to the frame where a boundary leaves the chart.
drawing::Line boundary_line(const sweep::Study& study, const std::vector<sweep::Boundary>& boundaries,
                            std::size_t direction);

/// Marks the design a chart was made from, its case's own values of the two axes, in every panel and in the legend: by
/// a diamond, or over one axis by a line. Where it lies outside of the axes, the caption says so instead.
void mark_design(drawing::Scene& scene, const sweep::Study& study);

}  // namespace stridor::pictures
