#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <span>
#include <vector>

/// Refinement: a chart is computed closely only where its cells differ.
///
/// A quadtree on the chart's own grid, for each direction, or for both where one run gives both. The base grid takes
/// every 2^refine-th point of x and of y, and the last of each; four neighbours are the corners of a block. A block is
/// split in four (the middles of its edges and its own are computed) as long as it can be and
///  1. two points computed in it or on its edge differ, be it in status, category, agreement of the starts, or in the
///     kind of stability of steady sliding, which changes where flutter sets in;
///  2. that holds for corners, for the points that a neighbour's split put on a shared edge (so that a boundary is
///     followed from block to block), and for probes: where the corners of a block agree, its middle is computed all
///     the same, to find islands.
/// The rules for a point never depend on when it became known, and a split is never taken back. So the points to be
/// computed are the least set closed under these rules: a function of the chart alone, not of threads, stops or kills.
/// The rules may be applied at any time, while other points are still being computed: they then ask for some points of
/// the least set, and for no others.
///
/// In the end all computed points of a block that is not split are alike; the others in it are inferred.
namespace stridor::sweep {

/// The mark of a cell that is not computed yet.
inline constexpr int unknown_mark = -1;

/// Returns a cell's mark for refinement: cells with equal marks are alike. Never `unknown_mark`; always 0 in a chart
/// that is computed completely.
int mark_of(const Study& study, const Cell& cell);

/// Returns how often the grid of a chart may be halved [1], at most `asked`.
///
/// Seven blocks are left along each axis, as for 64 by 64 cells in the first look. A block whose four corners agree is
/// hardly examined inside, and a chart of 8 by 8 cells would be one such block.
int sound_refinement(const Study& study, int asked);

/// The cells to compute next, or the source of every cell.
struct Refinement {
    std::vector<std::size_t> missing;  // runs to compute next, by the index of their first cell; empty: all known
    std::vector<CellIndex> sources;    // if so, per cell the computed one that it takes after: itself, or the nearest
                                       // corner of its block (of equally near ones the first); shape [cell], or empty:
                                       // itself
};

/// Returns what to compute next, given the marks of all cells (shape [cell]); a run is known when all its cells are.
Refinement refine(const Study& study, std::span<const int> marks);

/// Returns the verdicts of all cells, given those of the computed ones: an inferred cell has the verdict of its source.
std::vector<CellVerdict> inferred(std::vector<CellVerdict> cells, std::span<const CellIndex> sources);

}  // namespace stridor::sweep
