#include "stridor/io/chart/chart_bands.hpp"

#include "stridor/sweep/starts.hpp"

#include <algorithm>

namespace stridor::io {

namespace {

std::size_t columns_of(const sweep::Study& study) {
    return static_cast<std::size_t>(study.x.points);
}

// reads some figures of a band, and the verdicts of the starts where there is room for them
void fill(BandValues& values, const sweep::SweepResult& result, std::span<const sweep::CellFigure> figures) {
    const std::size_t first = first_cell(result.study, values.band);
    const std::size_t cells = cell_count(result.study, values.band);
    result.computed->visit_figures(first, first + cells, figures, [&](const sweep::IndexedCell& computed) {
        const std::size_t place = computed.index - first;
        for (std::size_t k = 0; k < figures.size(); ++k)
            values.figures[k * cells + place] = figure_of(computed.cell, figures[k]);
        if (values.starts.empty()) return;
        for (std::size_t start = 0; start < computed.cell.starts.size(); ++start)
            values.starts[start * cells + place] =
                static_cast<signed char>(sweep::number_of(computed.cell.starts[start]));
    });
}

}  // namespace

std::vector<ChartBand> bands_of(const sweep::Study& study) {
    std::vector<ChartBand> bands;
    const auto rows = static_cast<std::size_t>(study.y.points);
    for (std::size_t direction = 0; direction < study.directions.size(); ++direction)
        for (std::size_t row = 0; row < rows; row += chunk_points)
            bands.push_back({direction, row, std::min(chunk_points, rows - row)});
    return bands;
}

std::size_t first_cell(const sweep::Study& study, const ChartBand& band) {
    return (band.direction * static_cast<std::size_t>(study.y.points) + band.row) * columns_of(study);
}

std::size_t cell_count(const sweep::Study& study, const ChartBand& band) {
    return band.rows * columns_of(study);
}

void visit_bands(const sweep::SweepResult& result, const BandOptions& options,
                 const std::function<void(const BandValues&)>& take) {
    const sweep::Study& study = result.study;
    BandValues values;
    for (const ChartBand& band : bands_of(study)) {
        const std::size_t cells = cell_count(study, band);
        const std::size_t at_once = std::max<std::size_t>(1, options.most_bytes / (cells * sizeof(double)));
        std::size_t first = 0;
        do {
            const std::size_t count = std::min(at_once, options.figures.size() - first);
            values.band = band;
            values.first_figure = first;
            values.figures.assign(count * cells, sweep::Cell::unknown);
            values.starts.assign(first == 0 ? study.starts.size() * cells : 0, -1);
            if (count > 0 || !values.starts.empty()) fill(values, result, options.figures.subspan(first, count));
            take(values);
            first += count;
        } while (first < options.figures.size());
    }
}

}  // namespace stridor::io
