#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/cell.hpp"

#include <vector>

namespace stridor::pictures {

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

}  // namespace stridor::pictures
