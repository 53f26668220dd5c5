// The noise library with 10,000 entries of 20 figures each: open, list, filter, search.

#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/library.hpp"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

namespace stridor::noise_library {
namespace {

constexpr int entry_count = 10000;

Entry entry_of(int number) {
    const char* const systems[] = {"brake", "wiper", "sunroof", "seat", "dashboard", "door hinge", "latch", "seal"};
    const char* const categories[] = {"none", "squeal", "squeak", "creak"};
    Entry entry;
    entry.system = systems[number % 8];
    entry.parts = "part " + std::to_string(number) + " on its counterpart";
    entry.materials = number % 3 == 0 ? "EPDM, glass" : "PVC, painted steel";
    entry.operation = "driven over rough road, third gear";
    entry.recorded = number % 5 == 0 ? "rig" : "vehicle";
    entry.category = categories[number % 4];
    entry.preload = 1.0 + number % 200;
    entry.velocity = 0.001 * (number % 17);
    entry.notes = std::string(400, 'n') + std::to_string(number);
    entry.verdict = "{\"category\": \"squeal\", \"text\": \"" + std::string(3000, 'v') + "\"}";
    entry.file = "recording-" + std::to_string(number) + ".wav";
    entry.audio = std::string(64, 'a');
    entry.format = "wav";
    for (int k = 0; k < 20; ++k)
        set_figure(entry, {"figure_" + std::to_string(k), "dB", 0.37 * ((number * (k + 1)) % 1000)});
    return entry;
}

/// The library, made once.
class Filled {
public:
    Filled() : folder_(std::filesystem::temp_directory_path() / ("stridor-library-" + std::to_string(getpid()))) {
        std::filesystem::create_directory(folder_);
        std::vector<Entry> entries;
        for (int k = 0; k < entry_count; ++k)
            entries.push_back(entry_of(k));
        Library library(file(), {Access::fill});
        Intake intake(library.audio_folder());
        bool is_done = false;
        std::vector<Staged> staged;
        staged.push_back(intake.stage("wav", [&] { return std::exchange(is_done, true) ? "" : "sound"; }));
        library.add(intake, staged, entries, Twins::accept);
    }
    ~Filled() { std::filesystem::remove_all(folder_); }
    Filled(const Filled&) = delete;
    Filled& operator=(const Filled&) = delete;

    std::filesystem::path file() const { return folder_ / "library.sqlite"; }

private:
    std::filesystem::path folder_;
};

void find(benchmark::State& state, const Query& query) {
    static const Filled filled;
    std::size_t found = 0;
    for ([[maybe_unused]] const auto run : state)
        found = Library(filled.file()).find(query).size();
    state.counters["found"] = static_cast<double>(found);
}

Query where(const char* conditions, Extent extent = Extent::summary) {
    Query query;
    query.conditions = parse_conditions(conditions);
    query.extent = extent;
    return query;
}

void list_all(benchmark::State& state) {
    find(state, {});
}
void filter(benchmark::State& state) {
    find(state, where("preload > 150 N and system = brake"));
}
void filter_by_figure(benchmark::State& state) {
    find(state, where("figure_7 > 360 dB"));
}
void search(benchmark::State& state) {
    Query query;
    query.words = {"EPDM", "part", "99"};
    find(state, query);
}
void sort_by_figure(benchmark::State& state) {
    Query query;
    query.sort = "figure_3";
    find(state, query);
}
void read_all_whole(benchmark::State& state) {
    Query query;
    query.extent = Extent::whole;
    find(state, query);
}
BENCHMARK(list_all)->Unit(benchmark::kMillisecond);
BENCHMARK(filter)->Unit(benchmark::kMillisecond);
BENCHMARK(filter_by_figure)->Unit(benchmark::kMillisecond);
BENCHMARK(search)->Unit(benchmark::kMillisecond);
BENCHMARK(sort_by_figure)->Unit(benchmark::kMillisecond);
BENCHMARK(read_all_whole)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stridor::noise_library
