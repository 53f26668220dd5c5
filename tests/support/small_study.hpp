#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study.hpp"
#include "support/scratch_folder.hpp"
#include "support/small_chart.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

/// What the tests of sweeps share: a study of milliseconds, and what is the same.
namespace stridor::sweep {

/// The same numbers to the last bit, NaN equal to NaN.
inline bool same_bits(double a, double b) {
    const bool both_nan = a != a && b != b;
    return both_nan || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_cell(const Cell& a, const Cell& b) {
    const bool same_words = a.status == b.status && a.message == b.message;
    const bool same_category = a.status != Status::done || (a.category == b.category && a.quiet == b.quiet);
    const bool same_starts = a.starts == b.starts && a.agreement == b.agreement;
    return same_words && same_category && same_starts &&
           std::all_of(cell_figures().begin(), cell_figures().end(),
                       [&](const CellFigure& figure) { return same_bits(figure_of(a, figure), figure_of(b, figure)); });
}

inline bool same_cells(const std::vector<Cell>& a, const std::vector<Cell>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_cell);
}

/// The finished sweep of a store that lives longer than it.
inline SweepResult load(const Study& study, Store& store) {
    return load(study, std::shared_ptr<Store>(std::shared_ptr<void>(), &store));
}

/// All cells of a sweep; those that were inferred have their verdict only.
inline std::vector<Cell> all_cells(const SweepResult& result) {
    std::vector<Cell> cells(result.cells.size());
    for (std::size_t index = 0; index < cells.size(); ++index) {
        cells[index].status = result.cells[index].status;
        cells[index].category = result.cells[index].category;
        cells[index].agreement = result.cells[index].agreement;
    }
    result.computed->visit(0, cells.size(), [&](IndexedCell& computed) { cells[computed.index] = computed.cell; });
    return cells;
}

using support::FullDisk;
using support::ScratchFolder;

}  // namespace stridor::sweep
