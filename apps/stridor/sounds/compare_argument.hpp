#pragma once

#include "library/library.hpp"
#include "sounds/compare_input.hpp"
#include "stridor/recordings/open_signal.hpp"

#include <string>
#include <variant>

namespace stridor::app {

/// A sound of a file, known but not read.
struct Recorded {
    recordings::SignalInput input;
    recordings::OpenOptions open;
    double rate = 0.0;  // [Hz]
};

/// What an argument of `stridor compare` names.
struct Asked {
    std::string name;
    std::string label;
    std::string origin;
    std::variant<Recorded, SimulatedSound> source;
};

/// Understands an argument (`sound_forms`), and says on stderr what is noteworthy of a recording. Throws `Error`
/// (input) for what names nothing that can be heard.
Asked asked_sound(const std::string& text, const LibraryOption& library);

}  // namespace stridor::app
