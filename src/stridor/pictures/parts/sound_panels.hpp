#pragma once

#include "stridor/classification/recording_verdict.hpp"
#include "stridor/drawing/scene.hpp"
#include "stridor/sound/analysis.hpp"

#include <vector>

/// Parts of pictures of sounds.
namespace stridor::pictures {

/// How far the colours of a spectrogram reach below its strongest cell [dB].
inline constexpr double spectrogram_depth = 70.0;

/// Returns the waveform as a line through the extremes of each moment [s], [unit].
drawing::Line waveform_line(const sound::SoundAnalysis& analysis);

/// Returns twice the frequency below which 99.9 % of the power lies; at least 2 kHz, if the recording reaches so far
/// [Hz].
double highest_frequency(const signal::Spectrum& spectrum);

/// The most cells of a spectrogram on paper.
struct PaperCells {
    std::size_t columns = 360;
    std::size_t rows = 140;
};

/// Returns levels over time and frequency up to `highest` [Hz], pooled to the cells on paper [dB re the unit's
/// reference].
drawing::ValueCells spectrogram_cells(const signal::Spectrogram& graph, double highest, PaperCells most = {});

/// Returns the segments in the colours of their categories, over y from 0 to 1; a layer per category that occurs.
std::vector<drawing::Layer> segment_layers(const classification::RecordingVerdict& verdict, double duration);

/// Returns the legend's entries of the categories that occur in any of these verdicts, in the order of the categories.
std::vector<drawing::LegendEntry> category_legend(const std::vector<const classification::RecordingVerdict*>& verdicts);

/// Returns an interval with some air at both ends.
drawing::Extent air_around(double low, double high);

}  // namespace stridor::pictures
