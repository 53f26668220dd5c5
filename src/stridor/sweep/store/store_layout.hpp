#pragma once

#include "stridor/base/error.hpp"
#include "stridor/storage/database.hpp"
#include "stridor/storage/owner_file.hpp"
#include "stridor/sweep/cell.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

/// The inside of a store of cells, for the classes that open one.
namespace stridor::sweep {

/// Layout of a store. Raise it when a table, a column or its meaning changes: older stores are then refused.
inline constexpr int store_schema = 3;

/// The identity in a store's header, "STRD", where other programs look for the kind of a database. Pages have checksums
/// from layout 3 on.
inline constexpr storage::Identity store_identity{0x53545244, 3};

/// Returns how a store is opened: by one process alone, with the words of a sweep.
storage::DatabaseOptions store_options();

/// Returns how messages name a store and its owner.
storage::OwnerOptions owner_options(const std::filesystem::path& store);

/// Makes a claimed store this process's own: removes replacements that others left beside it, and replaces it by a copy
/// if a former owner may go on with it (`storage::hand_over`).
void take_over_files(storage::OwnerFile& owner, const std::filesystem::path& store);

/// Makes the tables of an empty store, for the study of this canonical text.
void create_tables(storage::Database& database, const std::string& study_text);

/// Throws `Error`: input if the file is something else, another study's (the first difference is named) or of another
/// generation, io if it is damaged.
void verify_tables(storage::Database& database, const std::string& study_text);

/// Returns the columns of a cell with these figures, separated by commas, the index first.
std::string cell_columns(std::span<const CellFigure> figures = cell_figures());

/// Returns the number of those columns.
std::size_t cell_columns_count();

/// Returns the statement that `insert` takes, with a parameter for each of `cell_columns`.
std::string insert_cell();

/// Runs that statement for a cell.
void insert(storage::Statement& statement, const IndexedCell& cell);

/// Returns the cell in a row of `cell_columns` of these figures, in a study of `cells` cells, or `std::nullopt` for a
/// row that no sweep wrote.
std::optional<IndexedCell> cell_in(const storage::Statement& row, std::size_t cells,
                                   std::span<const CellFigure> figures = cell_figures());

/// Returns the error (io) to throw for such a row: the store is damaged.
Error no_cell_of_the_study(const std::filesystem::path& store, std::int64_t index);

/// Returns the place of a word in a list, or `std::nullopt` if it is not in it.
template <typename Names>
std::optional<std::size_t> place_in(const Names& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

}  // namespace stridor::sweep
