#pragma once

#include "stridor/analysis/friction/trace.hpp"
#include "stridor/classification/recording_verdict.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/noise_library/field.hpp"
#include "stridor/parameters/case.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>
#include <string>
#include <vector>

/// Fills fields of an entry from the words of files, rigs and cases about a sound.
namespace stridor::noise_library {

/// Fills empty fields of an entry, and remembers which.
class EntryFiller {
public:
    /// Begins with an entry, which must outlive this object.
    explicit EntryFiller(Entry& entry) : entry_(&entry) {}

    /// Takes a name as people write it ("Normal load [N]", "temp") and its text. A name that is not a field of the
    /// user's is ignored; a text that cannot be read is remembered.
    void take(const std::string& name, const std::string& text);

    /// Takes a quantity in the field's unit; one that is not finite is ignored.
    void take(const char* name, double value);

    /// Takes a line of several, as ID lines of a UFF file have them: "preload: 20 N; temperature = 23 degC".
    void take_line(const std::string& line);

    /// Returns sentences on the fields taken from `source`, and on texts that were not understood; may be empty.
    std::vector<std::string> notes(const std::string& source) const;

private:
    void remember(const EntryField& field);

    Entry* entry_;
    std::vector<std::string> taken_{};
    std::vector<std::string> misread_{};
};

/// Returns the greatest velocity of a drive [m/s] to six digits, for 2 pi f A has no short text; `unknown` for a
/// sampled one.
double peak_velocity(const parameters::Drive& drive);

/// Returns "constant", "sinusoidal 5 Hz"; empty for a sampled drive.
std::string profile_of(const parameters::Drive& drive);

// The figures of an entry, to six digits, which is more than any recording has and prints the same everywhere.

/// Returns level, frequency, features and impulses of the loudest segment of the recording's category; loudness,
/// sharpness and roughness of a sound pressure as a whole. Silence has a level at most.
std::vector<Figure> figures_of(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

/// Returns friction coefficients and force drops as figures.
std::vector<Figure> figures_of(const analysis::FrictionFigures& found);

/// Adds the figures that the entry lacks: those written by a person stay.
void add_missing(Entry& entry, std::span<const Figure> figures);

}  // namespace stridor::noise_library
