#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Shares: a chart computed by several programs that know nothing of each other.
///
/// The runs of a chart are dealt out in blocks of neighbours, one block to each share in turn, since noisy regions cost
/// more than quiet ones. Who computes what depends on the study and the number of shares alone, so nobody has to ask.
namespace stridor::sweep {

/// Neighbouring runs that belong to one share: long enough that a share's cells lie side by side in its store, short
/// enough that costly regions are dealt to many. Changing it leaves half-finished shares with the wrong runs.
inline constexpr std::size_t runs_per_block = 1024;

/// Most shares of one chart: the places of their files' names.
inline constexpr std::size_t most_shares = 9999;

/// One share of a chart; as it stands here the whole of it.
struct Share {
    std::size_t index = 0;  // [1] from 0 to count - 1
    std::size_t count = 1;  // [1]
    bool operator==(const Share&) const = default;
};

/// Does a run, by the index of its first cell, belong to a share?
bool is_in(const Share& share, std::size_t run);

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

}  // namespace stridor::sweep
