#include "stridor/io/chart/slurm_script.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

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

}  // namespace stridor::io
