#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>

/// How an entry lies in the tables of a library: a row of `entry`, a row of `document` for each long text, a row of `figure` for
/// each figure. Whoever calls has a transaction open.
namespace stridor::noise_library {

/// Makes the tables and their indices in an empty database.
void create_tables(storage::Database& database);

/// Writes an entry, in the place of the one with its id, or as a new one if it has none; returns its id.
std::int64_t write_entry(storage::Database& database, const Entry& entry);

/// Removes an entry; its audio stays.
void remove_entry(storage::Database& database, std::int64_t id);

}  // namespace stridor::noise_library
