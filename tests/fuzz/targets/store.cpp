#include "stridor/sweep/store/store.hpp"

#include "fuzz/targets/damaged_file.hpp"
#include "fuzz/targets/targets.hpp"
#include "stridor/base/error.hpp"

#include <bit>
#include <string>

namespace stridor::fuzz {

namespace {

using sweep::Cell;
using sweep::IndexedCell;

sweep::Study small_chart() {
    sweep::Study study;
    study.base.drive.kind = parameters::DriveKind::constant;
    study.x = {"contact.preload", 2.0, 400.0, 3, sweep::Scale::logarithmic};
    study.y = {"contact.kinetic_friction", 0.1, 0.8, 3, sweep::Scale::linear};
    return study;
}

std::string told_by(sweep::Store& store, const sweep::Study& study) {
    std::string text;
    for (const bool is_there : store.stored())
        text += is_there ? '1' : '0';
    for (const std::size_t count : store.counts().statuses)
        text += " " + std::to_string(count);
    std::size_t next = 0;
    for (const IndexedCell& indexed : store.read()) {
        require(indexed.index >= next && indexed.index < sweep::cell_count(study));
        next = indexed.index + 1;
        text += "\n" + std::to_string(indexed.index) + indexed.cell.message;
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            text += " " + std::to_string(std::bit_cast<std::uint64_t>(figure_of(indexed.cell, figure)));
    }
    return text;
}

/// A sound store, and where its damaged copies are opened.
struct StoreBench {
    support::ScratchFolder folder{};
    std::filesystem::path file = folder / "chart.sqlite";
    sweep::Study study = small_chart();
    std::string sound{};
    std::string told{};

    StoreBench() {
        std::vector<IndexedCell> cells;
        for (std::size_t index = 0; index < sweep::cell_count(study); ++index) {
            Cell cell;
            cell.status = sweep::Status::done;
            cell.category = classification::Category::squeal;
            double value = 1.0 / static_cast<double>(index + 3);
            for (const sweep::CellFigure& figure : sweep::cell_figures())
                set_figure(cell, figure, value *= 1.7);
            cells.push_back({index, cell});
        }
        sweep::Store(file, study).write(cells);
        sound = file_bytes(file);
        sweep::Store store(file, study);
        told = told_by(store, study);
    }
};

}  // namespace

void store(std::string_view bytes) {
    static const StoreBench bench;
    const Damage damage = damaged(bench.sound, bytes);
    put_database(bench.file, damage.bytes);
    // SQLite takes a file of one byte for an empty one, too
    const bool may_differ = damage.is_mended || damage.bytes.size() <= 1;
    try {
        sweep::Store opened(bench.file, bench.study);
        require(told_by(opened, bench.study) == bench.told || may_differ);
        // what was opened can be written
        opened.write(std::vector<IndexedCell>{{3, Cell{}}});
    } catch (const Error& error) {
        require(error.kind() == ErrorKind::input || error.kind() == ErrorKind::io);
    }
}

}  // namespace stridor::fuzz
