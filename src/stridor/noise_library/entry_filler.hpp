#pragma once

#include "stridor/analysis/friction_trace.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>
#include <string>
#include <vector>

/// What files, rigs and cases say of a sound, in their own words, as fields of its entry.
namespace stridor::noise_library {

/// Fills an entry where nobody said anything, and remembers with what.
class EntryFiller {
public:
    /// The entry must outlive it.
    explicit EntryFiller(Entry& entry) : entry_(&entry) {}

    /// A name as people write it ("Normal load [N]", "temp") and its text; what is no field of the user's is passed by,
    /// what cannot be read is remembered.
    void take(const std::string& name, const std::string& text);

    /// A quantity in the field's unit; one that is not finite is passed by.
    void take(const char* name, double value);

    /// A line of several, as ID lines of a UFF file have them: "preload: 20 N; temperature = 23 degC".
    void take_line(const std::string& line);

    /// Sentences on what was taken from `source`, and on what was not understood; may be none.
    std::vector<std::string> notes(const std::string& source) const;

private:
    void remember(const EntryField& field);

    Entry* entry_;
    std::vector<std::string> taken_{};
    std::vector<std::string> misread_{};
};

/// The greatest velocity of a drive [m/s] to six digits, for 2 pi f A has no short text; unknown of a sampled one.
double peak_velocity(const parameters::Drive& drive);

/// "constant", "sinusoidal 5 Hz"; empty for a sampled drive.
std::string profile_of(const parameters::Drive& drive);

// What of a sound becomes figures of an entry: to six digits, which is more than any recording has and prints the same
// everywhere.

/// Level, frequency, features and impulses of the loudest segment of the recording's category; loudness, sharpness
/// and roughness of a sound pressure as a whole. Silence has a level at most.
std::vector<Figure> figures_of(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

/// Friction coefficients and force drops.
std::vector<Figure> figures_of(const analysis::FrictionFigures& found);

/// Adds those that the entry has not: what a person wrote stays.
void add_missing(Entry& entry, std::span<const Figure> figures);

}  // namespace stridor::noise_library
