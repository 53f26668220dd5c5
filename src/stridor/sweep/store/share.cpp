#include "stridor/sweep/store/share.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace stridor::sweep {

namespace {

// so that the costs of shares differ little
constexpr std::size_t blocks_per_share = 16;
constexpr std::size_t most_runs_per_block = 1024;

std::optional<std::size_t> whole_number(std::string_view text) {
    std::size_t number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (text.empty() || failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

Share checked(const Share& share, const std::string& text) {
    if (share.count == 0 || share.count > most_shares)
        throw Error(
            ErrorKind::input,
            {text + " is no share", fmt::format("a chart is cut into 1 to {} shares", most_shares), "Choose fewer."});
    if (share.index >= share.count)
        throw Error(ErrorKind::input, {text + " is no share",
                                       share.count == 1 ? "the only one is 0/1"
                                                        : fmt::format("{0} shares count from 0/{0} to {1}/{0}",
                                                                      share.count, share.count - 1),
                                       ""});
    return share;
}

}  // namespace

std::size_t runs_per_block(const Study& study, std::size_t shares) {
    STRIDOR_EXPECT(shares > 0);
    // runs of both directions have the indices of the first
    const std::size_t runs = cell_count(study) / directions_per_run(study);
    return std::clamp<std::size_t>(runs / (blocks_per_share * shares), 1, most_runs_per_block);
}

std::size_t share_of_run(const Study& study, std::size_t shares, std::size_t run) {
    return run / runs_per_block(study, shares) % shares;
}

bool is_in(const Share& share, const Study& study, std::size_t run) {
    STRIDOR_EXPECT(share.index < share.count);
    return share.count == 1 || share_of_run(study, share.count, run) == share.index;
}

std::string text_of(const Share& share) {
    return fmt::format("{}/{}", share.index, share.count);
}

std::string file_name_of(const Share& share) {
    return fmt::format("{:04}-of-{:04}", share.index, share.count);
}

std::optional<Share> share_of_file_name(std::string_view name) {
    constexpr std::string_view between = "-of-";
    const std::size_t place = name.find(between);
    if (place == std::string_view::npos) return std::nullopt;
    const std::optional<std::size_t> index = whole_number(name.substr(0, place));
    const std::optional<std::size_t> count = whole_number(name.substr(place + between.size()));
    if (!index || !count || *index >= *count || file_name_of({*index, *count}) != name) return std::nullopt;
    return Share{*index, *count};
}

Share read_share(std::string_view text) {
    const std::size_t slash = text.find('/');
    const std::optional<std::size_t> index = whole_number(text.substr(0, slash));
    const std::optional<std::size_t> count =
        slash == std::string_view::npos ? std::nullopt : whole_number(text.substr(slash + 1));
    const std::string quoted = '"' + std::string(text) + '"';
    if (!index || !count)
        throw Error(ErrorKind::input, {quoted + " is no share", "a share is INDEX/COUNT, counted from 0: 3/16",
                                       "In a task of a Slurm array use `auto`."});
    return checked({*index, *count}, quoted);
}

Share share_of(const ArrayTask& task) {
    const std::pair<const char*, const std::string*> variables[] = {{"SLURM_ARRAY_TASK_ID", &task.id},
                                                                    {"SLURM_ARRAY_TASK_MIN", &task.first},
                                                                    {"SLURM_ARRAY_TASK_COUNT", &task.count}};
    std::size_t numbers[3] = {};
    std::size_t k = 0;
    for (const auto& [name, text] : variables) {
        const std::optional<std::size_t> number = whole_number(*text);
        if (!number)
            throw Error(ErrorKind::input,
                        {"there is no share to be found",
                         text->empty() ? fmt::format("{} is not set, as it is in each task of a Slurm array", name)
                                       : fmt::format("{} is \"{}\", which is no number", name, *text),
                         "Name the share: INDEX/COUNT, counted from 0, such as 3/16."});
        numbers[k++] = *number;
    }
    const auto [id, first, count] = numbers;
    if (id < first || id - first >= count)
        throw Error(ErrorKind::input,
                    {fmt::format("task {} of the array has no share", id),
                     fmt::format("the array has {} tasks from {} on and so has gaps", count, first),
                     "Submit an array without gaps, such as --array=0-15, or name the share: INDEX/COUNT."});
    return checked({id - first, count}, fmt::format("task {} of an array of {}", id, count));
}

std::filesystem::path shares_folder(const std::filesystem::path& folder) {
    return folder / "shards";
}

std::filesystem::path share_file(const std::filesystem::path& folder, const Share& share) {
    return shares_folder(folder) / (file_name_of(share) + ".sqlite");
}

}  // namespace stridor::sweep
