#pragma once

#include "stridor/storage/waiting.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// Merging makes one store of a chart from the stores of its shares.
namespace stridor::sweep {

/// A store of a share, as it lies in the folder.
struct ShareStore {
    std::filesystem::path file;
    std::optional<Share> share;  // as its name tells; `std::nullopt` for another name
    bool is_filled = false;      // by another process at this moment: it is left alone
};

/// Returns all stores of shares of the chart in a folder, by name.
std::vector<ShareStore> share_stores(const std::filesystem::path& folder);

/// How to merge.
struct MergeOptions {
    std::stop_token stop;                  // asks for an early end
    storage::WaitOptions wait{};           // how to wait for another process that claims the chart's store
    std::function<void(double)> progress;  // [1] the part that is done; at most ten times a second
    std::size_t most_open = 256;           // [1] stores that are open at a time, at least 2: systems allow 1,024 files
};

/// The result of a merge.
struct MergeReport {
    std::size_t cells = 0;             // [1] in the merged store
    std::vector<std::size_t> missing;  // runs that are known to be needed, by the index of their first cell
    std::size_t missing_cells = 0;     // [1] of them
    std::vector<ShareStore> shares;
};

/// Merges all stores of shares, and the store of the chart if there is one, into a new store that takes its place:
/// FOLDER/chart.sqlite.
///
/// The cells stand in it in index order, and its bytes do not depend on the number of shares or of earlier merges.
/// Beyond `most_open` stores each is opened anew for each of its blocks. Memory grows with the open stores, and by four
/// bytes with each cell of the study. A store that is being filled is left out. Throws `Error`: input for a store of
/// another study or generation, io for a damaged one, for a cell that differs between two of them, and if the chart's
/// own store is being filled; interrupted on request. After any of these everything is as it was.
MergeReport merge(const Study& study, const std::filesystem::path& folder, const MergeOptions& options = {});

}  // namespace stridor::sweep
