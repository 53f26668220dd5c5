#pragma once

#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

/// Shares: a chart computed by several programs that know nothing of each other.
///
/// The runs of a chart are dealt out in blocks of neighbours, one block to each share in turn, since noisy regions cost
/// more than quiet ones. The division depends on the study and the number of shares alone, so the programs need no
/// messages.
namespace stridor::sweep {

/// Returns the number of neighbouring runs that belong to one share [1], from 1 to 1024: many, so that a share's cells
/// lie side by side in its store, but so few that each share has blocks all over the chart and costly regions are dealt
/// to many. Changing the rule leaves half-finished shares with the wrong runs.
std::size_t runs_per_block(const Study& study, std::size_t shares);

/// Most shares of one chart: their files' names have four digits.
inline constexpr std::size_t most_shares = 9999;

/// One share of a chart; by default the whole chart.
struct Share {
    std::size_t index = 0;  // [1] from 0 to count - 1
    std::size_t count = 1;  // [1]
    bool operator==(const Share&) const = default;
};

/// Returns the share, of `shares`, to which a run belongs, by the index of its first cell.
std::size_t share_of_run(const Study& study, std::size_t shares, std::size_t run);

/// Says whether a run belongs to a share.
bool is_in(const Share& share, const Study& study, std::size_t run);

/// Returns a share as text: "3/16".
std::string text_of(const Share& share);

/// Returns the name of a share's file: "0003-of-0016", which sorts as the numbers do.
std::string file_name_of(const Share& share);

/// Returns the share with this file name, or `std::nullopt` if it is not one.
std::optional<Share> share_of_file_name(std::string_view name);

/// Reads "3/16". Throws `Error` (input) for any other text, with the form that was expected.
Share read_share(std::string_view text);

/// The variables that a task of a Slurm array has; empty where they are not set.
struct ArrayTask {
    std::string id;     // SLURM_ARRAY_TASK_ID
    std::string first;  // SLURM_ARRAY_TASK_MIN
    std::string count;  // SLURM_ARRAY_TASK_COUNT
};

/// Returns the share of a task: arrays may begin at any number. Throws `Error` (input) that names a missing variable,
/// and for an array that has gaps.
Share share_of(const ArrayTask& task);

/// Returns the folder of the shares of a chart in this folder: "pair/shards".
std::filesystem::path shares_folder(const std::filesystem::path& folder);

/// Returns the file of one share's store: "pair/shards/0003-of-0016.sqlite".
std::filesystem::path share_file(const std::filesystem::path& folder, const Share& share);

}  // namespace stridor::sweep
