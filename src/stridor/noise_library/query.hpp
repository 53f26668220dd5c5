#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/storage/database.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace stridor::noise_library {

/// The comparisons of a condition; `contains` is for words alone.
enum class Comparison { equal, different, less, at_most, more, at_least, contains };

/// One condition on a field or a figure: preload > 10 N.
struct Condition {
    std::string name;
    Comparison comparison = Comparison::equal;
    std::string value;
};

/// How much of each entry is read: `summary` leaves documents and figures empty, `figures` the documents.
enum class EntryExtent { summary, figures, whole };

/// The end of an order that comes first.
enum class SortOrder { rising, falling };

/// The entries to find, and their order. An unknown value meets only the condition "= unknown", and comes last.
struct Query {
    std::vector<std::int64_t> ids{};      // these alone; empty: all
    std::vector<Condition> conditions{};  // all of them must hold
    std::vector<std::string> words{};     // each must stand in the text of the entry, in either case
    std::string sort{};                   // a field or a figure; empty: by id
    SortOrder direction = SortOrder::rising;
    std::size_t limit = 0;  // [1] at most this many, the first in that order; 0: all
    EntryExtent extent = EntryExtent::summary;
};

/// Returns conditions from "preload > 10 N and system = brake": name, one of = != < <= > >= ~ (contains), value; a
/// value that holds " and " stands in quotes.
///
/// Throws `Error` (input) for any other text; the library checks names and values, since it knows its figures.
std::vector<Condition> parse_conditions(std::string_view text);

/// Returns a query from conditions, the words of a search, and the order: "-preload" is falling; all may be empty.
Query parse_query(std::span<const std::string> conditions, std::string_view words, std::string_view sort);

/// Returns a number of entries from "20", or 0 from "all". Throws `Error` (input) for any other text.
std::size_t parse_limit(std::string_view text);

/// Returns the words of a search, split at blanks.
std::vector<std::string> parse_words(std::string_view text);

// Queries in SQL: what `Library::find` asks its database.

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

/// Returns a query as SQL. Throws `Error` (input) for a name that is neither a field nor one of the figures, a value of
/// the wrong kind, or a comparison that words do not have.
Selection select(const Query& query, std::span<const FigureKind> figures);

/// Binds the values; the selection must outlive the statement's run.
void bind(storage::Statement& statement, const Selection& selection);

/// Returns the name of the column of a field that is not a document.
std::string column_of(const EntryField& field);

/// Returns the columns that `entry_in` reads.
std::string columns();

/// Returns the entry in a row, without its documents and figures.
Entry entry_in(const storage::Statement& row);

}  // namespace stridor::noise_library
