#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

/// What a chart can leave behind, beside its store and chart.toml.
enum class ChartFile {
    png,         // the pictures
    svg,         // likewise
    pdf,         // likewise
    csv,         // a row per cell; of a diagram the points of it, too
    boundaries,  // a row per vertex of the lines between the categories
    nc,          // netCDF-4
    zarr,        // a folder of the same content
};

inline constexpr std::array<std::string_view, 7> chart_file_names{"png",        "svg", "pdf", "csv",
                                                                  "boundaries", "nc",  "zarr"};

/// Cells above which a chart is large [1]: a CSV table of it is no use to anybody, and all figures take long.
inline constexpr std::size_t many_cells = 1'000'000;

/// What the user asks for, as texts; empty: what is usual.
struct ExportTexts {
    std::vector<std::string> files;    // names of files
    std::vector<std::string> figures;  // "category", "status", names of figures, or "all"
};

/// What is written of a chart.
struct ChartExports {
    std::vector<ChartFile> files;            // in their order above, each once
    std::vector<sweep::CellFigure> figures;  // columns of the tables beside the verdict; in the order of all of them
    std::string left_out;  // what is not written because the chart is large, a sentence; empty: nothing
};

/// What is written of a chart of this study. Usual are png, svg, csv, boundaries and nc, with all figures; of a chart
/// of more than `many_cells` no csv, and the figures that are drawn.
///
/// Throws `Error` (input) for a name that is none.
ChartExports chart_exports(const sweep::Study& study, const ExportTexts& texts);

/// Is it written?
bool holds(const ChartExports& exports, ChartFile file);

/// The endings of the pictures: ".png".
std::vector<std::string> picture_endings(const ChartExports& exports);

/// The names of what is written, store and chart.toml included: "chart.png".
std::vector<std::string> file_names(const ChartExports& exports, const sweep::Study& study);

/// Writes what is asked for of the tables of a chart into its folder: chart.csv, boundaries.csv, chart.nc and
/// chart.zarr. Throws `Error` (io).
void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports);

}  // namespace stridor::io
