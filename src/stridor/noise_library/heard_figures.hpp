#pragma once

#include "stridor/analysis/friction_trace.hpp"
#include "stridor/classification/sound_verdict.hpp"
#include "stridor/noise_library/entry.hpp"
#include "stridor/sound/analysis.hpp"

#include <span>
#include <vector>

/// What of a sound becomes figures of an entry: to six digits, which is more than any recording has and prints the same
/// everywhere.
namespace stridor::noise_library {

/// Level, frequency, features and impulses of the loudest segment of the recording's category; loudness, sharpness
/// and roughness of a sound pressure as a whole. Silence has a level at most.
std::vector<Figure> figures_of(const sound::SoundAnalysis& analysis, const classification::RecordingVerdict& verdict);

/// Friction coefficients and force drops.
std::vector<Figure> figures_of(const analysis::FrictionFigures& found);

/// Adds those that the entry has not: what a person wrote stays.
void add_missing(Entry& entry, std::span<const Figure> figures);

}  // namespace stridor::noise_library
