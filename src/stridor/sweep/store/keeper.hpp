#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stridor::sweep {

/// The number of cells of each kind.
struct Counts {
    std::array<std::size_t, status_names.size()> statuses{};  // [1] by Status
    // [1] by Category, done cells only; those that lock are none of them
    std::array<std::size_t, classification::category_names.size()> categories{};
    std::size_t locks = 0;  // [1] silent because they lock
};

/// Adds a finished cell to the counts.
void count(Counts& counts, const CellVerdict& cell);

/// The computed cells of a sweep while it runs: first those that exist, then those that it computes.
class CellKeeper : public ComputedCells {
public:
    /// Returns the name in messages: "the store chart.sqlite".
    virtual std::string name() const = 0;

    /// Returns which cells are there; shape [cell].
    virtual std::vector<bool> stored() = 0;

    /// Returns the number of cells that are there, by status and category.
    virtual Counts counts() = 0;

    /// Keeps cells, all or none of them. None of them may be there yet.
    virtual void write(std::span<const IndexedCell> cells) = 0;
};

/// Keeps the cells of a small sweep in memory, for a caller that needs no file.
class MemoryKeeper final : public CellKeeper {
public:
    /// Begins without cells.
    explicit MemoryKeeper(const Study& study) : places_(cell_count(study), nowhere) {}

    std::string name() const override { return "the chart in memory"; }
    std::vector<bool> stored() override;
    Counts counts() override;
    void write(std::span<const IndexedCell> cells) override;
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

private:
    static constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
    std::vector<std::size_t> places_;  // in cells_; shape [cell]
    std::vector<IndexedCell> cells_;   // in the order in which they came
};

/// Returns the finished sweep; cells that refinement left out are inferred, the computed ones stay in the keeper.
/// Throws `Error` (interrupted) if cells are missing.
SweepResult load(const Study& study, std::shared_ptr<CellKeeper> keeper);

/// Returns a sweep that is not finished: a missing cell takes the verdict of the nearest one (in grid steps; the first
/// of equally near ones). A direction without any cell has no results.
SweepResult provisional(const Study& study, std::shared_ptr<CellKeeper> keeper);

}  // namespace stridor::sweep
