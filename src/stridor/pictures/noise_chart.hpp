#pragma once

#include "stridor/drawing/scene.hpp"
#include "stridor/sweep/cell.hpp"

#include <span>
#include <string_view>

namespace stridor::pictures {

/// Draws the noise chart: the category of each cell, a panel per direction (Elmaian et al. 2012, Figure 8).
///
/// Cells are rectangles between the midpoints of their values in the axis' own scale. Cells without a result are white
/// and crossed, undecided ones white and dotted; neither ever has a category's colour. Lines separate different
/// verdicts (`sweep::boundaries`); a disc marks a cell that is quiet from one start and noisy from another. If a chart
/// has more cells than a picture can show, some are left out (`ShownCells`), and the caption says so.
drawing::Scene noise_chart(const sweep::SweepResult& result);

/// Draws one figure of the cells as colours of a sequential map, in the same layout. Cells without this figure (no
/// period if nothing alternates) are grey, cells without a result white and crossed; inferred cells have the colour of
/// their computed cell, and the caption says so. Throws `Error` (input) for a name that is not in
/// `sweep::cell_figures`.
drawing::Scene figure_chart(const sweep::SweepResult& result, std::string_view figure);

/// Draws a quantity of a study: `noise_chart` for "category", else `figure_chart`.
drawing::Scene quantity_chart(const sweep::SweepResult& result, std::string_view quantity);

/// Draws slip, stick and separation rate over the two axes of sweeps, a row of three maps per sweep and direction
/// (Elmaian et al. 2012, Figure 6: two incidence angles). Cells without a result are white and crossed.
drawing::Scene rate_map(std::span<const sweep::SweepResult> results);

}  // namespace stridor::pictures
