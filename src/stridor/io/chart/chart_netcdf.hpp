#pragma once

#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <string>

/// NetCDF-4 files after the CF conventions 1.10, written beside their name and renamed. The HDF5 library below crashes
/// where a write fails, so that its files are made in memory; a chart too large for that is written by a process of
/// its own, whose death is an error like any other. The same content gives the same bytes. Not for two threads at a
/// time: the library has global state. Throws `Error` (io).
namespace stridor::io {

/// A chart: dimensions (direction, y, x), the last two named after their parameters ("kinetic_friction", "preload";
/// with the section in front where two names would be alike), each with its coordinate variable.
///
/// Variables: category, status and source as bytes with flag_values and flag_meanings, every figure of
/// `sweep::cell_figures` as double, NaN where a cell is not done or was inferred; of a chart with starts agreement, and
/// start_verdict(start, direction, y, x). Global attributes: x and y (the parameters' keys), study
/// (`sweep::canonical_text`), study_hash, case (the chart as TOML, which can be run again).
///
/// One that takes more than `largest_in_memory` bytes, generously counted, is not made in memory: usual 32 MiB, some
/// 170,000 computed cells.
void write_chart_netcdf(const std::string& path, const sweep::SweepResult& result,
                        std::size_t largest_in_memory = std::size_t{32} << 20U);

}  // namespace stridor::io
