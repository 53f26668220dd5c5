#pragma once

#include "stridor/classification/likeness.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/hearing/heard_motion.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/auralisation.hpp"
#include "stridor/sound/features.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/evaluate.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// The sound of a simulated motion, in memory, by which the cells of a chart are judged.
namespace stridor::hearing {

/// A motion that nowhere exceeds this is rounding, and counts as silence [m/s], [m/s^2].
inline constexpr double least_motion = 1e-9;

/// Returns the heard stretches of a case's motion: within the window of its rates, the phases of a direction. Empty if
/// the drive never moves that way in the window, or the case is invalid.
std::vector<sound::Stretch> heard_stretches(const parameters::Case& c, parameters::Direction direction);

/// Throws `Error` (input) for a case whose motion cannot be sampled densely enough for such a sound (engines with long
/// steps).
void check_audible(const parameters::Case& c, const sound::AuralisationSettings& settings);

/// A run, and its heard parts.
struct RunSound {
    sweep::Attempt attempt;
    std::vector<signal::Signal> parts{};  // [m/s or m/s^2] shape [settings.stretches]; empty unless the run is done
};

/// Runs a case and makes a sound of each of the stretches by itself, faded as the settings say; they may overlap.
/// Without stretches the whole run is the one part. Returns `std::nullopt` if it was stopped.
///
/// The motion is used from 0.1 s before the first stretch, in which the high pass at 20 Hz forgets the beginning, to
/// 0.1 s behind the last one. A stretch whose motion nowhere exceeds `least_motion` becomes silent. A fault of the
/// physics or the numbers is the attempt's status; throws what `check_audible` throws.
std::optional<RunSound> sound_of_run(const parameters::Case& c, const sound::AuralisationSettings& settings,
                                     const std::stop_token& stop, integration::Workspace& workspace);

/// Returns the sound of a case [m/s or m/s^2]: the stretches of the settings (`heard_stretches` gives those of a
/// direction) one after the other, each faded in and out, or the whole run. It stands in memory: eight bytes per sample
/// of the run. For a longer sound, give the case a longer `run.duration` and `run.window`.
///
/// Throws `Error`: input for an invalid case and what `check_audible` throws, numerical for a run without a result,
/// interrupted if it was stopped.
signal::Signal sound_of_case(const parameters::Case& c, const sound::AuralisationSettings& settings,
                             const std::stop_token& stop = {});

/// Returns parts of a sound, at least one, one after the other.
signal::Signal joined(std::span<const signal::Signal> parts);

/// The verdict by ear on a sound.
struct HeardVerdict {
    std::vector<sound::SoundStretch> stretches{};
    classification::RecordingVerdict verdict{};
};

/// Says whether the sound of a case's motion bears a verdict. Where friction is regularised a contact creeps that
/// should stick, and its motion is none of a rubbing contact: `verdict.creeping` must ask for one.
bool bears_verdict(const parameters::Case& c);

/// Returns the verdict by ear on a motion of a case as far as that bears one, else that it is undecided, and why.
classification::RecordingVerdict borne(const parameters::Case& c, classification::RecordingVerdict verdict);

/// Judges the sound of a case's motion from its parts, each described by itself, so that no splice between them is
/// heard.
HeardVerdict judged(const parameters::Case& c, std::span<const signal::Signal> parts,
                    const parameters::SoundThresholds& thresholds);

/// How the cells of a chart are made audible and judged by ear.
struct CellListening {
    AskedMotion motion{};
    sound::AuralisationSettings sound{};  // its pickup and stretches follow from each cell
    parameters::SoundThresholds thresholds{};
};

/// The sound of one cell of a chart.
struct CellSound {
    std::size_t index = 0;                                                   // of the cell in its study
    sweep::Status status = sweep::Status::failed;                            // only a done cell has a sound
    std::string message{};                                                   // why it is not done
    classification::Category contact = classification::Category::undecided;  // by contact states
    classification::Category heard = classification::Category::undecided;    // by ear
    classification::SoundProfile profile{};
};

/// Simulates a cell, from the first of the study's starts if it has any, and judges it like a recording of its phases
/// one after the other (`sound_of_run`); returns `std::nullopt` if it was stopped.
///
/// A fault of the physics or the numbers becomes the status, as in `evaluate_run`.
std::optional<CellSound> sound_of_cell(const sweep::Study& study, std::size_t index, const CellListening& listening,
                                       const std::stop_token& stop, integration::Workspace& workspace);

}  // namespace stridor::hearing
