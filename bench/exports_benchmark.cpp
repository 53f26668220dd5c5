// What the exports of a large chart cost: rates, sizes and memory, of a chart whose cells are invented.
// Prints a table: `build-bench/benchmarks/exports_benchmark [FOLDER CELLS [kept|invented]]`, by itself of 1e5 cells.
// "kept" writes a store first and exports from it; "invented" makes each cell when it is looked at, for more cells than
// there is room for.

#include "stridor/io/chart/chart_exports.hpp"
#include "stridor/pictures/picture_files.hpp"
#include "stridor/sweep/store/store.hpp"
#include "support/scratch_folder.hpp"
#include "unit/io/invented_chart.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <string>

namespace stridor {
namespace {

namespace fs = std::filesystem;

// the most memory that this process had since it was forgotten [bytes]
double peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024.0;
    return 0.0;
}

void forget_peak() {
    std::ofstream("/proc/self/clear_refs") << "5";
}

// that of the largest process it waited for [bytes]
double peak_of_others() {
    rusage usage{};
    ::getrusage(RUSAGE_CHILDREN, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024.0;
}

// of this process and of those it waited for [s]
double processor_time() {
    double time = 0.0;
    for (const auto whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        ::getrusage(whose, &usage);
        for (const timeval& part : {usage.ru_utime, usage.ru_stime})
            time += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
    }
    return time;
}

double size_of(const fs::path& path) {
    if (!fs::is_directory(path)) return fs::exists(path) ? static_cast<double>(fs::file_size(path)) : 0.0;
    double size = 0.0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file()) size += static_cast<double>(entry.file_size());
    return size;
}

/// Does something to all cells and prints what it took.
template <typename Work>
void measure(const std::string& what, const fs::path& file, std::size_t cells, Work work) {
    forget_peak();
    const double begin = processor_time();
    work();
    const double time = processor_time() - begin;
    fmt::print("| {} | {:.1f} | {:.2g} | {:.0f} | {:.0f} | {:.0f} |\n", what, time, static_cast<double>(cells) / time,
               size_of(file) / 1e6, peak_memory() / 1e6, peak_of_others() / 1e6);
    std::fflush(stdout);
}

void keep(sweep::Store& store, const sweep::Study& study) {
    constexpr std::size_t at_once = 4096;  // cells of a commit
    std::vector<sweep::IndexedCell> cells;
    for (std::size_t index = 0; index < sweep::cell_count(study); ++index) {
        cells.push_back({index, io::invented_cell(study, index)});
        if (cells.size() < at_once && index + 1 < sweep::cell_count(study)) continue;
        store.write(cells);
        cells.clear();
    }
}

void run(const fs::path& folder, std::size_t wanted, const std::string& source) {
    const int points = static_cast<int>(std::sqrt(static_cast<double>(wanted) / 2.0));
    sweep::Study study = io::invented_study(points, points);
    study.quantities = {"category", "frequency"};
    const std::size_t cells = sweep::cell_count(study);
    fs::create_directories(folder);
    fmt::print("{} cells, {} by {} in two directions, {}\n\n", cells, points, points, source);
    fmt::print("| what | processor time [s] | cells/s | size [MB] | memory [MB] | of the writing process [MB] |\n");
    fmt::print("| --- | --- | --- | --- | --- | --- |\n");
    sweep::SweepResult result{study, {}};
    const fs::path file = folder / "chart.sqlite";
    if (source == "kept") {
        const auto store = std::make_shared<sweep::Store>(file, study);
        measure("store, written", file, cells, [&] { keep(*store, study); });
        result.computed = store;
    } else {
        result.computed = std::make_shared<io::InventedCells>(study);
    }
    measure("verdicts, read", file, cells, [&] {
        result.cells.resize(cells);
        result.computed->visit_figures(
            0, cells, {}, [&](const sweep::IndexedCell& cell) { result.cells[cell.index] = verdict_of(cell.cell); });
    });
    const auto tables = [&](const std::string& what, const std::string& name, const io::ExportTexts& texts) {
        measure(what, folder / name, cells,
                [&] { io::write_chart_tables(result, folder, io::chart_exports(study, texts)); });
    };
    tables("boundaries.csv", "boundaries.csv", {{"boundaries"}, {}});
    tables("chart.nc, one figure", "chart.nc", {{"nc"}, {}});
    tables(fmt::format("chart.nc, {} figures", sweep::cell_figures().size()), "chart.nc", {{"nc"}, {"all"}});
    tables("chart.zarr, one figure", "chart.zarr", {{"zarr"}, {}});
    if (cells <= 20 * io::many_cells) tables("chart.csv, all figures", "chart.csv", {{"csv"}, {"all"}});
    measure("pictures, .png", folder / "chart.png", cells,
            [&] { pictures::draw_charts(result, folder, std::vector<std::string>{".png"}); });
}

}  // namespace
}  // namespace stridor

int main(int argc, char** argv) {
    try {
        // among all benchmarks: options of Google Benchmark are none of its own
        const bool is_small = argc < 3 || std::string(argv[1]).starts_with("--");
        if (is_small) {
            const stridor::support::ScratchFolder scratch(stridor::support::Medium::disk);
            stridor::run(scratch.path(), 100'000, "kept");
        } else {
            stridor::run(argv[1], static_cast<std::size_t>(std::stod(argv[2])), argc > 3 ? argv[3] : "kept");
        }
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "error: {}\n", error.what());
        return 1;
    }
}
