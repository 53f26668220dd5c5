#include "stridor/pictures/parts/sound_panels.hpp"

#include "stridor/drawing/palette.hpp"
#include "stridor/pictures/parts/category_colours.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stridor::pictures {

namespace {

using classification::Category;
using classification::RecordingVerdict;

bool occurs(Category category, const RecordingVerdict& verdict) {
    return std::any_of(verdict.segments.begin(), verdict.segments.end(),
                       [&](const auto& segment) { return segment.verdict.category == category; });
}

}  // namespace

drawing::Extent air_around(double low, double high) {
    const double air = high > low ? 0.06 * (high - low) : 1.0;
    return {low - air, high + air};
}

drawing::Line waveform_line(const sound::SoundAnalysis& analysis) {
    drawing::Line line;
    line.stroke = {drawing::accent, 0.5, drawing::Dash::solid};
    for (std::size_t k = 0; k < analysis.waveform.extents.size(); ++k) {
        const sound::SampleExtent& extent = analysis.waveform.extents[k];
        const double time = (static_cast<double>(k) + 0.5) * analysis.waveform.interval;
        line.x.insert(line.x.end(), {time, time});
        line.y.insert(line.y.end(), {extent.low, extent.high});
    }
    return line;
}

double highest_frequency(const signal::Spectrum& spectrum) {
    double whole = 0.0;
    for (const double density : spectrum.density)
        whole += density;
    double sum = 0.0;
    std::size_t k = 0;
    while (k + 1 < spectrum.density.size() && sum <= 0.999 * whole)
        sum += spectrum.density[k++];
    const double limit = spectrum.spacing * static_cast<double>(spectrum.density.size() - 1);
    return std::min(limit, std::max(2000.0, 2.0 * static_cast<double>(k) * spectrum.spacing));
}

drawing::ValueCells spectrogram_cells(const signal::Spectrogram& graph, double highest, PaperCells most) {
    const auto rows = std::min(graph.rows, static_cast<std::size_t>(std::ceil(highest / graph.row)));
    const std::size_t row_pool = (rows + most.rows - 1) / most.rows;
    const std::size_t column_pool = (graph.columns() + most.columns - 1) / most.columns;
    drawing::ValueCells cells;
    const double reference = signal::reference_of(graph.unit);
    for (std::size_t row = 0; row < rows; row += row_pool) {
        cells.y_edges.push_back(static_cast<double>(row) * graph.row);
        for (std::size_t column = 0; column < graph.columns(); column += column_pool) {
            double sum = 0.0;
            std::size_t count = 0;
            for (std::size_t c = column; c < std::min(column + column_pool, graph.columns()); ++c)
                for (std::size_t r = row; r < std::min(row + row_pool, rows); ++r, ++count)
                    sum += graph.density[c * graph.rows + r];
            cells.values.push_back(signal::level_of(std::max(sum / static_cast<double>(count), 1e-300), reference));
        }
    }
    cells.y_edges.push_back(static_cast<double>(rows) * graph.row);
    for (std::size_t column = 0; column < graph.columns(); column += column_pool)
        cells.x_edges.push_back(graph.from + static_cast<double>(column) * graph.column);
    cells.x_edges.push_back(graph.from + static_cast<double>(graph.columns()) * graph.column);
    const double top = std::ceil(*std::max_element(cells.values.begin(), cells.values.end()));
    cells.colours = {{top - spectrogram_depth, top}, drawing::AxisScale::linear};
    return cells;
}

std::vector<drawing::Layer> segment_layers(const RecordingVerdict& verdict, double duration) {
    std::vector<drawing::Layer> layers;
    for (std::size_t k = 0; k < classification::category_names.size(); ++k) {
        const auto category = static_cast<Category>(k);
        drawing::Boxes boxes;
        boxes.fill = category_fill(category);
        for (const classification::SoundSegment& segment : verdict.segments)
            if (segment.verdict.category == category)
                boxes.boxes.push_back({{segment.from, std::min(segment.to, duration)}, {0.0, 1.0}});
        if (!boxes.boxes.empty()) layers.emplace_back(std::move(boxes));
    }
    return layers;
}

std::vector<drawing::LegendEntry> category_legend(const std::vector<const RecordingVerdict*>& verdicts) {
    std::vector<drawing::LegendEntry> legend;
    for (std::size_t k = 0; k < classification::category_names.size(); ++k) {
        const auto category = static_cast<Category>(k);
        if (std::none_of(verdicts.begin(), verdicts.end(), [&](const auto* each) { return occurs(category, *each); }))
            continue;
        drawing::LegendEntry entry;
        entry.text = drawing::StyledText(classification::name(category));
        entry.sample = category_fill(category);
        legend.push_back(std::move(entry));
    }
    return legend;
}

}  // namespace stridor::pictures
