#pragma once

#include "stridor/analysis/evidence.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace stridor::analysis {
struct SlidingStability;
}
namespace stridor::integration {
struct Motion;
}

namespace stridor::sweep {

/// One number of a cell. What a cell keeps, the store's columns, CSV, netCDF, JSON and what a chart can draw all come
/// from this table: the figures of the evidence (analysis/evidence_figures), then those of the run.
struct CellFigure {
    std::string_view name;      // a word of lower-case letters, digits and underscores
    std::string_view unit;      // "1", "Hz", "dB re 1e-9 m/s"
    std::string_view sentence;  // for attributes and colour bars
    std::size_t place = 0;      // in `Cell::figures`
};

/// All figures, in the order of files.
std::span<const CellFigure> cell_figures();

/// The figure with this name; nothing if there is none.
const CellFigure* find_cell_figure(std::string_view name);

/// The figure with a name that is known to be one.
const CellFigure& cell_figure(std::string_view name);

/// What the figures of a cell are taken from.
struct JudgedRun {
    const analysis::Evidence& evidence;           // of the cell's direction
    const analysis::SlidingStability& stability;  // likewise
    const integration::Motion& motion;
};

/// The values of all figures, shape [figure].
std::vector<double> figures_of(const JudgedRun& run);

}  // namespace stridor::sweep
