#pragma once

#include "library/library.hpp"
#include "stridor/classification/compared_sound.hpp"
#include "stridor/hearing/sound_comparison.hpp"
#include "stridor/io/sound/named_sound.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace stridor::app {

// What the commands that compare sounds share.

/// The motion of the model that is heard.
struct MotionOptions {
    std::string of = "joint";
    std::string quantity = "velocity";
};

/// Adds `--of` and `--quantity`.
void add_motion_options(CLI::App& command, MotionOptions& options);

hearing::AskedMotion asked_motion(const MotionOptions& options);

struct CompareOptions {
    std::vector<std::string> sounds;  // recordings, cases, cells of charts, entries of the library
    std::vector<std::string> labels;
    LibraryOption library;
    MotionOptions motion;
    std::string detail = "50 ms";
};

/// Adds the sounds, `--label`, `--library`, and the motion's options.
void add_compare_options(CLI::App& command, CompareOptions& options);

/// Returns where to look for the sounds; notes go to stderr.
io::SoundLookup lookup_in(const LibraryOption& library);

/// Opens, simulates, brings to one rate, analyses and judges the sounds; says notes on stderr.
///
/// Throws `Error` (input) for fewer than 2 sounds or more than 8, and for a name that does not lead to a sound.
std::vector<classification::ComparedSound> load_sounds(const CompareOptions& options);

/// Calls `hearing::compared`; Ctrl-C stops the simulation of a case.
classification::ComparedSound load_sound(const hearing::NamedSound& sound, const hearing::ComparisonSettings& settings);

/// Adds `stridor figure compare`.
void add_figure_compare(CLI::App& figure);

}  // namespace stridor::app
