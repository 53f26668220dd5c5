#pragma once

#include "stridor/base/error.hpp"
#include "stridor/recordings/bytes.hpp"
#include "stridor/signal/source.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stridor::recordings {

/// An error (input) in a file that is read, where it stands.
inline base::Error refusal(base::Place place, std::string what, std::string why = "", std::string suggestion = "") {
    return {base::ErrorKind::input, {std::move(what), std::move(why), std::move(suggestion)}, std::move(place)};
}

/// The same where only the file is known.
inline base::Error refusal(const std::string& file, std::string what, std::string why = "",
                           std::string suggestion = "") {
    return refusal(base::Place{file, 0, 0, ""}, std::move(what), std::move(why), std::move(suggestion));
}

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

/// What keeps a channel from being a signal.
enum class FaultKind { none, no_samples, counter };

/// Why a channel is no signal.
struct ChannelFault {
    FaultKind kind = FaultKind::none;
    std::string why{};  // "is nan in sample 78", "grows by the same step in every sample, as a counter does"
};

/// Reads a source to its end, and tells of each channel why it is no signal, shape [channel].
///
/// Counters are whole numbers, 32 at the least. Throws as the source does.
std::vector<ChannelFault> channel_faults(signal::Source& source);

}  // namespace stridor::recordings
