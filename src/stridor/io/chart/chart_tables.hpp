#pragma once

#include "stridor/io/chart/chart_exports.hpp"
#include "stridor/sweep/cell.hpp"

#include <filesystem>

namespace stridor::io {

/// Writes what is asked for of the tables of a chart into its folder: chart.csv, boundaries.csv, chart.nc and
/// chart.zarr. Throws `Error` (io).
void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports);

}  // namespace stridor::io
