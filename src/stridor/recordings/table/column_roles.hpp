#pragma once

// Decides which columns of a table are times, counters and signals. Private to this folder.

#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/table/table_rows.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stridor::recordings::signal_table {

/// Facts known besides the table.
struct RoleHints {
    bool is_rate_given = false;  // by an option
    bool is_rate_said = false;   // above the table
    std::string wanted{};        // the requested channel; empty: none
    std::string file{};          // for messages
};

/// Gives every column of the header its role and returns notes for the user.
///
/// The time is the first column with a time's name and a unit of time, else one with a time's name and no unit, else
/// the first in a unit of time: a unit has priority over a name. Left out are other times, channels behind them that
/// have times of their own, counters, columns of nothing or of words, and columns with a value that is neither a number
/// nor a mark for a missing one, unless they are requested. Throws `Error` (input) with the place for an unknown unit
/// of time, for a time that is not a number, and if no signal is left.
std::vector<std::string> assign_roles(TableHeader& header, const TableSurvey& survey, const RoleHints& hints);

/// Returns the column of times by the roles, or `std::nullopt` if there is none.
std::optional<std::size_t> time_column(const TableHeader& header);

}  // namespace stridor::recordings::signal_table
