// Speed of the beta_2 engine, items being time steps, and what a run leaves in memory.

#include "stridor/integration/cost.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace stridor {
namespace {

using parameters::Case;
using parameters::PaperCase;

// a column of Table 1 over whole periods of its drive
Case table_1(std::int64_t which, double duration, double step) {
    Case c = parameters::paper_case(static_cast<PaperCase>(which));
    c.run.duration = c.run.window = duration;
    c.run.step = step;
    return c;
}

std::int64_t steps(const Case& c) {
    return static_cast<std::int64_t>(integration::cost(c).steps);
}

void name_case(benchmark::State& state) {
    state.SetLabel(std::string(parameters::paper_case_names[static_cast<std::size_t>(state.range(0))]));
}

// two periods of the drive at the step of Table 1: four million steps
void beta_2_steps(benchmark::State& state) {
    const Case c = table_1(state.range(0), 0.4, 1e-7);
    for ([[maybe_unused]] const auto run : state)
        benchmark::DoNotOptimize(integration::simulate(c));
    state.SetItemsProcessed(state.iterations() * steps(c));
    name_case(state);
}
BENCHMARK(beta_2_steps)->DenseRange(0, 3)->Unit(benchmark::kMillisecond);

// independent runs share nothing: two threads should take twice the steps per second of one
void beta_2_steps_in_threads(benchmark::State& state) {
    const Case c = table_1(0, 0.4, 1e-7);
    for ([[maybe_unused]] const auto run : state)
        benchmark::DoNotOptimize(integration::simulate(c));
    state.SetItemsProcessed(state.iterations() * steps(c));
}
BENCHMARK(beta_2_steps_in_threads)->Threads(1)->Threads(2)->UseRealTime()->Unit(benchmark::kMillisecond);

// [bytes] tallies on the heap and in the record; history and trace were not asked for
std::size_t size_of(const record::Record& record) {
    std::size_t bytes = sizeof(record) + record.phases.capacity() * sizeof(record::Tally);
    for (const record::Tally& tally : record.phases) {
        bytes += tally.vibration.capacity() * sizeof(record::Vibration);
        for (const record::Instants& instants : tally.contacts.front().changes)
            bytes += instants.times.capacity() * sizeof(double);
    }
    return bytes;
}

// The counter `record_bytes` grows with the simulated time only until the kept instants of changes are full: at most
// two phases of nine kinds of 8192 instants, 1.2 MB, however long the run.
void beta_2_record_size(benchmark::State& state) {
    const auto duration = static_cast<double>(state.range(1));
    const Case c = table_1(state.range(0), duration, 1e-6);
    std::size_t bytes = 0;
    for ([[maybe_unused]] const auto run : state)
        bytes = size_of(integration::simulate(c).record);
    state.SetItemsProcessed(state.iterations() * steps(c));
    state.counters["record_bytes"] = static_cast<double>(bytes);
    name_case(state);
}
BENCHMARK(beta_2_record_size)
    ->ArgsProduct({{static_cast<std::int64_t>(PaperCase::squeak)}, {1, 10, 100}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

}  // namespace
}  // namespace stridor
