#pragma once

#include "stridor/recordings/bytes.hpp"
#include "stridor/signal/source.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stridor::recordings {

/// What only the samples of a recording can tell, and its reader has not looked for.
enum class Doubt {
    none,                 // whole numbers, or the reader has looked
    numbers,              // some may be none: overloads, NaN
    numbers_and_counters  // and nothing tells a counter from a signal
};

/// What one format's reader makes of a file: the numbers as they stand in it. `open_signal` gives them their units.
struct RawSignal {
    std::unique_ptr<signal::Source> source{};  // units: the file's own words, empty where it has none
    std::string format{};                      // "WAV (Microsoft), Signed 24 bit PCM"
    std::string description{};                 // free text that may hold a calibration; may be empty
    std::vector<std::string> notes{};          // what the user should know of how it was read
    Doubt doubt = Doubt::none;
    std::string time{};                   // what was taken for the time: column 1, "t" in ms; empty: a rate
    std::vector<std::string> left_out{};  // what is in the file and no channel, with the reason
    std::vector<std::pair<std::string, std::string>> metadata{};  // what else the file says of itself
};

/// A file that is to be read.
struct SignalInput {
    std::shared_ptr<const Bytes> bytes;
    std::string name{};                    // for messages
    std::optional<std::string> sidecar{};  // text of the JSON file beside it
};

}  // namespace stridor::recordings
