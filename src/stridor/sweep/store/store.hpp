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

/// What a store is opened for.
///
/// `fill`: it is made if it is not there, and belongs to this process alone while it is open. `read`: it must be there;
/// nobody may fill it meanwhile, and others may read it, too.
enum class StoreUse { fill, read };

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
/// The file belongs to one process while it is filled, and survives the death of that process at any moment. Beside
/// it stands meanwhile who fills it (`OwnerFile`), for other machines that see it. Of one that may only stand still it
/// is taken over as a copy (`hand_over`); such a one's store is read as it is, or from a copy where a change is open.
class Store final : public CellKeeper {
public:
    /// Opens the store of this study, or makes it.
    ///
    /// Throws `Error`: input if the file is something else or another study's (the first difference is named), io if
    /// another process fills it or the file cannot be read or written, interrupted where a wait for another one is
    /// ended.
    Store(const std::filesystem::path& file, const Study& study, StoreUse use = StoreUse::fill,
          const storage::WaitOptions& wait = {});

    ~Store() override;
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;

    /// Whose work was taken over, who died or has been silent for too long; nothing as a rule.
    const std::optional<storage::SeenOwner>& replaced() const { return replaced_; }

    /// Was it taken over as a copy, from one who may go on with what he has open?
    bool was_handed_over() const { return was_handed_over_; }

    /// Where it stands.
    const std::filesystem::path& file() const { return file_; }

    std::string name() const override { return "the store " + file().string(); }

    std::vector<bool> stored() override;

    Counts counts() override;

    /// Keeps cells, all or none, on disk when it returns. Throws `Error` (io) if that fails; the store stays good.
    void write(std::span<const IndexedCell> cells) override;

    /// Throws `Error` (io) at a row that no sweep wrote, or out of order.
    void visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) override;

    /// Likewise; other figures are not read.
    void visit_figures(std::size_t first, std::size_t last, std::span<const CellFigure> figures,
                       const std::function<void(IndexedCell&)>& use) override;

    /// The cells from an index on as they stand, in index order: rows of `cell_columns`, to be copied. Must end before
    /// the store.
    storage::Statement rows(std::int64_t from = std::numeric_limits<std::int64_t>::min());

    /// All cells that are there, in index order.
    std::vector<IndexedCell> read();

private:
    storage::Database opened(const storage::WaitOptions& wait);

    std::filesystem::path file_;
    StoreUse use_;
    std::optional<storage::PrivateFolder> private_;  // with a copy that is read
    std::unique_ptr<storage::OwnerFile> owner_;      // nothing where it is only read
    std::optional<storage::SeenOwner> replaced_;
    bool was_handed_over_ = false;
    storage::Database database_;
    bool is_blank_ = false;  // only read, and whoever began it died before it had tables
    std::size_t cells_ = 0;  // [1] of the study
    std::size_t known_ = 0;  // [1] of them that are there, once somebody asked
};

}  // namespace stridor::sweep
