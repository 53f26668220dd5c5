#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/storage/database.hpp"

#include <cstdint>
#include <string>
#include <vector>

/// Entries in the tables of a library: a row of `entry`, a row of `document` for each long text, a row of `figure` for
/// each figure. The caller must have a transaction open.
namespace stridor::noise_library {

/// Returns the statements that make the tables and their indices.
std::vector<std::string> table_statements();

/// Makes the tables in an empty database, and writes its identity into the header.
void create_tables(storage::Database& database);

/// Writes an entry in the place of the one with its id, or as a new one if it has none; returns its id.
std::int64_t write_entry(storage::Database& database, const Entry& entry);

/// Returns the ids of all entries, rising.
std::vector<std::int64_t> entry_ids(storage::Database& database);

/// A whole entry, with the digest that was written with it.
struct KeptEntry {
    Entry entry;
    std::string digest;
};

/// Returns an entry; one with an id of 0 if there is none of this id.
KeptEntry read_entry(storage::Database& database, std::int64_t id);

/// Says whether an entry still has the content that was written.
bool is_sound(const KeptEntry& kept);

/// Removes an entry; its audio stays.
void remove_entry(storage::Database& database, std::int64_t id);

}  // namespace stridor::noise_library
