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

/// How many cells there are of each kind.
struct Counts {
    std::array<std::size_t, status_names.size()> statuses{};  // [1] by Status
    // [1] by Category, done cells only; those that lock are none of them
    std::array<std::size_t, classification::category_names.size()> categories{};
    std::size_t locks = 0;  // [1] silent because they lock
};

/// Adds a finished cell.
void count(Counts& counts, const CellVerdict& cell);

/// The computed cells of a sweep while it runs: it begins with those that are there and hands over what it computes.
class CellKeeper : public ComputedCells {
public:
    /// What messages call it: "the store chart.sqlite".
    virtual std::string name() const = 0;

    /// Which cells are there; shape [cell].
    virtual std::vector<bool> stored() = 0;

    /// How many cells are there, by status and category.
    virtual Counts counts() = 0;

    /// Keeps cells, none of which is there yet, all or none of them.
    virtual void write(std::span<const IndexedCell> cells) = 0;
};

/// Keeps the cells of a small sweep in memory, for one who only looks at it and needs no file.
class MemoryKeeper final : public CellKeeper {
public:
    /// Without cells.
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

/// The finished sweep; cells that refinement left out are inferred, the computed ones stay where they are kept. Throws
/// `Error` (interrupted) if cells are missing.
SweepResult load(const Study& study, std::shared_ptr<CellKeeper> keeper);

/// A sweep that is not finished: each cell that is not there takes after the nearest one that is (in grid steps; of
/// equally near ones the first). Of a direction of which none is there yet no cell has a result.
SweepResult provisional(const Study& study, std::shared_ptr<CellKeeper> keeper);

}  // namespace stridor::sweep
