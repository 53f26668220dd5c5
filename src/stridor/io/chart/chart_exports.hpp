#pragma once

#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/study.hpp"

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

struct ChartExports;

/// A file that a chart can leave behind, beside its store and chart.toml.
struct ChartFile {
    std::string_view name;  // what --files calls it: "boundaries"
    std::string_view file;  // in the chart's folder: "boundaries.csv"
    bool is_usual;          // it is written unless the user says otherwise
    bool is_for_few;        // it is of no use for more than `many_cells`
    // writes it to a path, with the figures that are asked for; null of a picture, which `pictures` draws
    void (*write)(const sweep::SweepResult& result, const std::string& path, const ChartExports& exports);
};

/// Returns all of them: pictures first.
std::span<const ChartFile> chart_files();

/// Cells above which a chart is large [1]: a CSV table of it is useless, and all figures take long.
inline constexpr std::size_t many_cells = 1'000'000;

/// The user's request, as texts; empty: the usual files and figures.
struct ExportTexts {
    std::vector<std::string> files;    // names of files
    std::vector<std::string> figures;  // "category", "status", names of figures, or "all"
};

/// The files and figures to be written of a chart.
struct ChartExports {
    std::vector<ChartFile> files;            // in the order of `chart_files`, each once
    std::vector<sweep::CellFigure> figures;  // columns of the tables beside the verdict; in the order of all of them
    std::string left_out;                    // content left out because the chart is large, a sentence; empty: none
};

/// Returns what is written of a chart of this study. Usual are the usual files with all figures; of a chart of more
/// than `many_cells` those that are not for few, with the figures that are drawn.
///
/// Throws `Error` (input) for an unknown name.
ChartExports chart_exports(const sweep::Study& study, const ExportTexts& texts);

/// Says whether the file of that name is written.
bool holds(const ChartExports& exports, std::string_view name);

/// Returns the endings of the pictures: ".png".
std::vector<std::string> picture_endings(const ChartExports& exports);

/// Returns the names of what is written, store and chart.toml included: "chart.png".
std::vector<std::string> file_names(const ChartExports& exports, const sweep::Study& study);

/// Writes what is asked for into the chart's folder, but for pictures. Throws `Error` (io).
void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports);

}  // namespace stridor::io
