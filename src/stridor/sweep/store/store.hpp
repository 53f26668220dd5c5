#pragma once

#include "stridor/storage/database.hpp"
#include "stridor/storage/new_file.hpp"
#include "stridor/storage/owner_file.hpp"
#include "stridor/sweep/store/keeper.hpp"
#include "stridor/sweep/store/store_layout.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace stridor::sweep {

/// The use for which a store is opened.
///
/// `fill`: it is made if it does not exist, and belongs to this process alone while it is open. `read`: it must exist;
/// no process may fill it meanwhile, but others may read it, too.
enum class StoreUse { fill, read };

/// The finished cells of one study in one SQLite file, from the first cell on: the sweep's only memory.
///
/// Tables: meta(key, value) with the study's canonical text, the results version, and program and commit for
/// information; cell(id, status, category, quiet_because, message, starts, a column per `cell_figures`). id is the
/// cell's index, category is NULL unless done, quiet_because is NULL unless the category is none, starts holds the
/// verdicts of its starts as words, a figure is NULL if it is NaN. Only computed cells are in it, never inferred ones.
/// `PRAGMA application_id` and `user_version` say what the file is.
///
/// Cells are read as they were written, or an `Error` (io) says that the store is damaged: each page has a checksum.
///
/// The file belongs to one process while it is filled, and survives the death of that process at any moment. Meanwhile
/// a file beside it names the owner (`OwnerFile`) for other machines. A store whose owner may only stand still is taken
/// over as a copy (`hand_over`). To read such a store, it is opened as it is, or from a copy if a change is open.
class Store final : public CellKeeper {
public:
    /// Opens the store of this study, or makes it.
    ///
    /// Throws `Error`: input if the file is something else or another study's (the first difference is named), io if
    /// another process fills it or the file cannot be read or written, interrupted if a wait for another process is
    /// ended.
    Store(const std::filesystem::path& file, const Study& study, StoreUse use = StoreUse::fill,
          const storage::WaitOptions& wait = {});

    ~Store() override;
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Returns the dead or silent owner whose work was taken over, or `std::nullopt` if there was none.
    const std::optional<storage::SeenOwner>& replaced() const { return replaced_; }

    /// Says whether the store was taken over as a copy, from an owner that may go on with the file it has open.
    bool was_handed_over() const { return was_handed_over_; }

    /// Returns its path.
    const std::filesystem::path& file() const { return file_; }

    std::string name() const override { return "the store " + file().string(); }

    std::vector<bool> stored() override;

    Counts counts() override;

    /// Keeps cells, all or none, on disk when it returns. Throws `Error` (io) if that fails; the store stays good.
    void write(std::span<const IndexedCell> cells) override;

    /// Shows cells. Throws `Error` (io) at a row that no sweep wrote, or that is out of order.
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

    /// Shows cells with these figures only. Throws `Error` (io) at a row that no sweep wrote, or that is out of order.
    void visit_figures(std::size_t first, std::size_t last, std::span<const CellFigure> figures,
                       const std::function<void(IndexedCell&)>& use) override;

    /// Returns the cells from an index on as they stand, in index order: rows of `cell_columns`, to be copied. The
    /// statement must end before the store.
    storage::Statement rows(std::int64_t from = std::numeric_limits<std::int64_t>::min());

    /// Returns all cells that are there, in index order.
    std::vector<IndexedCell> read();

private:
    storage::Database opened(const storage::WaitOptions& wait);

    std::filesystem::path file_;
    StoreUse use_;
    std::optional<storage::PrivateFolder> private_;  // with a copy that is read
    std::unique_ptr<storage::OwnerFile> owner_;      // null if it is only read
    std::optional<storage::SeenOwner> replaced_;
    bool was_handed_over_ = false;
    storage::Database database_;
    bool is_blank_ = false;  // only read, and its first owner died before it had tables
    std::size_t cells_ = 0;  // [1] of the study
    std::size_t known_ = 0;  // [1] of them that are there, once somebody asked
};

}  // namespace stridor::sweep
