// Merging the stores of shares: cells per second. Cells are invented, since only their bytes count.
//
//     merge_benchmark [CELLS [SHARES [FOLDER]]]        1e6 cells, 16 shares, a folder of its own where nothing is named

#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/store/merge.hpp"
#include "stridor/sweep/store/share.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace stridor;
using Clock = std::chrono::steady_clock;

constexpr std::size_t cells_per_commit = 4096;

// of this process; the time by the clock says little beside other programs
double processor_time() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// figure 8's plane with about so many cells in both directions
sweep::Study study_of(std::size_t cells) {
    sweep::Study study = sweep::figure_8();
    study.refine = 0;
    study.x.points = study.y.points = static_cast<int>(std::lround(std::sqrt(static_cast<double>(cells) / 2.0)));
    return study;
}

// a done cell with figures that fill their eight bytes, as computed ones do
sweep::Cell invented(std::size_t index) {
    sweep::Cell cell;
    cell.status = sweep::Status::done;
    cell.category = static_cast<classification::Category>(1 + index / 977 % 3);
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        set_figure(cell, figure, std::sin(static_cast<double>(index * 31 + figure.place)));
    return cell;
}

void make_share(const sweep::Study& study, const std::filesystem::path& folder, const sweep::Share& share) {
    sweep::Store store(sweep::share_file(folder, share), study);
    std::vector<sweep::IndexedCell> batch;
    for (std::size_t index = 0; index < cell_count(study); ++index) {
        if (!is_in(share, study, index)) continue;
        batch.push_back({index, invented(index)});
        if (batch.size() < cells_per_commit) continue;
        store.write(batch);
        batch.clear();
    }
    store.write(batch);
}

}  // namespace

int main(int argc, char** argv) {
    // an option of the other benchmarks, which choose among themselves
    if (argc > 1 && argv[1][0] == '-') return 0;
    const std::size_t wanted = argc > 1 ? static_cast<std::size_t>(std::atof(argv[1])) : 1'000'000;
    const std::size_t shares = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 16;
    const std::filesystem::path folder =
        argc > 3 ? std::filesystem::path(argv[3])
                 : std::filesystem::temp_directory_path() / ("stridor-merge-benchmark-" + std::to_string(getpid()));
    const sweep::Study study = study_of(wanted);
    std::filesystem::create_directories(sweep::shares_folder(folder));
    const auto begun = Clock::now();
    for (std::size_t index = 0; index < shares; ++index)
        make_share(study, folder, {index, shares});
    const std::size_t cells = cell_count(study);
    fmt::print("{} cells in {} shares, made in {:.1f} s\n", cells, shares, seconds_since(begun));
    const auto merging = Clock::now();
    const double used = processor_time();
    const sweep::MergeReport report = sweep::merge(study, folder);
    const double time = seconds_since(merging);
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    fmt::print(
        "merged in {:.1f} s ({:.1f} s of a processor): {:.0f} cells/s, {:.0f} MB on the disk, at most {} MB of "
        "memory\n",
        time, processor_time() - used, static_cast<double>(report.cells) / time,
        static_cast<double>(std::filesystem::file_size(folder / "chart.sqlite")) / 1e6, use.ru_maxrss / 1024);
    std::filesystem::remove_all(folder);
    return report.missing.empty() ? 0 : 1;
}
