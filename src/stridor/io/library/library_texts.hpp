#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/sensitivity.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace stridor::io {

/// Returns "stridor.library/1" as CSV text: a row per entry that was read with its figures; its id, its fields without
/// documents, and a column for each figure that any of them has. An unknown value is an empty field.
std::string library_csv(std::span<const noise_library::Entry> entries);

// JSON documents of the noise library.

/// Returns "stridor.library/1": entries that were read whole, as objects of their known values, the figures of each by
/// name, and a table of units. `library` is their file.
std::string library_json(const std::filesystem::path& library, std::span<const noise_library::Entry> entries);

/// Writes that document in pieces, one after the other: an opening, an entry each, a closing. Memory does not grow with
/// them.
class LibraryJson {
public:
    /// Returns the text before the entries.
    std::string opening(const std::filesystem::path& library);
    /// Returns the next entry, with the comma before it if it needs one.
    std::string entry(const noise_library::Entry& entry);
    /// Returns the text behind the entries. `more` are further members, with the comma before them.
    std::string closing(std::string_view more = "") const;

private:
    std::map<std::string, std::string> units_{};  // of figures
    bool is_first_ = true;
};

/// Writes "stridor.library/1" of a query's entries, piece by piece: it may be too large for memory.
void library_json(noise_library::Library& library, const noise_library::Query& query,
                  const std::function<void(std::string_view piece)>& take);

/// Returns "stridor.library/1" of entries that were just added, with a `summary` of the results for all files.
std::string arrivals_json(const std::filesystem::path& library, std::span<const noise_library::Entry> entries,
                          const noise_library::Arrivals& arrivals);

/// Returns "stridor.sensitivity/1": records, bins, ranges of the categories and rank correlations.
std::string sensitivity_json(const std::filesystem::path& library, const noise_library::Sensitivity& sensitivity);

}  // namespace stridor::io
