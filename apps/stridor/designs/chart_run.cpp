#include "designs/chart_run.hpp"

#include "crews.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"

#include <fmt/format.h>

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

}  // namespace stridor::app
