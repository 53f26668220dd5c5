#include "stridor/io/chart/share_texts.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/json_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>
#include <vector>

namespace stridor::io {

namespace {

// one word for the shell, whatever stands in it
std::string quoted(const std::string& text) {
    std::string word = "'";
    for (const char c : text)
        word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + "'";
}

// "120", "2:00:00", "1-12", "1-12:30:00"
bool is_time(const std::string& text) {
    const bool has_digits = !text.empty() && text.front() >= '0' && text.front() <= '9' && text.back() >= '0' &&
                            text.back() <= '9' && text.size() < 20;
    return has_digits &&
           std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || c == ':' || c == '-'; });
}

// {0} version, {1} program, {2} folder, {3} shares, {4} threads, {5} limit of time, {6} rounds, {7} name
constexpr const char* script = R"sh(#!/bin/bash
#SBATCH --job-name={7}
#SBATCH --ntasks=1
#SBATCH --open-mode=append
# A chart on a cluster, written by stridor {0}: an array of shares, then the merge, again until nothing is missing,
# then the figures. Submit it with sbatch; where jobs may not submit jobs run it with bash.
# What goes on: stridor chart-status {2}
# To end all of it: scancel --name={7}
program={1}
folder={2}
shares={3}
threads={4}
limits=({5})
most_rounds={6}

if [ ! -f "$0" ]; then
    echo "Keep this script in a file, and run that." >&2
    exit 2
fi

# One round: the shares that lack cells, and after them, however they ended, the merge. A task that Slurm requeues or
# ends goes on from what its store holds; it has 30 s to keep what it has.
submit() {{
    tasks=$("$program" chart-status "$folder" --lacking "$shares")
    array=$(sbatch --parsable --array="${{tasks:-0-$((shares - 1))}}" --requeue --signal=B:TERM@30 \
        --cpus-per-task="$threads" "${{limits[@]}}" --output="$folder/slurm-%A-%a.log" "$0" share) || exit
    array=${{array%%;*}}
    after=$(sbatch --parsable --dependency="afterany:$array" --cpus-per-task="$threads" "${{limits[@]}}" \
        --output="$folder/slurm-%j-merge.log" "$0" merge "$1") || exit
    echo "round $1: shares in job $array, merge in job ${{after%%;*}}"
}}

case ${{1:-submit}} in
submit)
    submit 1
    ;;
share)
    # by number: a task that is submitted again alone has the same share
    exec "$program" chart "$folder/chart.toml" --out "$folder" --shard "$SLURM_ARRAY_TASK_ID/$shares" \
        --threads "$threads"
    ;;
merge)
    "$program" merge "$folder"
    code=$?
    if [ $code -eq 4 ] && [ "$2" -lt "$most_rounds" ]; then
        submit $(($2 + 1))
        exit
    fi
    [ $code -eq 0 ] || exit $code
    exec "$program" chart "$folder/chart.toml" --out "$folder" --threads "$threads"
    ;;
esac
)sh";

using namespace json_parts;
using sweep::Share;
using sweep::StoreStanding;
using sweep::StoreState;

constexpr std::size_t most_lines = 20;  // [1] of stores in a text

std::string cells(std::size_t number) {
    return fmt::format("{} cell{}", number, number == 1 ? "" : "s");
}

std::string owner_text(const storage::SeenOwner& seen) {
    return storage::text_of(seen.owner) + ", last heard of " + storage::ago_text(seen.silence);
}

std::string standing_text(const StoreState& state) {
    switch (state.standing) {
        case StoreStanding::missing:
            return fmt::format("not begun, {} missing", cells(state.missing));
        case StoreStanding::filled:
            return fmt::format("{} so far, filled by {}", cells(state.cells), owner_text(*state.owner));
        case StoreStanding::unreadable:
            return state.problem;
        case StoreStanding::complete:
            return cells(state.cells);
        case StoreStanding::partial:
            break;
    }
    const std::string left = state.owner ? "; left by " + owner_text(*state.owner) : "";
    return fmt::format("{}, {} missing{}", cells(state.cells), state.missing, left);
}

// "15 of 16 shares, 5 of 5 shares": of each number into which the chart was cut
std::string shares_text(const std::map<std::size_t, std::size_t>& there) {
    std::string text;
    for (const auto& [count, found] : there)
        text += fmt::format("{}{} of {} share{}", text.empty() ? "" : ", ", found, count, count == 1 ? "" : "s");
    return text.empty() ? "no shares" : text;
}

Json owner_object(const std::optional<storage::SeenOwner>& seen) {
    if (!seen) return nullptr;
    return {{"host", seen->owner.host},
            {"process", seen->owner.process},
            {"job", seen->owner.job.empty() ? Json(nullptr) : Json(seen->owner.job)},
            {"silence", seen->silence}};
}

Json store_object(const StoreState& state) {
    Json object{{"file", state.file.string()},
                {"standing", name_of(sweep::standing_names, state.standing)},
                {"cells", state.cells},
                {"owner", owner_object(state.owner)}};
    if (state.share) object["share"] = text_of(*state.share);
    object["missing"] = state.missing;
    if (!state.problem.empty()) object["problem"] = state.problem;
    return object;
}

}  // namespace

std::string slurm_script(const SlurmJob& job) {
    if (!job.time.empty() && !is_time(job.time))
        throw Error(ErrorKind::input, {"\"" + job.time + "\" is no time limit",
                                       "Slurm reads minutes, HOURS:MINUTES:SECONDS and DAYS-HOURS", "--time 2:00:00"});
    for (const std::string& path : {job.program, job.folder})
        if (path.find('\n') != std::string::npos)
            throw Error(ErrorKind::input, {"the path \"" + path + "\" has a line end", "a job script is read by lines",
                                           "Choose another --out."});
    std::string name = "stridor-";
    for (const char c : std::filesystem::path(job.folder).filename().string())
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '-';
    return fmt::format(script, base::version(), quoted(job.program), quoted(job.folder), job.shares, job.threads,
                       job.time.empty() ? "" : "--time=" + job.time, most_slurm_rounds, name);
}

std::string status_text(const sweep::Study& study, const sweep::ChartState& state) {
    const bool is_refined = study.refine != 0;
    std::string text = fmt::format("{} of {}{} done", state.done, is_refined && !state.is_merged ? "at least " : "",
                                   cells(state.total));
    std::map<std::size_t, std::size_t> there;
    for (const StoreState& share : state.shares)
        if (share.share) there[share.share->count] += share.standing == StoreStanding::missing ? 0 : 1;
    if (!there.empty()) text += "; " + shares_text(there);
    text += state.is_merged ? ", all in " + state.chart.file.string() + "\n" : "\n";
    const bool is_told = state.chart.standing != StoreStanding::missing && !state.is_merged;
    if (is_told) text += "  " + state.chart.file.filename().string() + ": " + standing_text(state.chart) + "\n";
    std::size_t lines = 0;
    for (const StoreState& share : state.shares) {
        // more shares than blocks of runs leave some with nothing to do
        const bool is_idle = share.standing == StoreStanding::missing && share.missing == 0;
        if (share.standing == StoreStanding::complete || is_idle || state.is_merged) continue;
        if (++lines > most_lines) continue;
        text += "  " + (share.share ? text_of(*share.share) : share.file.filename().string()) + ": " +
                standing_text(share) + "\n";
    }
    if (lines > most_lines) text += fmt::format("  and {} more\n", lines - most_lines);
    return text;
}

std::string lacking_text(const sweep::ChartState& state, std::size_t count) {
    std::vector<bool> lacks(count, !state.is_merged);
    for (const StoreState& share : state.shares)
        if (share.share && share.share->count == count)
            lacks[share.share->index] = share.missing > 0 || share.standing == StoreStanding::unreadable;
    std::string text;
    for (std::size_t first = 0; first < count; ++first) {
        if (!lacks[first]) continue;
        std::size_t last = first;
        while (last + 1 < count && lacks[last + 1])
            ++last;
        text += (text.empty() ? "" : ",") + std::to_string(first);
        if (last > first) text += "-" + std::to_string(last);
        first = last;
    }
    return text;
}

std::string status_json(const sweep::Study& study, const sweep::ChartState& state) {
    Json document = json_parts::opening("chart-status");
    document["refined"] = study.refine != 0;
    document["complete"] = state.is_merged;
    document["cells"] = {{"done", state.done}, {"known", state.total}};
    document["chart"] = store_object(state.chart);
    document["shares"] = json_parts::array_of(state.shares, [](const auto& each) { return store_object(each); });
    return document.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string missing_text(const sweep::Study& study, const sweep::MergeReport& report) {
    if (report.missing.empty()) return {};
    std::map<std::size_t, std::size_t> there;
    std::map<std::pair<std::size_t, std::size_t>, const sweep::ShareStore*> stores;
    for (const sweep::ShareStore& store : report.shares)
        if (store.share) {
            ++there[store.share->count];
            stores[{store.share->count, store.share->index}] = &store;
        }
    std::string text = fmt::format("{}, {}{} missing\n", shares_text(there), study.refine == 0 ? "" : "at least ",
                                   cells(report.missing_cells));
    std::size_t lines = 0;
    for (const auto& [count, found] : there) {
        std::vector<std::size_t> runs(count);
        for (const std::size_t run : report.missing)
            ++runs[share_of_run(study, count, run)];
        for (std::size_t index = 0; index < count; ++index) {
            const auto store = stores.find({count, index});
            if (runs[index] == 0 || ++lines > most_lines) continue;
            const std::string_view why = store == stores.end()      ? " (not begun)"
                                         : store->second->is_filled ? " (being filled)"
                                                                    : "";
            text += fmt::format("  {}: {} run{} missing{}\n", text_of(Share{index, count}), runs[index],
                                runs[index] == 1 ? "" : "s", why);
        }
    }
    if (lines > most_lines) text += fmt::format("  and {} more\n", lines - most_lines);
    return text;
}

}  // namespace stridor::io
