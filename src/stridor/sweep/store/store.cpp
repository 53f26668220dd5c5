#include "stridor/sweep/store/store.hpp"

#include "stridor/base/check.hpp"
#include "stridor/base/error.hpp"
#include "stridor/sweep/store/store_layout.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace stridor::sweep {

using storage::Statement;
using storage::Transaction;

namespace {

storage::DatabaseOptions options_for(StoreUse use) {
    storage::DatabaseOptions options = store_options();
    if (use == StoreUse::fill) return options;
    options.ownership = storage::Ownership::shared;
    options.missing = storage::MissingFile::refuse;
    return options;
}

std::unique_ptr<storage::OwnerFile> claimed(const std::filesystem::path& file, StoreUse use) {
    if (use == StoreUse::fill) return std::make_unique<storage::OwnerFile>(file, owner_options(file));
    storage::expect_not_filled(file, owner_options(file));
    return nullptr;
}

}  // namespace

Store::Store(const std::filesystem::path& file, const Study& study, StoreUse use)
    : owner_(claimed(file, use)),
      database_(file, options_for(use)),
      use_(use),
      cells_(cell_count(study)) {
    const std::string text = canonical_text(study);
    // it is read from one end to the other, perhaps beside a thousand others
    if (use == StoreUse::read) database_.execute("PRAGMA cache_size = -256");
    // the file changes by commits alone, for those who look on
    if (use == StoreUse::fill) database_.execute("PRAGMA cache_spill = OFF");
    Transaction transaction(database_,
                            use == StoreUse::fill ? Transaction::Purpose::write : Transaction::Purpose::read);
    if (owner_) {
        owner_->confirm();
        replaced_ = owner_->replaced();
    }
    is_blank_ = database_.is_new();
    if (!is_blank_)
        verify_tables(database_, text);
    else if (use == StoreUse::fill)
        create_tables(database_, text);
    is_blank_ = is_blank_ && use == StoreUse::read;
    transaction.commit();
    if (owner_) owner_->end_change();
}

// who comes next on this machine finds no owner before the lock is free
Store::~Store() {
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
    Statement rows = database_.prepare("SELECT status, category, count(*) FROM cell GROUP BY status, category");
    while (rows.step()) {
        const auto number = static_cast<std::size_t>(rows.integer(2));
        if (const auto status = place_in(status_names, rows.text(0))) counts.statuses[*status] += number;
        if (const auto category = place_in(classification::category_names, rows.text(1)))
            counts.categories[*category] += number;
    }
    return counts;
}

void Store::write(std::span<const IndexedCell> cells) {
    STRIDOR_EXPECT(use_ == StoreUse::fill);
    owner_->expect_own();
    Transaction transaction(database_);
    Statement row = database_.prepare(insert_cell());
    for (const IndexedCell& cell : cells) {
        STRIDOR_EXPECT(cell.index < cells_);
        insert(row, cell);
    }
    owner_->begin_change();
    transaction.commit();
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

Statement Store::rows() {
    if (is_blank_) return database_.prepare("SELECT 0 WHERE 0");
    return database_.prepare("SELECT " + cell_columns() + " FROM cell ORDER BY id");
}

std::vector<IndexedCell> Store::read() {
    std::vector<IndexedCell> cells;
    visit(0, cells_, [&](IndexedCell& cell) { cells.push_back(std::move(cell)); });
    return cells;
}

}  // namespace stridor::sweep
