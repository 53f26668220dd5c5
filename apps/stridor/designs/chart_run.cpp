#include "designs/chart_run.hpp"

#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"

#include <fmt/format.h>

namespace stridor::app {

sweep::RunReport fill(const sweep::Study& study, sweep::CellKeeper& keeper, sweep::RunOptions options) {
    const Interrupt interrupt;
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
    const auto store = std::make_shared<sweep::Store>(store_file, study);
    say_takeover(*store);
    sweep::RunOptions options;
    options.crew = crews(threads);
    const sweep::RunReport report = fill(study, *store, options);
    if (report.ending == sweep::SweepEnding::stopped) throw stopped(report, store_file);
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
