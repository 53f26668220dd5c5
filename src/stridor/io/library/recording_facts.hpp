#pragma once

#include "stridor/noise_library/entry.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <functional>
#include <string>

namespace stridor::io {

/// Is told what is noteworthy, a sentence at a time.
using Notes = std::function<void(const std::string& sentence)>;

/// Puts what the file says of itself where the user said nothing, and tells what and from where. Of a simulated sound
/// the case that came along says what it was like.
///
/// Throws `Error` (input) for a simulated sound that is said to be a recording.
void take_facts(const recordings::SignalFacts& facts, noise_library::Entry& entry, const Notes& note);

}  // namespace stridor::io
