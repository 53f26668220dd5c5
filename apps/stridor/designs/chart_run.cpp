#include "designs/chart_run.hpp"

#include "arguments.hpp"
#include "commands.hpp"
#include "crews.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/share_texts.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/store/chart_state.hpp"
#include "stridor/sweep/store/merge.hpp"
#include "stridor/sweep/store/share.hpp"
#include "stridor/sweep/store/share_keeper.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

namespace stridor::app {

namespace {

// who stands still may have it open, too; what it keeps is soon computed again
void forget(const std::filesystem::path& kept) {
    std::error_code stays;
    for (const char* ending : {"", "-journal"})
        std::filesystem::remove(kept.string() + ending, stays);
}

}  // namespace

sweep::RunReport fill(const sweep::Study& study, sweep::CellKeeper& keeper, sweep::RunOptions options,
                      const Interrupt& interrupt) {
    console::ProgressDisplay display;
    options.stop = interrupt.token();
    options.progress = [&](const sweep::Progress& progress) { display.show(progress); };
    const sweep::RunReport report = sweep::run(study, keeper, options);
    display.finish();
    return report;
}

Error stopped(const sweep::RunReport& report, const std::filesystem::path& store_file) {
    return Error(ErrorKind::interrupted,
                 {fmt::format("stopped with {} of {} cells done", report.progress.done, report.progress.total),
                  "all of them are kept in " + store_file.string(), "Run the same command again to go on."});
}

void say_takeover(const sweep::Store& store) {
    if (const auto& former = store.replaced())
        console::say_note(fmt::format("took over {} from {}, last heard of {}", store.name(),
                                      storage::text_of(former->owner), storage::ago_text(former->silence)));
}

sweep::SweepResult compute(const sweep::Study& study, const std::filesystem::path& store_file, int threads) {
    std::shared_ptr<sweep::Store> store;
    {
        const Interrupt interrupt;
        store = std::make_shared<sweep::Store>(store_file, study, sweep::StoreUse::fill, waiting(interrupt.token()));
        say_takeover(*store);
        if (store->was_handed_over()) forget(store_file.parent_path() / "diagram.sqlite");
        sweep::RunOptions options;
        options.crew = crews(threads);
        const sweep::RunReport report = fill(study, *store, options, interrupt);
        if (report.ending == sweep::SweepEnding::stopped) throw stopped(report, store_file);
    }
    return sweep::load(study, store);
}

std::vector<sweep::DiagramCell> compute_diagram(const sweep::SweepResult& result, const std::filesystem::path& file,
                                                int threads) {
    storage::KeptResults kept(file, sweep::diagram_text(result.study), "diagram");
    const Interrupt interrupt;
    console::ShareDisplay display("diagram:", console::TimeLeft::shown);
    sweep::DiagramOptions options;
    options.crew = crews(threads);
    options.stop = interrupt.token();
    options.kept = &kept;
    if (kept.found() < result.cells.size()) options.progress = [&](double share) { display.show(share); };
    return sweep::diagram(result, options);
}

namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

sweep::Share share_named(const std::string& text) {
    if (text != "auto") return sweep::read_share(text);
    return sweep::share_of(
        {variable("SLURM_ARRAY_TASK_ID"), variable("SLURM_ARRAY_TASK_MIN"), variable("SLURM_ARRAY_TASK_COUNT")});
}

// The resolved chart stands in the folder before its cells: all shares, the merge and the status read the same one.
void keep_chart_file(const sweep::Study& study, const fs::path& folder) {
    const fs::path file = folder / "chart.toml";
    if (fs::exists(file) && canonical_text(io::read_study(file.string())) != canonical_text(study))
        throw Error(ErrorKind::input, {"the folder " + folder.string() + " holds another chart",
                                       file.string() + " differs from this one in what decides the results",
                                       "Choose another --out, or remove that file and the stores beside it."});
    storage::make_folder(sweep::shares_folder(folder), "Choose another --out.");
    storage::write_file(file.string(), io::study_toml(study));
}

void merge_command(const std::string& folder) {
    const sweep::Study study = io::read_study((fs::path(folder) / "chart.toml").string());
    const Interrupt interrupt;
    console::ShareDisplay display("merged:", console::TimeLeft::shown);
    sweep::MergeOptions options;
    options.stop = interrupt.token();
    options.wait = waiting(interrupt.token());
    options.progress = [&](double share) { display.show(share); };
    const sweep::MergeReport report = sweep::merge(study, folder, options);
    const std::string merged = (fs::path(folder) / "chart.sqlite").string();
    console::print(fmt::format("{} cells in {}\n", report.cells, merged));
    if (report.missing.empty()) {
        console::print(fmt::format("complete; to draw it: stridor chart {0}/chart.toml --out {0}\n", folder));
        return;
    }
    console::print(io::missing_text(study, report));
    throw Error(ErrorKind::interrupted,
                {"the chart is not complete yet",
                 study.refine == 0 ? "cells are missing"
                                   : "cells are missing: a refined chart takes its shares and the merge several times",
                 "Run the shares again, then the merge; or: stridor chart " + folder + "/chart.toml --out " + folder});
}

struct StatusOptions {
    std::string folder;
    bool json = false;
    std::size_t lacking = 0;  // [1] shares; 0: all is told
};

void chart_status(const StatusOptions& options) {
    const sweep::Study study = io::read_study((fs::path(options.folder) / "chart.toml").string());
    const sweep::ChartState state = sweep::chart_state(study, options.folder);
    if (options.lacking > 0) {
        const std::string lacking = io::lacking_text(state, options.lacking);
        console::print(lacking.empty() ? "" : lacking + "\n");
        return;
    }
    console::print(options.json ? io::status_json(study, state) + "\n" : io::status_text(study, state));
}

}  // namespace

void expect_merged(const sweep::Study& study, const fs::path& folder) {
    if (!fs::exists(sweep::shares_folder(folder))) return;
    const sweep::ChartState state = sweep::chart_state(study, folder);
    const std::size_t apart = state.done - std::min(state.done, state.chart.cells);
    if (apart > 0)
        throw Error(ErrorKind::input,
                    {fmt::format("{} cells of this chart are in shares that were not merged", apart),
                     "they would all be computed anew",
                     fmt::format("Join them first: stridor merge {}. Or choose another --out.", folder.string())});
}

void compute_share(const sweep::Study& study, const fs::path& folder, const std::string& text, int threads) {
    const sweep::Share share = share_named(text);
    keep_chart_file(study, folder);
    const fs::path file = sweep::share_file(folder, share);
    const Interrupt interrupt;
    sweep::ShareKeeper keeper(file, folder / "chart.sqlite", study, waiting(interrupt.token()));
    say_takeover(keeper.own());
    sweep::RunOptions options;
    options.crew = crews(threads);
    options.share = share;
    const sweep::RunReport report = fill(study, keeper, options, interrupt);
    if (report.ending == sweep::SweepEnding::stopped) throw stopped(report, file);
    console::print(
        fmt::format("share {} is done: {} cells computed into {}\n", text_of(share), report.computed, file.string()));
    console::print(fmt::format("once all {} are: stridor merge {}\n", share.count, folder.string()));
}

void print_slurm_script(const sweep::Study& study, const fs::path& folder, const SlurmOptions& options, int threads) {
    io::SlurmJob job;
    job.program = fs::read_symlink("/proc/self/exe").string();
    job.folder = fs::absolute(folder).lexically_normal().string();
    job.shares = options.shares;
    job.threads = std::max(threads, 1);
    job.time = options.time;
    const std::string script = io::slurm_script(job);
    keep_chart_file(study, folder);
    console::print_data(script);
}

void add_merge(CLI::App& program) {
    auto folder = std::make_shared<std::string>();
    CLI::App* command =
        program.add_subcommand("merge", "Merge the shares of a chart into its one store, and say what is missing.");
    command->add_option("folder", *folder, "folder of the chart: the --out of its shares")
        ->type_name("DIR")
        ->required();
    command->footer(
        "Exit code 0: complete, 4: cells are missing. The store is the same however many shares there were.\n"
        "Example:\n  stridor chart pair.toml --out pair --shard 0/2\n  stridor chart pair.toml --out pair --shard 1/2\n"
        "  stridor merge pair\n  stridor chart pair.toml --out pair");
    command->callback([folder] { merge_command(*folder); });
}

void add_chart_status(CLI::App& program) {
    auto options = std::make_shared<StatusOptions>();
    CLI::App* command = program.add_subcommand(
        "chart-status", "How far a chart is, and who computes which part of it; it may be asked at any time.");
    command->add_option("folder", options->folder, "folder of the chart: its --out")->type_name("DIR")->required();
    CLI::Option* json = add_json_option(*command, options->json, "stridor.chart-status/1");
    command
        ->add_option("--lacking", options->lacking,
                     "only the numbers of those of so many shares that lack cells, as sbatch's --array takes them: "
                     "0,3,7-9")
        ->type_name("SHARES")
        ->check(CLI::Range(std::size_t{1}, sweep::most_shares))
        ->excludes(json);
    command->footer("Examples:\n  stridor chart-status pair\n  stridor chart-status pair --lacking 16");
    command->callback([options] { chart_status(*options); });
}

}  // namespace stridor::app
