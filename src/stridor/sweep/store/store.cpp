#include "stridor/sweep/store/store.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/storage/hand_over.hpp"
#include "stridor/sweep/store/store_layout.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace stridor::sweep {

using storage::Statement;
using storage::Transaction;

Store::Store(const std::filesystem::path& file, const Study& study, StoreUse use, const storage::WaitOptions& wait)
    : file_(file),
      use_(use),
      database_(opened(wait)),
      cells_(cell_count(study)) {
    const std::string text = canonical_text(study);
    // it is read from one end to the other, perhaps beside a thousand others
    if (use == StoreUse::read) database_.execute("PRAGMA cache_size = -256");
    // the file changes by commits alone, for those who look on
    if (use == StoreUse::fill) database_.execute("PRAGMA cache_spill = OFF");
    try {
        Transaction transaction(database_,
                                use == StoreUse::fill ? Transaction::Purpose::write : Transaction::Purpose::read);
        if (owner_) replaced_ = owner_->replaced();
        is_blank_ = database_.is_new();
        if (!is_blank_)
            verify_tables(database_, text);
        else if (use == StoreUse::fill)
            create_tables(database_, text);
        is_blank_ = is_blank_ && use == StoreUse::read;
        transaction.commit();
    } catch (const Error&) {
        // a file of it may have been refused because it was lost
        if (owner_) owner_->expect_own();
        throw;
    }
    if (owner_) owner_->end_change();
}

storage::Database Store::opened(const storage::WaitOptions& wait) {
    storage::DatabaseOptions options = store_options();
    storage::OwnerOptions claim = owner_options(file_);
    claim.wait = wait;
    if (use_ == StoreUse::fill) {
        owner_ = std::make_unique<storage::OwnerFile>(file_, claim);
        was_handed_over_ = owner_->may_be_in_other_hands();
        take_over_files(*owner_, file_);
        options.confirm = [this] {
            owner_->confirm();
            storage::remove_unfinished(file_, owner_->mark());
        };
        options.is_ours = [this] { return owner_ && owner_->may_change(); };
        return storage::Database(file_, options);
    }
    storage::expect_not_filled(file_, claim);
    options.ownership = storage::Ownership::shared;
    options.missing = storage::MissingFile::refuse;
    // its former owner may only be standing still
    const std::optional<storage::SeenOwner> left = storage::owner_of(file_);
    const bool is_anothers = left && !storage::is_of_this_host(left->owner);
    if (is_anothers) options.undoing = storage::Undoing::never;
    if (!is_anothers || !storage::has_open_change(file_)) return storage::Database(file_, options);
    private_.emplace();
    const std::filesystem::path copy = private_->path() / file_.filename();
    storage::copy_database(file_, copy, store_options());
    return storage::Database(copy, options);
}

// who comes next on this machine finds no owner before the lock is free
Store::~Store() {
    if (!owner_) return;
    try {
        if (owner_->may_change()) database_.end_journal();
    } catch (const Error&) {
        // it stays beside the store until the next one has opened it
    }
    owner_.reset();
}

std::vector<bool> Store::stored() {
    std::vector<bool> found(cells_);
    if (is_blank_) return found;
    Statement rows = database_.prepare("SELECT id FROM cell");
    while (rows.step()) {
        const std::int64_t id = rows.integer(0);
        if (id >= 0 && static_cast<std::size_t>(id) < cells_) found[static_cast<std::size_t>(id)] = true;
    }
    known_ = static_cast<std::size_t>(std::count(found.begin(), found.end(), true));
    if (owner_) owner_->tell(known_);
    return found;
}

Counts Store::counts() {
    Counts counts;
    if (is_blank_) return counts;
    Statement rows = database_.prepare(
        "SELECT status, category, count(*), quiet_because FROM cell GROUP BY status, category, quiet_because");
    while (rows.step()) {
        const auto number = static_cast<std::size_t>(rows.integer(2));
        if (const auto status = place_in(status_names, rows.text(0))) counts.statuses[*status] += number;
        if (rows.text(3) == classification::name(classification::Quiet::locks))
            counts.locks += number;
        else if (const auto category = place_in(classification::category_names, rows.text(1)))
            counts.categories[*category] += number;
    }
    return counts;
}

void Store::write(std::span<const IndexedCell> cells) {
    STRIDOR_EXPECT(use_ == StoreUse::fill);
    owner_->expect_own();
    try {
        Transaction transaction(database_);
        Statement row = database_.prepare(insert_cell());
        for (const IndexedCell& cell : cells) {
            STRIDOR_EXPECT(cell.index < cells_);
            insert(row, cell);
        }
        owner_->begin_change();
        transaction.commit();
    } catch (const Error&) {
        owner_->expect_own();
        throw;
    }
    known_ += cells.size();
    owner_->tell(known_);
    owner_->end_change();
}

void Store::visit(std::size_t first, std::size_t last, const std::function<void(IndexedCell&)>& use) {
    visit_figures(first, last, cell_figures(), use);
}

void Store::visit_figures(std::size_t first, std::size_t last, std::span<const CellFigure> figures,
                          const std::function<void(IndexedCell&)>& use) {
    if (is_blank_) return;
    Statement rows =
        database_.prepare("SELECT " + cell_columns(figures) + " FROM cell WHERE id >= ? AND id < ? ORDER BY id");
    rows.bind(1, static_cast<std::int64_t>(first));
    rows.bind(2, static_cast<std::int64_t>(last));
    std::size_t next = first;
    while (rows.step()) {
        std::optional<IndexedCell> cell = cell_in(rows, cells_, figures);
        // who is shown the cells counts on their order
        if (!cell || cell->index < next || cell->index >= last) throw no_cell_of_the_study(file(), rows.integer(0));
        next = cell->index + 1;
        use(*cell);
    }
}

Statement Store::rows(std::int64_t from) {
    if (is_blank_) return database_.prepare("SELECT 0 WHERE 0");
    Statement rows = database_.prepare("SELECT " + cell_columns() + " FROM cell WHERE id >= ? ORDER BY id");
    rows.bind(1, from);
    return rows;
}

std::vector<IndexedCell> Store::read() {
    std::vector<IndexedCell> cells;
    visit(0, cells_, [&](IndexedCell& cell) { cells.push_back(std::move(cell)); });
    return cells;
}

}  // namespace stridor::sweep
