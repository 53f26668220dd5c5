#include "stridor/sweep/store/share_keeper.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace stridor::sweep {

namespace {

constexpr std::size_t cells_at_once = 4096;  // [1] of either store in memory

std::vector<IndexedCell> cells_between(Store& store, std::size_t first, std::size_t last) {
    std::vector<IndexedCell> cells;
    store.visit(first, last, [&](IndexedCell& cell) { cells.push_back(std::move(cell)); });
    return cells;
}

}  // namespace

ShareKeeper::ShareKeeper(const std::filesystem::path& own, const std::filesystem::path& merged, const Study& study,
                         const storage::WaitOptions& wait)
    : merged_(std::filesystem::exists(merged) ? std::make_unique<Store>(merged, study, StoreUse::read) : nullptr),
      own_(own, study, StoreUse::fill, wait) {}

std::vector<bool> ShareKeeper::stored() {
    std::vector<bool> found = own_.stored();
    if (!merged_) return found;
    const std::vector<bool> merged = merged_->stored();
    std::transform(found.begin(), found.end(), merged.begin(), found.begin(), std::logical_or<>());
    return found;
}

Counts ShareKeeper::counts() {
    if (!merged_) return own_.counts();
    Counts counts = merged_->counts();
    const std::vector<bool> merged = merged_->stored();
    own_.visit(0, merged.size(), [&](const IndexedCell& indexed) {
        if (!merged[indexed.index]) count(counts, verdict_of(indexed.cell));
    });
    return counts;
}

void ShareKeeper::visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) {
    if (!merged_) {
        own_.visit(first, last, use);
        return;
    }
    for (; first < last; first += std::min(last - first, cells_at_once)) {
        const std::size_t end = first + std::min(last - first, cells_at_once);
        std::vector<IndexedCell> own = cells_between(own_, first, end);
        std::vector<IndexedCell> merged = cells_between(*merged_, first, end);
        auto theirs = merged.begin();
        for (IndexedCell& cell : own) {
            for (; theirs != merged.end() && theirs->index < cell.index; ++theirs)
                use(*theirs);
            if (theirs != merged.end() && theirs->index == cell.index) ++theirs;
            use(cell);
        }
        for (; theirs != merged.end(); ++theirs)
            use(*theirs);
    }
}

}  // namespace stridor::sweep
