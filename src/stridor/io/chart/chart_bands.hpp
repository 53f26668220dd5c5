#pragma once

#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// A chart in bands of rows, in the order of the cells: a chart that does not fit into memory is written so.
namespace stridor::io {

/// Points in x and in y of the boxes in which a chart is packed [1]: to read a part of it, whole boxes are unpacked.
inline constexpr std::size_t chunk_points = 256;

/// Rows of a chart that are written at once: one row of boxes.
struct ChartBand {
    std::size_t direction = 0;  // into study.directions
    std::size_t row = 0;        // the first one
    std::size_t rows = 0;       // [1] `chunk_points`, or fewer at the end
};

/// Returns all bands of a chart; direction by direction, from the first row on.
std::vector<ChartBand> bands_of(const sweep::Study& study);

/// Returns the index of a band's first cell, and the number of its cells.
std::size_t first_cell(const sweep::Study& study, const ChartBand& band);
std::size_t cell_count(const sweep::Study& study, const ChartBand& band);

/// The values of a band, read from the computed cells: some of the figures and, with the first ones, the verdicts of
/// the starts.
struct BandValues {
    ChartBand band;
    std::size_t first_figure = 0;       // into the figures that are written
    std::vector<double> figures{};      // shape [figure][row][column]; NaN for a cell that was not computed
    std::vector<signed char> starts{};  // shape [start][row][column], -1 for such a cell; empty: none
};

/// How much of a chart is in memory at once.
struct BandOptions {
    std::span<const sweep::CellFigure> figures;        // that are written
    std::size_t most_bytes = std::size_t{256} << 20U;  // of a band's figures, but at least one figure: usual 256 MiB.
                                                       // Less of it reads the cells more often
};

/// Shows all bands, each in as many parts as its figures need.
void visit_bands(const sweep::SweepResult& result, const BandOptions& options,
                 const std::function<void(const BandValues&)>& take);

}  // namespace stridor::io
