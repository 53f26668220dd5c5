#pragma once

#include "stridor/analysis/alternation.hpp"
#include "stridor/analysis/rates.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/record/tally.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace stridor::analysis {

/// Reference velocity of velocity levels [m/s] (ISO 1683: 1e-9 m/s).
///
/// No level below 0 dB is given. A surface that moves at 1 nm/s makes at most rho c v = 0.4 uPa, 34 dB below the
/// threshold of hearing. The rounding of a motion of some m/s is below 1 pm/s, -60 dB: such numbers mean nothing.
inline constexpr double reference_velocity = 1e-9;

/// Returns the title of a column of levels: they are those of the joint, or of the contact points of an own structure.
std::string_view level_title(const parameters::Case& c);

/// Returns the sentence for people beside a level. Files write the reference as "1e-9 m/s".
std::string_view level_note(const parameters::Case& c);

/// Vibration level of one body over the judged time. It is the vibration of the model's masses, not a sound pressure.
struct Level {
    double rms = 0.0;            // [m/s] root mean square of the velocity vector
    double peak = 0.0;           // [m/s] largest magnitude of the velocity vector, at least the root mean square
    double decibels = 0.0;       // [dB re 1e-9 m/s] of the root mean square; -infinity below 0
    double peak_decibels = 0.0;  // [dB re 1e-9 m/s] of the peak
};

/// Levels of the paper's two bodies; with several joints, of one joint and the plate.
struct Levels {
    Level joint;  // mass 1: (x1', y1')
    Level plate;  // mass 2: y2'
};

/// The part of the run: all that is judged, or its end under a constant drive.
enum class Part { judged, closing };

/// Whether the joint's motion along the contact counts. While the joint sticks, the plate carries it: that motion is
/// not vibration.
enum class Along { counted, carried };

/// Returns the levels of a contact's joint and of the plate, from a tally of the rubbing system: two degrees of freedom
/// a joint, in the order of the contacts, then one of the plate. For an own structure they are those of a contact's
/// point, along and across; it has no plate. NaN if nothing was judged.
Levels levels(const record::Tally& tally, std::size_t contact = 0, Part part = Part::judged,
              Along along = Along::counted);

/// The figures of one contact in one phase of a run, from which a verdict by contact states is made.
struct Evidence {
    record::Phase phase = record::Phase::all;
    std::size_t contact = 0;     // number among those of the structure
    double window_time = 0.0;    // [s] time in the window
    double judged_time = 0.0;    // [s] of it, time that was judged
    Rates rates;                 // whole window
    Rates judged_rates;          // judged part: reversals cut
    Rates judged_errors;         // standard errors of those (`share_errors`)
    Alternation alternation;     // judged part
    long releases = 0;           // [1] sticks that ended, judged part
    long all_releases = 0;       // [1] sticks that ended, whole window
    record::Ending ending;       // of the run, and what is known beyond it
    double preload = 0.0;        // [N] N at rest; 0: not known, or open there
    double largest_force = 0.0;  // [N] judged part, largest N where states and spans end
    // change of the shares from twice the time step, if the engine compared two: about their error
    std::optional<Rates> step_change{};         // whole window
    std::optional<Rates> judged_step_change{};  // judged part
    std::optional<Alternation> coarser{};       // judged part, at twice the time step
    bool creeps = false;                        // its friction is regularised: it creeps where it should stick
    Levels levels;  // of the bodies, judged part; of a contact that slides or sticks for ever its closing part
};

/// Says whether the contact sticks for ever: proven, or it stuck for all of the judged time and is not known to slip.
bool sticks_for_good(const Evidence& evidence);

/// Says whether the contact slides for ever: proven, or it slid for all of the judged time and no disturbance grows.
bool slides_for_good(const Evidence& evidence);

/// Says whether the contact left the surface within the judged part or before, did not alternate, and is in separation
/// at the end of the run.
bool stays_off(const Evidence& evidence);

/// Returns the evidence of contact number `contact` from one phase's tally.
Evidence evidence(const record::Tally& tally, std::size_t contact);

/// One number of a phase's evidence. The figures of a cell, and a verdict in JSON with its units, come from this table.
struct EvidenceFigure {
    std::string_view name;      // of a cell's figure, a word of lower-case letters, digits and underscores
    std::string_view key;       // where it stands in a verdict as JSON, "levels.joint.rms"
    std::string_view unit;      // "1", "Hz", "dB re 1e-9 m/s"
    std::string_view sentence;  // for attributes and colour bars
    double (*value)(const Evidence&);
    /// Says whether the value is a whole number.
    enum class Holds : std::uint8_t { number, count } holds = Holds::number;
    /// Where the figure is told: all in verdicts, most in cells too.
    enum class Kept : std::uint8_t { in_cells, in_verdicts } kept = Kept::in_cells;
};

/// Returns all figures, in the order of files.
std::span<const EvidenceFigure> evidence_figures();

/// Returns the name under which a document gives a figure's unit; empty for a count, which needs none.
///
/// Figures side by side with one unit share a name: the shares of an object do ("rates.slip" is in "rates"), and so do
/// those of its bodies ("levels.joint.rms" is in "levels.rms").
std::string unit_key(const EvidenceFigure& figure);

}  // namespace stridor::analysis
