#pragma once

#include "stridor/signal/source.hpp"

#include <cstdint>
#include <string>

namespace stridor::recordings {

/// Writes a table of signals: a first line with the schema "stridor.signal/1" and the exact rate, names with units,
/// then a row per frame with its time. Numbers are the shortest that read back as the same doubles. Returns the frames.
std::uint64_t write_signal_csv(const std::string& path, signal::Source& source);

}  // namespace stridor::recordings
