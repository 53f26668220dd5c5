#pragma once

#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/store/store.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace stridor::sweep {

/// Where the shares of a chart in this folder are kept: "pair/shards".
std::filesystem::path shares_folder(const std::filesystem::path& folder);

/// The store of one share: "pair/shards/0003-of-0016.sqlite".
std::filesystem::path share_file(const std::filesystem::path& folder, const Share& share);

/// The cells that a share of a chart knows: those that were merged before, which it only reads, and its own, to which
/// it adds. So a share of a refined chart goes on from what all of them have found.
class ShareKeeper final : public CellKeeper {
public:
    /// Keeps cells in the store `own`; `merged` need not be there. Throws what a `Store` throws.
    ShareKeeper(const std::filesystem::path& own, const std::filesystem::path& merged, const Study& study,
                const storage::WaitOptions& wait = {});

    /// The share's own store.
    const Store& own() const { return own_; }

    std::string name() const override { return own_.name(); }

    /// In either.
    std::vector<bool> stored() override;

    /// A cell in both counts once.
    Counts counts() override;

    /// Into its own store.
    void write(std::span<const IndexedCell> cells) override { own_.write(cells); }

    /// Of a cell in both stores the own one, which is the same.
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

private:
    std::unique_ptr<Store> merged_;  // nothing before the first merge
    Store own_;
};

}  // namespace stridor::sweep
