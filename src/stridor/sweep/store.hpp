#pragma once

#include "stridor/storage/database.hpp"
#include "stridor/sweep/keeper.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace stridor::sweep {

/// Layout of a store. Raise it when a table, a column or the meaning of one changes: older stores are then refused.
inline constexpr int store_schema = 3;

/// What a store's header says: "STRD", where other programs look for the kind of a database; pages have checksums from
/// layout 3 on.
inline constexpr storage::Identity store_identity{0x53545244, 3};

/// Generation of the numbers. Raise it with every change that moves a result (the changelog's "Results changed"): a
/// store begun before is then refused, for its cells and new ones would not fit together.
inline constexpr int results_version = 7;

/// The finished cells of one study in one SQLite file, from the first cell on: the sweep's only memory.
///
/// Tables: meta(key, value) with the study's canonical text, the results version, and program and commit for
/// information; cell(id, status, category, quiet_because, message, starts, a column per `cell_figures`), id being the
/// cell's index, category NULL unless done, quiet_because NULL unless that is none, starts the verdicts of its starts
/// as words, a figure NULL where it is NaN. Only computed cells are in it, never inferred ones. `PRAGMA
/// application_id`
/// and `user_version` say what the file is.
///
/// What is read is what was written, or an `Error` (io) says that the store is damaged: each page has a checksum.
///
/// The file belongs to one process while a store is open, and survives the death of that process at any moment.
class Store final : public CellKeeper {
public:
    /// Opens the store of this study, or makes it.
    ///
    /// Throws `Error`: input if the file is something else or another study's (the first difference is named), io if
    /// another process has it open or the file cannot be read or written.
    Store(const std::filesystem::path& file, const Study& study);

    /// Where it stands.
    const std::filesystem::path& file() const { return database_.file(); }

    std::string name() const override { return "the store " + file().string(); }

    std::vector<bool> stored() override;

    Counts counts() override;

    /// Keeps cells, all or none, on disk when it returns. Throws `Error` (io) if that fails; the store stays good.
    void write(std::span<const IndexedCell> cells) override;

    /// Throws `Error` (io) at a row that no sweep wrote, or out of order.
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

    /// All cells that are there, in index order.
    std::vector<IndexedCell> read();

private:
    void create();
    void verify();
    std::string meta(std::string_view key);

    storage::Database database_;
    std::string study_text_;
    std::size_t cells_ = 0;  // [1] of the study
};

}  // namespace stridor::sweep
