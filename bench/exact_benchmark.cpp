// Speed of the exact engine: a second of each case of Table 1 at a constant velocity,
// by instruction set, and the set-up.

#include "stridor/integration/simulate.hpp"
#include "stridor/model/built/rubbing_system.hpp"
#include "stridor/parameters/paper_cases.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>

namespace stridor {
namespace {

using integration::InstructionSet;
using parameters::Case;
using parameters::PaperCase;

constexpr std::array<const char*, 3> set_names{"baseline", "AVX2", "AVX-512"};

// one simulated second, the drive of the measure: +-0.1 m/s
Case constant_case(std::int64_t which, double velocity, parameters::EarlyEnding early) {
    Case c = parameters::paper_case(static_cast<PaperCase>(which));
    c.drive.kind = parameters::DriveKind::constant;
    c.drive.velocity = velocity;
    c.run.early_ending = early;
    return c;
}

void simulate_all(benchmark::State& state, parameters::EarlyEnding early) {
    integration::Workspace workspace;
    workspace.instruction_set = static_cast<InstructionSet>(state.range(0));
    if (!integration::is_available(workspace.instruction_set)) return state.SkipWithError("not on this machine");
    for ([[maybe_unused]] const auto run : state)
        for (std::int64_t which = 0; which < 4; ++which)
            for (const double velocity : {0.1, -0.1})
                benchmark::DoNotOptimize(
                    integration::simulate(constant_case(which, velocity, early), {}, {}, workspace));
    state.counters["ms_per_simulated_second"] =
        benchmark::Counter(8.0 * 1e-3 * static_cast<double>(state.iterations()),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
    state.SetLabel(set_names[static_cast<std::size_t>(state.range(0))]);
}

// mean over the four cases, both directions, simulated to the end
void exact_table_1(benchmark::State& state) {
    simulate_all(state, parameters::EarlyEnding::never);
}
BENCHMARK(exact_table_1)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

void exact_table_1_early_endings(benchmark::State& state) {
    simulate_all(state, parameters::EarlyEnding::proven);
}
BENCHMARK(exact_table_1_early_endings)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

// each case by itself: 0 squeal, 1 squeak, 2 creak, 3 quiet; going and coming
void exact_case(benchmark::State& state) {
    const Case c = constant_case(state.range(0), state.range(1) > 0 ? 0.1 : -0.1, parameters::EarlyEnding::never);
    integration::Workspace workspace;
    for ([[maybe_unused]] const auto run : state)
        benchmark::DoNotOptimize(integration::simulate(c, {}, {}, workspace));
    state.SetLabel(std::string(parameters::paper_case_names[static_cast<std::size_t>(state.range(0))]) +
                   (state.range(1) > 0 ? " going" : " coming"));
}
BENCHMARK(exact_case)->ArgsProduct({{0, 1, 2, 3}, {1, 0}})->Unit(benchmark::kMicrosecond);

// what a structure costs before its first run; runs of the same structure share it
void exact_set_up(benchmark::State& state) {
    const auto structure = model::rubbing_system(Case{});
    const auto coordinates = integration::contact_coordinates(structure);
    const integration::Kernel& loops = integration::kernel(static_cast<InstructionSet>(state.range(0)), 3);
    for ([[maybe_unused]] const auto run : state)
        benchmark::DoNotOptimize(integration::prepare_flows(coordinates, structure.friction, 0.0, loops));
    state.SetLabel(set_names[static_cast<std::size_t>(state.range(0))]);
}
BENCHMARK(exact_set_up)
    ->DenseRange(0, static_cast<int>(integration::widest_instruction_set()))
    ->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace stridor
