#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// How an entry lies in the tables of a library: a row of `entry`, a row of `document` for each long text, a row of
/// `figure` for each figure. Whoever calls has a transaction open.
namespace stridor::noise_library {

/// The statements that make the tables and their indices.
std::vector<std::string> table_statements();

/// Makes them in an empty database, and writes into its header what it is.
void create_tables(storage::Database& database);

/// Writes an entry, in the place of the one with its id, or as a new one if it has none; returns its id.
std::int64_t write_entry(storage::Database& database, const Entry& entry);

/// The ids of all entries, rising.
std::vector<std::int64_t> entry_ids(storage::Database& database);

/// An entry, whole, with the digest that was written with it.
struct KeptEntry {
    Entry entry;
    std::string digest;
};

/// Nothing but an id of 0 if there is none of this id.
KeptEntry read_entry(storage::Database& database, std::int64_t id);

/// Does it say what it said when it was written?
bool is_sound(const KeptEntry& kept);

/// Removes an entry; its audio stays.
void remove_entry(storage::Database& database, std::int64_t id);

}  // namespace stridor::noise_library
