// Sweeps: cells per second over threads, and the memory of a sweep over the simulated time.

#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>

namespace stridor {
namespace {

// Figure 8's pair with fewer cells and a given simulated time
sweep::Study small_pair(double duration) {
    sweep::Study study = sweep::figure_8();
    study.x.points = study.y.points = 8;
    study.base.run.duration = duration;
    study.base.run.window = 0.5 * duration;
    return study;
}

void run_once(const sweep::Study& study, int threads) {
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("stridor-sweep-benchmark-" + std::to_string(getpid()) + ".sqlite");
    std::filesystem::remove(file);
    {
        sweep::Store store(file, study);
        sweep::RunOptions options;
        options.crew = crew::thread_crews(threads);
        sweep::run(study, store, options);
    }
    std::filesystem::remove(file);
}

void sweep_cells(benchmark::State& state) {
    const sweep::Study study = small_pair(0.1);
    for ([[maybe_unused]] const auto run : state)
        run_once(study, static_cast<int>(state.range(0)));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sweep::cell_count(study)));
}
BENCHMARK(sweep_cells)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

// Figure 8's pair as it stands in the paper's axes, without its drawing: so many points along each axis,
// so many levels of refinement
void sweep_pair(benchmark::State& state) {
    sweep::Study study = sweep::figure_8();
    study.x.points = study.y.points = static_cast<int>(state.range(0));
    study.refine = static_cast<int>(state.range(1));
    for ([[maybe_unused]] const auto run : state)
        run_once(study, 0);
    state.counters["cells"] = static_cast<double>(sweep::cell_count(study));
}
BENCHMARK(sweep_pair)
    ->ArgNames({"points", "refine"})
    ->Args({64, 0})
    ->Args({64, 3})
    ->Args({200, 0})
    ->Args({200, 3})
    ->Args({200, 4})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

// a quick look at it, drawing left out
void sweep_preview(benchmark::State& state) {
    sweep::Study study = sweep::figure_8();
    study.x.points = study.y.points = 64;
    for ([[maybe_unused]] const auto run : state)
        run_once(sweep::preview(study), 0);
}
BENCHMARK(sweep_preview)->UseRealTime()->Unit(benchmark::kMillisecond);

// resident memory may grow with the cells, never with the simulated time: ten times the time, the same peak
void sweep_memory(benchmark::State& state) {
    const sweep::Study study = small_pair(1e-3 * static_cast<double>(state.range(0)));
    for ([[maybe_unused]] const auto run : state)
        run_once(study, 0);
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    state.counters["peak_resident_kB"] = static_cast<double>(usage.ru_maxrss);
}
BENCHMARK(sweep_memory)
    ->ArgName("simulated_ms")
    ->Arg(50)
    ->Arg(500)
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stridor
