#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/noise_library/query.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Queries in SQL: what `Library::find` asks its database.
namespace stridor::noise_library {

/// A figure's name and unit, as they stand in a library.
struct FigureKind {
    std::string name;
    std::string unit;
};

/// A query as SQL; its values are bound, never written into it.
struct Selection {
    std::string rows;                                         // " FROM entry e WHERE ..."
    std::string order;                                        // " ORDER BY ..."
    std::vector<std::variant<double, std::string>> values{};  // of the parameters in `rows`
};

/// Throws `Error` (input) for a name that is no field and none of the figures, a value of the wrong kind, or a
/// comparison that words do not have.
Selection select(const Query& query, std::span<const FigureKind> figures);

/// Binds the values; the selection must outlive the statement's run.
void bind(storage::Statement& statement, const Selection& selection);

/// The name of the column of a field that is no document.
std::string column_of(const EntryField& field);

/// The columns that `entry_in` reads.
std::string columns();

/// The entry in a row, without its documents and figures.
Entry entry_in(const storage::Statement& row);

}  // namespace stridor::noise_library
