#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/store.hpp"
#include "stridor/sweep/study.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <bit>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

/// What the tests of sweeps share: a study of milliseconds, a folder, a disk that is full.
namespace stridor::sweep {

/// 4 by 3 points in two directions, 20 ms each; preloads from 2 to 400 N meet several categories.
inline Study small_study() {
    Study study;
    study.base.drive.kind = parameters::DriveKind::constant;
    study.base.drive.velocity = 0.1;
    study.base.run.duration = 0.02;
    study.base.run.window = 0.01;
    study.x = {"contact.preload", 2.0, 400.0, 4, Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.1, 0.8, 3, Scale::linear};
    return study;
}

/// The same numbers to the last bit, NaN equal to NaN.
inline bool same_bits(double a, double b) {
    const bool both_nan = a != a && b != b;
    return both_nan || std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same_cell(const Cell& a, const Cell& b) {
    const bool same_words = a.status == b.status && a.message == b.message;
    const bool same_category = a.status != Status::done || a.category == b.category;
    const bool same_starts = a.starts == b.starts && a.agreement == b.agreement;
    return same_words && same_category && same_starts &&
           std::all_of(cell_figures().begin(), cell_figures().end(),
                       [&](const CellFigure& figure) { return same_bits(a.*figure.member, b.*figure.member); });
}

inline bool same_cells(const std::vector<Cell>& a, const std::vector<Cell>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_cell);
}

/// The finished sweep of a store that lives longer than it.
inline SweepResult load(const Study& study, Store& store) {
    return load(study, std::shared_ptr<Store>(std::shared_ptr<void>(), &store));
}

/// All cells of a sweep; those that were inferred have their verdict only.
inline std::vector<Cell> all_cells(const SweepResult& result) {
    std::vector<Cell> cells(result.cells.size());
    for (std::size_t index = 0; index < cells.size(); ++index) {
        cells[index].status = result.cells[index].status;
        cells[index].category = result.cells[index].category;
        cells[index].agreement = result.cells[index].agreement;
    }
    result.computed->visit(0, cells.size(), [&](IndexedCell& computed) { cells[computed.index] = computed.cell; });
    return cells;
}

/// A folder of its own, gone with it; in memory where the system has such a place, since a store waits for the disk at
/// each commit.
class ScratchFolder {
public:
    ScratchFolder() {
        const std::filesystem::path memory = "/dev/shm";
        const std::filesystem::path parent =
            std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
        std::string pattern = (parent / "stridor-sweep-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = pattern;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    /// Number of files in it.
    long files() const {
        return std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator());
    }

private:
    std::filesystem::path path_;
};

/// While it lives no file of this process can grow beyond a size, as on a full disk.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace stridor::sweep
