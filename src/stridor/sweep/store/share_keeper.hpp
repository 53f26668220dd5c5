#pragma once

#include "stridor/storage/waiting.hpp"
#include "stridor/sweep/store/keeper.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stridor::sweep {

/// The cells that a share of a chart knows: those merged before, which it only reads, and its own, to which it adds. So
/// a share of a refined chart goes on from the cells of all shares.
class ShareKeeper final : public CellKeeper {
public:
    /// Opens or makes the store `own`; `merged` need not exist. Throws what a `Store` throws.
    ShareKeeper(const std::filesystem::path& own, const std::filesystem::path& merged, const Study& study,
                const storage::WaitOptions& wait = {});

    /// Returns the share's own store.
    const Store& own() const { return own_; }

    std::string name() const override { return own_.name(); }

    /// Returns which cells are in either store; shape [cell].
    std::vector<bool> stored() override;

    /// Returns the counts of both stores; a cell in both counts once.
    Counts counts() override;

    /// Writes cells into the share's own store.
    void write(std::span<const IndexedCell> cells) override { own_.write(cells); }

    /// Shows the cells of both stores; a cell in both is read from the own one.
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

private:
    std::unique_ptr<Store> merged_;  // null before the first merge
    Store own_;
};

}  // namespace stridor::sweep
