#pragma once

#include "stridor/recordings/live/stream_form.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Programs that record: how they are started, and what they say of sound that they lost.
namespace stridor::recordings {

/// Returns the programs that can record, in the order in which they are tried: "parec, arecord".
std::string known_recorders();

/// Returns the program for a device: the one named, else `arecord` for a name of ALSA ("hw:1,0", "plughw:CARD=U24"),
/// else the first on PATH; empty if there is none. Throws `Error` (input) for a name that is not known.
std::string recorder_for(std::string_view device, std::string_view named);

/// Returns the command by which a recorder sends the samples of a device to its standard output. An empty device is the
/// usual one. Throws `Error` (input) for a coding that it cannot send.
std::vector<std::string> recorder_command(const std::string& recorder, const std::string& device,
                                          const StreamForm& form);

/// Sound that a recorder says it lost.
struct LostSound {
    std::optional<double> seconds{};  // [s] if it tells
    std::string words{};              // its line
};

/// Listens to what a recorder says on its standard error, as it comes.
class RecorderWords {
public:
    /// Takes the next bytes. Returns the first loss that is told in them: "overrun!!! (at least 12.345 ms long)" of
    /// arecord, "Stream overrun." of parec.
    std::optional<LostSound> hear(std::string_view bytes);

    /// Returns the end of what it said, for an error.
    std::string last() const;

private:
    std::string line_;   // begun
    std::string lines_;  // the end of what was said
};

}  // namespace stridor::recordings
