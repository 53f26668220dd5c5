#pragma once

#include "stridor/classification/likeness.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/record/tally.hpp"
#include "stridor/signal/source.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::classification {

/// The contact of a simulation, which a recording does not show.
struct KnownContact {
    std::vector<Verdict> verdicts{};                  // one per phase, going before coming
    std::vector<record::ContactHistory> histories{};  // shape [contact], within the detail, in the time of the sound
};

/// A short stretch of a sound, sample by sample.
struct SoundDetail {
    double from = 0.0;        // [s] in the sound
    signal::Signal signal{};  // [unit] empty for an empty sound
};

/// A sound to be compared with others: from a vehicle, a rig or a simulation.
struct ComparedSound {
    std::string name{};    // as the user called it
    std::string label{};   // short, for the head of a column
    std::string origin{};  // "recording", "simulation", "library entry 3, rig"
    std::string what{};    // of a simulation, the part that moves: "joint velocity along x"; else the channel
    double rate = 0.0;     // [Hz] of the sound as it came; `analysis` may be of a lower one
    double length = 0.0;   // [s] of the sound as it came
    sound::SoundAnalysis analysis{};
    RecordingVerdict heard{};
    SoundProfile profile{};
    SoundDetail detail{};
    KnownContact contact{};  // empty for a recording
};

/// Returns the verdict by contact states of the phase that vibrates most, or null if there is no verdict.
const Verdict* loudest_phase(const KnownContact& contact);

/// How a figure is written for people.
enum class FigureStyle { fixed, percent, milliseconds };

/// One number of a compared sound: a row of the table and of the document, and a line of the figure.
struct ComparedFigure {
    std::string_view name;   // "impulse_interval"
    std::string_view unit;   // of `value`; empty: the sound's own, as for a level
    std::string_view words;  // "impulse interval"
    FigureStyle style = FigureStyle::fixed;
    int digits = 2;                         // [1] after the point
    double (*value)(const ComparedSound&);  // [unit] NaN: not known, or the sound has no such feature
};

/// Returns all figures of a comparison, in the order of the table.
std::span<const ComparedFigure> compared_figures();

/// Returns a figure as text: "425 Hz", "18.0 %", "4.21 ms"; "-" if it is not known.
std::string figure_text(const ComparedFigure& figure, const ComparedSound& sound);

}  // namespace stridor::classification
