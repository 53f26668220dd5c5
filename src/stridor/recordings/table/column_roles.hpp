#pragma once

// Which columns of a table are times, counters and signals: decided here and nowhere else. Private to this folder.

#include "stridor/recordings/table/signal_csv_header.hpp"
#include "stridor/recordings/table/table_rows.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace stridor::recordings::signal_table {

/// What is known beside the table.
struct RoleHints {
    bool is_rate_given = false;  // by an option
    bool is_rate_said = false;   // above the table
    std::string wanted{};        // the channel that is asked for; empty: none
    std::string file{};          // for messages
};

/// Gives every column of the header its role and returns what to tell the user.
///
/// The time is the first column that is called so and has a unit of time, else one that is called so and has none, else
/// the first in a unit of time: a unit outranks a name. Left out are other times, and channels behind them that have
/// times of their own, counters, what is empty or words, and columns with a row that is no number or a mark for none,
/// unless they are asked for. Throws `Error` (input) with the place for an unknown unit of time, for times with
/// a row that is none, and where no signal is left.
std::vector<std::string> assign_roles(TableHeader& header, const TableSurvey& survey, const RoleHints& hints);

/// The column of times that the roles name.
std::optional<std::size_t> time_column(const TableHeader& header);

}  // namespace stridor::recordings::signal_table
