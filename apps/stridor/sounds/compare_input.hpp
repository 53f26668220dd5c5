#pragma once

#include "library/library.hpp"
#include "stridor/classification/compared_sound.hpp"
#include "stridor/recordings/open_signal.hpp"
#include "stridor/sound/auralisation.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// What the commands that lay sounds side by side share.
namespace stridor::app {

/// Which motion of the model stands for its sound.
struct MotionOptions {
    std::string of = "joint";
    std::string quantity = "velocity";
};

/// Adds `--of` and `--quantity`.
void add_motion_options(CLI::App& command, MotionOptions& options);

sound::Pickup pickup_of(const MotionOptions& options);

/// "joint velocity along x"
std::string motion_words(const MotionOptions& options);

struct CompareOptions {
    std::vector<std::string> sounds;  // recordings, cases, cells of charts, entries of the library
    std::vector<std::string> labels;
    LibraryOption library;
    MotionOptions motion;
    std::string detail = "50 ms";
};

/// Adds the sounds, `--label`, `--library`, and the motion's options.
void add_compare_options(CLI::App& command, CompareOptions& options);

/// What a text with the form of an argument means: "FILE", "FILE:channel=2", "CASE.toml", "CHART.toml:x=..,y=..",
/// "library:ID".
inline constexpr const char* sound_forms =
    "A sound is a recording (FILE, or FILE:channel=NAME|NUMBER), a case (CASE.toml), a cell of a chart "
    "(CHART.toml:x=20 N,y=0.6, "
    "with ,direction=coming where it has both), or an entry of the noise library (library:ID).";

/// Opens, simulates, brings to one rate, analyses and judges the sounds; says on stderr what is noteworthy.
///
/// Throws `Error` (input) for fewer than 2 or more than 8, or for what no sound can be made of.
std::vector<classification::ComparedSound> load_sounds(const CompareOptions& options);

/// The recording FILE or FILE:channel=NAME or library:ID alone, as it came. Throws `Error` (input) for a case or a
/// chart.
classification::ComparedSound load_recording(const std::string& text, const LibraryOption& library);

/// A simulated case as one of the sounds.
struct SimulatedSound {
    std::string name;
    parameters::Case c;
    std::vector<sound::Stretch> stretches;  // heard; empty: the whole run
    double rate = 48000.0;                  // [Hz]
};
classification::ComparedSound simulate_sound(const SimulatedSound& simulated, const MotionOptions& motion,
                                             double detail);

}  // namespace stridor::app
