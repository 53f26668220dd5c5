#pragma once

#include "stridor/record/tally.hpp"

#include <cstddef>
#include <string_view>

namespace stridor::analysis {

/// Reference velocity of velocity levels [m/s] (ISO 1683: 1e-9 m/s).
///
/// No level below 0 dB is told. A surface that moves at 1 nm/s makes at most rho c v = 0.4 uPa, 34 dB below the
/// threshold of hearing. Rounding of a motion of some m/s leaves less than 1 pm/s, -60 dB: such numbers mean nothing.
inline constexpr double reference_velocity = 1e-9;

/// What is said to people beside a level; without more words, a design's level is its joint's. Files write the
/// reference as "1e-9 m/s".
inline constexpr std::string_view level_note =
    "Levels are of the joint's velocity, dB re 1 nm/s: a vibration, not a sound pressure.";

/// The same of a structure of the user's own.
inline constexpr std::string_view contact_level_note =
    "Levels are of the contact point's velocity, dB re 1 nm/s: a vibration, not a sound pressure.";

/// Vibration level of one body over the judged time. It is the vibration of the model's masses, not a sound pressure.
struct Level {
    double rms = 0.0;            // [m/s] root mean square of the velocity vector
    double peak = 0.0;           // [m/s] largest magnitude of the velocity vector, at least the root mean square
    double decibels = 0.0;       // [dB re 1e-9 m/s] of the root mean square; -infinity below 0
    double peak_decibels = 0.0;  // [dB re 1e-9 m/s] of the peak
};

/// Levels of the paper's two bodies; of several joints that of one.
struct Levels {
    Level joint;  // mass 1: (x1', y1')
    Level plate;  // mass 2: y2'
};

/// Which part of the run: all that is judged, or the end of that under a constant drive.
enum class Part { judged, closing };

/// Is the joint's motion along the contact its own, or the plate's, which carries it while it sticks and is no
/// vibration?
enum class Along { counted, carried };

/// Levels of a contact's joint and of the plate, from a tally of the rubbing system: two degrees of freedom a joint, in
/// the order of the contacts, then one of the plate. Of an own structure that of a contact's point, along and across;
/// there is no plate then. NaN where nothing was judged.
Levels levels(const record::Tally& tally, std::size_t contact = 0, Part part = Part::judged,
              Along along = Along::counted);

}  // namespace stridor::analysis
