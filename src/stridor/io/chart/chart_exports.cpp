#include "stridor/io/chart/chart_exports.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/boundaries.hpp"

#include <algorithm>

namespace stridor::io {

namespace {

std::vector<ChartFile> files_called(const std::vector<std::string>& names) {
    std::vector<ChartFile> files;
    for (const std::string& name : names) {
        const auto found = std::find(chart_file_names.begin(), chart_file_names.end(), name);
        if (found == chart_file_names.end())
            throw Error(ErrorKind::input, {"--files \"" + name + "\" is no file of a chart",
                                           "there are png, svg, pdf, csv, boundaries, nc and zarr",
                                           base::did_you_mean(name, chart_file_names)});
        files.push_back(static_cast<ChartFile>(found - chart_file_names.begin()));
    }
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

// in the order of all figures; of the verdict's variables, which every table has, none
std::vector<sweep::CellFigure> figures_called(const std::vector<std::string>& names) {
    std::vector<std::string_view> known{"category", "status", "all"};
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        known.push_back(figure.name);
    for (const std::string& name : names)
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw Error(ErrorKind::input,
                        {"--figures \"" + name + "\" is no figure of a cell",
                         "it is neither \"category\", \"status\", \"all\" nor a column of the results",
                         base::did_you_mean(name, known)});
    const auto is_asked = [&](std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    std::vector<sweep::CellFigure> figures;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        if (is_asked("all") || is_asked(figure.name)) figures.push_back(figure);
    return figures;
}

// "the chart has 2000000 cells: chart.csv is left out, and the tables hold category, status and what is drawn; ..."
std::string left_out_text(const sweep::Study& study, const ExportTexts& texts) {
    std::string what;
    std::string options;
    if (texts.files.empty()) {
        what = "chart.csv is left out";
        options = "--files";
    }
    if (texts.figures.empty()) {
        what += what.empty() ? "" : ", and ";
        what += "the tables hold only category, status and the figures that are drawn";
        options += options.empty() ? "--figures" : " and --figures";
    }
    if (what.empty()) return {};
    return "the chart has " + std::to_string(sweep::cell_count(study)) + " cells: " + what + "; " + options +
           (options.size() > 10 ? " ask" : " asks") + " for more";
}

bool is_picture(ChartFile file) {
    return file == ChartFile::png || file == ChartFile::svg || file == ChartFile::pdf;
}

}  // namespace

ChartExports chart_exports(const sweep::Study& study, const ExportTexts& texts) {
    using enum ChartFile;
    const bool is_large = sweep::cell_count(study) > many_cells;
    ChartExports exports{files_called(texts.files), figures_called(texts.figures), {}};
    if (texts.files.empty())
        exports.files = is_large ? std::vector{png, svg, boundaries, nc} : std::vector{png, svg, csv, boundaries, nc};
    if (texts.figures.empty())
        exports.figures = figures_called(is_large ? study.quantities : std::vector<std::string>{"all"});
    if (is_large) exports.left_out = left_out_text(study, texts);
    return exports;
}

bool holds(const ChartExports& exports, ChartFile file) {
    return std::find(exports.files.begin(), exports.files.end(), file) != exports.files.end();
}

std::vector<std::string> picture_endings(const ChartExports& exports) {
    std::vector<std::string> endings;
    for (const ChartFile file : exports.files)
        if (is_picture(file)) endings.push_back("." + std::string(chart_file_names[static_cast<std::size_t>(file)]));
    return endings;
}

std::vector<std::string> file_names(const ChartExports& exports, const sweep::Study& study) {
    std::vector<std::string> names;
    for (const ChartFile file : exports.files)
        names.push_back(file == ChartFile::boundaries
                            ? "boundaries.csv"
                            : "chart." + std::string(chart_file_names[static_cast<std::size_t>(file)]));
    names.insert(names.end(), {"chart.sqlite", "chart.toml"});
    if (sweep::has_one_axis(study) && holds(exports, ChartFile::csv)) names.emplace_back("diagram.csv");
    return names;
}

void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports) {
    if (holds(exports, ChartFile::csv)) {
        storage::PiecewiseFile table((folder / "chart.csv").string());
        const auto put = [&](std::string_view piece) { table.write(piece); };
        chart_csv(result, {"chart.toml", exports.figures}, put);
        table.commit();
    }
    if (holds(exports, ChartFile::boundaries))
        storage::write_file((folder / "boundaries.csv").string(),
                            boundaries_csv(result.study, sweep::boundaries(result)));
    if (holds(exports, ChartFile::nc))
        write_chart_netcdf((folder / "chart.nc").string(), result, {.figures = exports.figures});
    if (holds(exports, ChartFile::zarr)) write_chart_zarr((folder / "chart.zarr").string(), result, exports.figures);
}

}  // namespace stridor::io
