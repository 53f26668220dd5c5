#include "stridor/io/chart/chart_bands.hpp"

#include "invented_chart.hpp"
#include "io_support.hpp"

#include <gtest/gtest.h>

namespace stridor::io {
namespace {

TEST(ChartBands, HaveEachCellOnceInOrder) {
    const sweep::Study study = invented_study(3, 520);
    std::size_t next = 0;
    for (const ChartBand& band : bands_of(study)) {
        EXPECT_EQ(first_cell(study, band), next);
        EXPECT_LE(band.rows, chunk_points);
        next += cell_count(study, band);
    }
    EXPECT_EQ(next, sweep::cell_count(study));
    EXPECT_EQ(bands_of(study).size(), 6U) << "256, 256 and 8 rows in each direction";
}

// figure values by their place, gathered from parts of any size
std::vector<double> gathered(const sweep::SweepResult& result, const BandOptions& options, std::size_t& parts) {
    std::vector<double> values(options.figures.size() * result.cells.size());
    parts = 0;
    visit_bands(result, options, [&](const BandValues& part) {
        ++parts;
        const std::size_t cells = cell_count(result.study, part.band);
        for (std::size_t k = 0; k < part.figures.size(); ++k)
            values[(part.first_figure + k / cells) * result.cells.size() + first_cell(result.study, part.band) +
                   k % cells] = part.figures[k];
    });
    return values;
}

TEST(ChartBands, AreTheSameHoweverLittleMemoryThereIs) {
    const sweep::SweepResult chart = invented_chart(invented_study(5, 300));
    const std::span<const sweep::CellFigure> figures = sweep::cell_figures();
    std::size_t parts = 0;
    const std::vector<double> at_once = gathered(chart, {figures}, parts);
    EXPECT_EQ(parts, 4U);
    for (const std::size_t bytes : {std::size_t{1}, 7 * chunk_points * 5 * sizeof(double)}) {
        const std::vector<double> again = gathered(chart, {figures, bytes}, parts);
        EXPECT_EQ(parts, bytes == 1 ? 4 * figures.size() : 2 * ((figures.size() + 6) / 7 + 1));
        for (std::size_t k = 0; k < at_once.size(); ++k)
            ASSERT_TRUE(again[k] == at_once[k] || (std::isnan(again[k]) && std::isnan(at_once[k]))) << k;
    }
}

TEST(ChartBands, HaveTheStartsOnceBesideAnyFigures) {
    const sweep::SweepResult chart = chart_of_starts();
    for (const std::size_t figures : {std::size_t{0}, std::size_t{2}}) {
        std::vector<signed char> starts;
        visit_bands(chart, {sweep::cell_figures().first(figures), 1}, [&](const BandValues& part) {
            starts.insert(starts.end(), part.starts.begin(), part.starts.end());
        });
        ASSERT_EQ(starts.size(), 2 * chart.cells.size());
        EXPECT_EQ(starts[5], 0) << "from the first start, in the first direction";
        EXPECT_EQ(starts[chart.cells.size() / 2 + 5], 1);
    }
}

}  // namespace
}  // namespace stridor::io
