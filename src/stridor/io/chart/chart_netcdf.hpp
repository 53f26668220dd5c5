#pragma once

#include "stridor/sweep/cell.hpp"

#include <cstddef>
#include <span>
#include <string>

/// NetCDF-4 files after the CF conventions 1.10, written beside their name and renamed. The HDF5 library crashes if a
/// write fails. So files are made in memory; a chart too large for that is written by a process of its own, whose death
/// is an error like any other. The same content gives the same bytes. Only one thread at a time may use it: the library
/// has global state. Throws `Error` (io).
namespace stridor::io {

/// The exported content of a chart, and how it is written.
struct NetcdfOptions {
    std::span<const sweep::CellFigure> figures = sweep::cell_figures();
    // [bytes] a file that would need more, at a high estimate, is not made in memory: usual 32 MiB, some 170,000
    // computed cells with all figures
    std::size_t largest_in_memory = std::size_t{32} << 20U;
};

/// Writes a chart: dimensions (direction, y, x), the last two named after their parameters ("kinetic_friction",
/// "preload"; with the section in front if two names would be equal), each with its coordinate variable.
///
/// Variables: category, quiet_because, status and source as bytes with flag_values and flag_meanings, figures as
/// double, NaN where a cell is not done or was inferred; of a chart with starts agreement, and start_verdict(start,
/// direction, y, x). All of them are packed in boxes of 256 by 256 points (deflate 1, shuffled). Global attributes: x
/// and y (the parameters' keys), study (`sweep::canonical_text`), study_hash, case (the chart as TOML, which can be
/// run again).
///
/// The computed cells are read band by band (chart_bands.hpp); only `SweepResult::cells` is in memory as a whole.
void write_chart_netcdf(const std::string& path, const sweep::SweepResult& result, const NetcdfOptions& options = {});

/// Writes a chart as a Zarr folder with these dimensions and variables, in boxes of the same shape, each an unpacked
/// file; direction and start are numbers with flag_meanings there. An existing folder is removed when the new one is
/// whole.
void write_chart_zarr(const std::string& path, const sweep::SweepResult& result,
                      std::span<const sweep::CellFigure> figures = sweep::cell_figures());

}  // namespace stridor::io
