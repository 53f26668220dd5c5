#pragma once

#include "stridor/recordings/calibration.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::recordings {

/// The facts of one channel in a sidecar; a missing fact comes from the recording.
struct SidecarChannel {
    std::optional<std::string> name{};
    std::optional<FullScale> full_scale{};
};

/// The JSON file beside a recording, NAME.wav.json: facts for which the recording's own format has no room.
struct Sidecar {
    std::vector<SidecarChannel> channels{};  // as many as the recording has
    std::optional<double> rate{};            // [Hz] exact, where the recording holds a whole number only
    std::vector<std::pair<std::string, std::string>> metadata{};
};

/// Returns the name of a recording's sidecar.
std::string sidecar_path(const std::string& recording);

/// Reads "stridor.sidecar/1"; `name` is the file's, for messages.
///
/// Throws `Error` (input) for a text that is not JSON, another schema, an unknown key, and a value of the wrong type or
/// unit.
Sidecar parse_sidecar(std::string_view json, const std::string& name);

/// Returns the sidecar as JSON text, with a line end.
std::string sidecar_json(const Sidecar& sidecar);

}  // namespace stridor::recordings
