#pragma once

#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Shares: a chart computed by several programs that know nothing of each other.
///
/// The runs of a chart are dealt out in blocks of neighbours, one block to each share in turn, since noisy regions cost
/// more than quiet ones. Who computes what depends on the study and the number of shares alone, so nobody has to ask.
namespace stridor::sweep {

/// Neighbouring runs that belong to one share: many, so that a share's cells lie side by side in its store, but so few
/// that each share has blocks all over the chart and costly regions are dealt to many. From 1 to 1024. Changing the
/// rule leaves half-finished shares with the wrong runs.
std::size_t runs_per_block(const Study& study, std::size_t shares);

/// Most shares of one chart: the places of their files' names.
inline constexpr std::size_t most_shares = 9999;

/// One share of a chart; as it stands here the whole of it.
struct Share {
    std::size_t index = 0;  // [1] from 0 to count - 1
    std::size_t count = 1;  // [1]
    bool operator==(const Share&) const = default;
};

/// Which of so many shares a run belongs to, by the index of its first cell.
std::size_t share_of_run(const Study& study, std::size_t shares, std::size_t run);

/// Does a run belong to a share?
bool is_in(const Share& share, const Study& study, std::size_t run);

/// "3/16".
std::string text_of(const Share& share);

/// "0003-of-0016": sorts as the numbers do.
std::string file_name_of(const Share& share);

/// The share with this file name; nothing where it is no share's.
std::optional<Share> share_of_file_name(std::string_view name);

/// Reads "3/16". Throws `Error` (input) for what is no share, with what was meant.
Share read_share(std::string_view text);

/// The variables that a task of a Slurm array has; empty where they are not set.
struct ArrayTask {
    std::string id;     // SLURM_ARRAY_TASK_ID
    std::string first;  // SLURM_ARRAY_TASK_MIN
    std::string count;  // SLURM_ARRAY_TASK_COUNT
};

/// The share of a task: arrays may begin at any number. Throws `Error` (input) with what is missing, and for an array
/// that has gaps.
Share share_of(const ArrayTask& task);

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
