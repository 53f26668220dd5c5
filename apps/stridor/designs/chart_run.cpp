#include "designs/chart_run.hpp"

#include "crews.hpp"
#include "interrupt.hpp"
#include "stridor/console/progress.hpp"
#include "stridor/console/terminal.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store.hpp"

#include <fmt/format.h>

namespace stridor::app {

sweep::SweepResult compute(const sweep::Study& study, const std::filesystem::path& store_file, int threads) {
    const auto store = std::make_shared<sweep::Store>(store_file, study);
    const Interrupt interrupt;
    console::ProgressDisplay display;
    sweep::RunOptions options;
    options.crew = crews(threads);
    options.stop = interrupt.token();
    options.progress = [&](const sweep::Progress& progress) { display.show(progress); };
    const sweep::RunReport report = sweep::run(study, *store, options);
    display.finish();
    if (report.ending == sweep::SweepEnding::stopped)
        throw Error(ErrorKind::interrupted,
                    {fmt::format("stopped with {} of {} cells done", report.progress.done, report.progress.total),
                     "all of them are kept in " + store_file.string(), "Run the same command again to go on."});
    return sweep::load(study, store);
}

std::vector<sweep::DiagramCell> compute_diagram(const sweep::SweepResult& result, const std::filesystem::path& file,
                                                int threads) {
    storage::KeptResults kept(file, sweep::diagram_text(result.study), "diagram");
    const Interrupt interrupt;
    console::ShareDisplay display("diagram:", console::TimeLeft::shown);
    sweep::DiagramOptions options;
    options.threads = threads;
    options.stop = interrupt.token();
    options.kept = &kept;
    if (kept.found() < result.cells.size()) options.progress = [&](double share) { display.show(share); };
    return sweep::diagram(result, options);
}

}  // namespace stridor::app
