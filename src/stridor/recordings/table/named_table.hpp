#pragma once

#include "stridor/base/error.hpp"
#include "stridor/recordings/line_reader.hpp"
#include "stridor/recordings/table/csv_table.hpp"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::recordings {

/// A column of a table whose first row names them.
struct NamedColumn {
    std::string name;   // in small letters
    std::string unit;   // as written; empty: none
    base::Place place;  // of its title
};

/// A table whose first row names its columns: contacts, labels of rows, what recordings are. Tabs, semicolons or commas
/// separate its fields. Empty lines are passed over, and those that begin with #.
class NamedTable {
public:
    /// Reads the names. Throws `Error` (input) for an empty table, for UTF-16, and for a name that stands twice.
    NamedTable(const std::shared_ptr<const Bytes>& bytes, std::string file);

    /// Returns the columns in their order.
    const std::vector<NamedColumn>& columns() const { return columns_; }

    /// Returns the place of the row that was read last.
    base::Place place() const { return place_of(lines_.name(), row_, 1); }

    /// Says whether there is a column of this name.
    bool has(std::string_view name) const { return find(name).has_value(); }

    /// Reads the next row; false at the end. Throws `Error` (input) for a row that has more fields than names.
    bool next();

    /// Returns the text in a column of the row; empty where there is none.
    std::string text(std::string_view name) const;

    /// Returns the number in a column of the row; `std::nullopt` where the text is no number, or infinite.
    std::optional<double> number(std::string_view name) const;

private:
    std::optional<std::size_t> find(std::string_view name) const;
    std::optional<TextLine> next_line();

    LineReader lines_;
    csv_table::Dialect dialect_;
    std::vector<NamedColumn> columns_;
    TextLine row_;
    std::vector<csv_table::CsvField> fields_;  // of the row
};

}  // namespace stridor::recordings
