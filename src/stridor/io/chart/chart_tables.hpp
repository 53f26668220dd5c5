#pragma once

#include "stridor/sweep/cell.hpp"

#include <filesystem>

namespace stridor::io {

/// Writes the tables of a chart into its folder: chart.csv, boundaries.csv and chart.nc. Throws `Error` (io).
void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder);

}  // namespace stridor::io
