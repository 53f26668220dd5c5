#pragma once

#include "stridor/recordings/open_signal.hpp"
#include "stridor/signal/source.hpp"

#include <string>
#include <utility>
#include <vector>

namespace stridor::recordings {

/// A file of tests/fixtures/signals.
inline std::string fixture(const std::string& name) {
    return STRIDOR_SOURCE_DIR "/tests/fixtures/signals/" + name;
}

/// Bytes as a file that is to be read.
inline SignalInput input_of(std::string bytes, std::string name = "f") {
    return {bytes_of(std::move(bytes)), std::move(name), {}};
}

/// All samples of a recording, shape [channel].
inline std::vector<signal::Signal> all_of(const std::string& path, const OpenOptions& options = {}) {
    return signal::read_all(*open_signal(path, options));
}

inline std::vector<signal::Signal> all_of(const SignalInput& input, const OpenOptions& options = {}) {
    return signal::read_all(*open_signal(input, options));
}

}  // namespace stridor::recordings
