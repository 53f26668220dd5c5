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

/// Returns an error (input) at a place in a file.
inline base::Error refusal(base::Place place, std::string what, std::string why = "", std::string suggestion = "") {
    return {base::ErrorKind::input, {std::move(what), std::move(why), std::move(suggestion)}, std::move(place)};
}

/// Returns an error (input) in a file, if the place in it is not known.
inline base::Error refusal(const std::string& file, std::string what, std::string why = "",
                           std::string suggestion = "") {
    return refusal(base::Place{file, 0, 0, ""}, std::move(what), std::move(why), std::move(suggestion));
}

/// Doubts about the samples of a recording that its reader has not examined.
enum class Doubt {
    none,                 // whole numbers, or the reader has examined them
    numbers,              // some may be invalid: overloads, NaN
    numbers_and_counters  // also, no name distinguishes a counter from a signal
};

/// The numbers of a file, as the reader of its format finds them. `open_signal` gives them their units.
struct RawSignal {
    std::unique_ptr<signal::Source> source{};  // units: the file's own words, empty where it has none
    std::string format{};                      // "WAV (Microsoft), Signed 24 bit PCM"
    std::string description{};                 // free text that may hold a calibration; may be empty
    std::vector<std::string> notes{};          // how it was read, for the user
    Doubt doubt = Doubt::none;
    std::string time{};                   // the column of times: column 1, "t" in ms; empty: a rate
    std::vector<std::string> left_out{};  // content of the file that is no channel, with the reason
    std::vector<std::pair<std::string, std::string>> metadata{};  // further facts in the file
};

/// A file to be read.
struct SignalInput {
    std::shared_ptr<const Bytes> bytes;
    std::string name{};                    // for messages
    std::optional<std::string> sidecar{};  // text of the JSON file beside it
};

/// A fault that keeps a channel from being a signal.
enum class FaultKind { none, no_samples, counter };

/// The reason why a channel is not a signal.
struct ChannelFault {
    FaultKind kind = FaultKind::none;
    std::string why{};  // "is nan in sample 78", "grows by the same step in every sample, as a counter does"
};

/// Reads a source to its end, and returns the fault of each channel, shape [channel].
///
/// A counter consists of at least 32 whole numbers. Throws as the source does.
std::vector<ChannelFault> channel_faults(signal::Source& source);

}  // namespace stridor::recordings
