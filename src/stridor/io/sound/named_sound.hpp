#pragma once

#include "stridor/base/error.hpp"
#include "stridor/hearing/sound_comparison.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace stridor::io {

/// What a text with the form of a sound means: "FILE", "FILE:channel=2", "CASE.toml", "CHART.toml:x=..,y=..",
/// "library:ID".
inline constexpr const char* sound_forms =
    "A sound is a recording (FILE, or FILE:channel=NAME|NUMBER), a case (CASE.toml), a cell of a chart "
    "(CHART.toml:x=20 N,y=0.6, "
    "with ,direction=coming where it has both), or an entry of the noise library (library:ID).";

/// Where sounds are looked for, and who is told what is noteworthy of them.
struct SoundLookup {
    std::filesystem::path library{};  // of "library:ID"; empty: the user's own
    std::function<void(const std::string&)> note = [](const std::string&) { /* of a recording */ };
    std::function<void(const base::Complaint&)> warn = [](const base::Complaint&) { /* of a case or a chart */ };
};

/// Returns the sound that such a text names; of files only what tells their rate is read. A file that is there by the
/// whole name is that file.
///
/// Throws `Error`: input for what names nothing that can be heard, and what opening files and the library throws.
hearing::NamedSound named_sound(const std::string& text, const SoundLookup& lookup);

/// Returns the sound of a recording or of an entry of the library. Throws `Error` (input) for a case or a chart, and as
/// `named_sound` does.
hearing::NamedSound named_recording(const std::string& text, const SoundLookup& lookup);

}  // namespace stridor::io
