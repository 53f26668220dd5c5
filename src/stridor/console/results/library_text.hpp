#pragma once

#include "stridor/noise_library/add_recordings.hpp"
#include "stridor/noise_library/check.hpp"
#include "stridor/noise_library/library.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// What a noise library holds, as people read it.
namespace stridor::console {

/// Entries as a table of the fields and figures named, with a row of units.
std::string entry_table(const std::vector<noise_library::Entry>& entries, const std::vector<std::string>& columns,
                        const std::vector<noise_library::FigureKind>& figures);

/// Returns one entry in full, a line per field that is known.
std::string entry_page(const noise_library::Library& library, const noise_library::Entry& entry);

/// Returns "12  squeal.wav  3.2 s, 48000 Hz, 2 channels"
std::string entry_line(const noise_library::Entry& entry);

/// Returns "   1  squeal.wav  3.2 s, 48000 Hz, 1 channel: squeal", with the category where there is one.
std::string judged_line(const noise_library::Entry& entry);

/// Returns what became of many recordings: numbers, then a line for each that was known (if they are few) or refused.
std::string summary_text(const noise_library::Arrivals& arrivals);

/// Returns what an entry can say, a line per field, then a line per figure.
std::string fields_text(const std::vector<noise_library::FigureKind>& figures);

/// Returns "entry 3", "entries 3, 5"
std::string ids_text(const std::vector<std::int64_t>& ids);

/// Returns a line for each thing that is wrong with a library.
std::vector<std::string> finding_lines(const noise_library::Findings& findings);

}  // namespace stridor::console
