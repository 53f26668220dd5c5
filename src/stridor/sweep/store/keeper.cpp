#include "stridor/sweep/store/keeper.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/refinement.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace stridor::sweep {

namespace {

// per cell the nearest of the cells that are there, direction by direction; distance is the larger one of the grid
// steps in x and y
std::vector<CellIndex> nearest(const Study& study, const std::vector<bool>& there) {
    const std::size_t columns = static_cast<std::size_t>(study.x.points);
    const std::size_t points = columns * static_cast<std::size_t>(study.y.points);
    constexpr CellIndex none = std::numeric_limits<CellIndex>::max();
    std::vector<CellIndex> sources(there.size(), none);
    std::vector<std::size_t> reached;  // in the order of their distance, the cells that are there first
    for (std::size_t index = 0; index < there.size(); ++index)
        if (there[index]) {
            sources[index] = static_cast<CellIndex>(index);
            reached.push_back(index);
        }
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const std::size_t index = reached[next];
        const std::size_t x = index % columns;
        const std::size_t y = index % points / columns;
        for (std::size_t row = std::max<std::size_t>(y, 1) - 1; row <= y + 1 && row * columns < points; ++row)
            for (std::size_t column = std::max<std::size_t>(x, 1) - 1; column <= x + 1 && column < columns; ++column) {
                const std::size_t neighbour = index - index % points + row * columns + column;
                if (sources[neighbour] != none) continue;
                sources[neighbour] = sources[index];
                reached.push_back(neighbour);
            }
    }
    return sources;
}

}  // namespace

void count(Counts& counts, const CellVerdict& cell) {
    ++counts.statuses[static_cast<std::size_t>(cell.status)];
    if (cell.status != Status::done) return;
    ++(cell.quiet == classification::Quiet::locks ? counts.locks
                                                  : counts.categories[static_cast<std::size_t>(cell.category)]);
}

std::vector<bool> MemoryKeeper::stored() {
    std::vector<bool> there(places_.size());
    for (const IndexedCell& indexed : cells_)
        there[indexed.index] = true;
    return there;
}

Counts MemoryKeeper::counts() {
    Counts counts;
    for (const IndexedCell& indexed : cells_)
        count(counts, verdict_of(indexed.cell));
    return counts;
}

void MemoryKeeper::write(std::span<const IndexedCell> cells) {
    for (const IndexedCell& indexed : cells) {
        STRIDOR_EXPECT(indexed.index < places_.size() && places_[indexed.index] == nowhere);
        places_[indexed.index] = cells_.size();
        cells_.push_back(indexed);
    }
}

void MemoryKeeper::visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) {
    for (std::size_t index = first; index < std::min(last, places_.size()); ++index)
        if (places_[index] != nowhere) {
            IndexedCell copy = cells_[places_[index]];
            use(copy);
        }
}

SweepResult load(const Study& study, std::shared_ptr<CellKeeper> keeper) {
    std::vector<CellVerdict> cells(cell_count(study));
    std::vector<int> marks(study.refine == 0 ? 0 : cells.size(), unknown_mark);
    std::size_t there = 0;
    const auto take = [&](const IndexedCell& indexed) {
        if (study.refine > 0) marks[indexed.index] = mark_of(study, indexed.cell);
        cells[indexed.index] = verdict_of(indexed.cell);
        ++there;
    };
    if (study.refine > 0)
        keeper->visit(0, cells.size(), take);
    else
        keeper->visit_figures(0, cells.size(), {}, take);
    Refinement refinement;
    if (study.refine > 0) refinement = refine(study, marks);
    const std::size_t needed =
        study.refine == 0 ? cells.size() : there + refinement.missing.size() * directions_per_run(study);
    if (there < needed)
        throw Error(ErrorKind::interrupted,
                    {"the sweep is not finished",
                     keeper->name() + " holds " + std::to_string(there) + " of " +
                         (study.refine == 0 ? "" : "at least ") + std::to_string(needed) + " cells",
                     "Run the same command again: it goes on where it stopped."});
    cells = inferred(std::move(cells), refinement.sources);
    return {study, std::move(cells), std::move(refinement.sources), std::move(keeper)};
}

SweepResult provisional(const Study& study, std::shared_ptr<CellKeeper> keeper) {
    std::vector<CellVerdict> cells(cell_count(study));
    keeper->visit(0, cells.size(),
                  [&](const IndexedCell& indexed) { cells[indexed.index] = verdict_of(indexed.cell); });
    std::vector<CellIndex> sources = nearest(study, keeper->stored());
    // a direction of which nothing is known yet has no result at all
    for (std::size_t index = 0; index < sources.size(); ++index)
        if (sources[index] >= cells.size()) sources[index] = static_cast<CellIndex>(index);
    cells = inferred(std::move(cells), sources);
    return {study, std::move(cells), std::move(sources), std::move(keeper)};
}

}  // namespace stridor::sweep
