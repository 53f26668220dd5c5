// What one writer keeps up with: a sweep whose cells cost nothing, so that its time is that of the store, of
// refinement and of handing over.
//
//     writer_benchmark [CELLS [REFINE [FOLDER]]]       1e6 cells, refine 0, a folder of its own where nothing is named

#include "stridor/sweep/ready_charts.hpp"
#include "stridor/sweep/run.hpp"
#include "stridor/sweep/store/store.hpp"
#include "stridor/sweep/study_work.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace stridor;
using Clock = std::chrono::steady_clock;

double processor_time() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return static_cast<double>(use.ru_utime.tv_sec + use.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(use.ru_utime.tv_usec + use.ru_stime.tv_usec);
}

// a done cell with figures that fill their eight bytes; areas with long curved boundaries
sweep::Cell invented(const sweep::Study& study, std::size_t index) {
    const sweep::CellPlace place = sweep::place_of(study, index);
    const double x = place.ix / static_cast<double>(study.x.points);
    const double y = place.iy / static_cast<double>(study.y.points);
    const double wave = std::sin(40.0 * x) * std::sin(40.0 * y + static_cast<double>(place.direction));
    sweep::Cell cell;
    cell.status = sweep::Status::done;
    cell.category = wave > 0.2 ? classification::Category::squeal : classification::Category::creak;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        set_figure(cell, figure, wave + static_cast<double>(index + figure.place));
    // no flutter: its boundary would be another
    set_figure(cell, sweep::cell_figure("growth_rate"), -1.0);
    return cell;
}

// has computed what it is given at once
class InventingCrew final : public crew::Crew {
public:
    InventingCrew(const sweep::Study& study, std::stop_token stop) : study_(study), stop_(std::move(stop)) {}

    std::size_t appetite(std::size_t left) override { return std::min<std::size_t>(left, 4096); }
    void give(std::vector<crew::Task> tasks) override {
        const std::size_t stride = sweep::cell_count(study_) / study_.directions.size();
        for (const crew::Task& task : tasks) {
            std::vector<sweep::Cell> cells;
            for (std::size_t k = 0; k < sweep::directions_per_run(study_); ++k)
                cells.push_back(invented(study_, task.number + k * stride));
            arrived_.push_back({task.number, sweep::packed(cells)});
        }
    }
    std::vector<crew::Result> take(std::size_t, Clock::time_point) override { return std::exchange(arrived_, {}); }
    bool is_idle() override { return arrived_.empty(); }
    bool has_stopped() override { return stop_.stop_requested(); }
    void rethrow() override {}
    double seconds_per_task() override { return 0.0; }

private:
    const sweep::Study& study_;
    std::stop_token stop_;
    std::vector<crew::Result> arrived_;
};

}  // namespace

int main(int argc, char** argv) {
    // an option of the other benchmarks, which choose among themselves
    if (argc > 1 && argv[1][0] == '-') return 0;
    const double wanted = argc > 1 ? std::atof(argv[1]) : 1e6;
    sweep::Study study = sweep::figure_8();
    study.refine = argc > 2 ? std::atoi(argv[2]) : 0;
    study.x.points = study.y.points = static_cast<int>(std::lround(std::sqrt(wanted / 2.0)));
    const std::filesystem::path folder =
        argc > 3 ? std::filesystem::path(argv[3])
                 : std::filesystem::temp_directory_path() / ("stridor-writer-benchmark-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    std::size_t computed = 0;
    const auto begun = Clock::now();
    const double used = processor_time();
    {
        sweep::Store store(folder / "chart.sqlite", study);
        sweep::RunOptions options;
        options.crew = [&](const crew::Work&, const std::stop_token& stop) {
            return std::make_unique<InventingCrew>(study, stop);
        };
        computed = sweep::run(study, store, options).computed;
    }
    const double time = std::chrono::duration<double>(Clock::now() - begun).count();
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    fmt::print(
        "{} cells, {} of them computed, in {:.1f} s ({:.1f} s of a processor): {:.0f} cells/s, {:.0f} of a processor, "
        "{:.0f} MB on the disk, at most {} MB of memory\n",
        sweep::cell_count(study), computed, time, processor_time() - used, static_cast<double>(computed) / time,
        static_cast<double>(computed) / (processor_time() - used),
        static_cast<double>(std::filesystem::file_size(folder / "chart.sqlite")) / 1e6, use.ru_maxrss / 1024);
    std::filesystem::remove_all(folder);
}
