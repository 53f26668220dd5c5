#include "stridor/io/chart/chart_exports.hpp"

#include "stridor/base/error.hpp"
#include "stridor/base/field_table.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/chart/chart_csv.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/boundaries.hpp"

#include <algorithm>
#include <array>

namespace stridor::io {

namespace {

void write_csv(const sweep::SweepResult& result, const std::string& path, const ChartExports& exports) {
    storage::PiecewiseFile table(path);
    const auto put = [&](std::string_view piece) { table.write(piece); };
    chart_csv(result, {"chart.toml", exports.figures}, put);
    table.commit();
}

void write_boundaries(const sweep::SweepResult& result, const std::string& path, const ChartExports& /*exports*/) {
    storage::write_file(path, boundaries_csv(result.study, sweep::boundaries(result)));
}

void write_netcdf(const sweep::SweepResult& result, const std::string& path, const ChartExports& exports) {
    write_chart_netcdf(path, result, {.figures = exports.figures});
}

void write_zarr(const sweep::SweepResult& result, const std::string& path, const ChartExports& exports) {
    write_chart_zarr(path, result, exports.figures);
}

constexpr std::array<ChartFile, 7> all_files{{
    {"png", "chart.png", true, false, nullptr},
    {"svg", "chart.svg", true, false, nullptr},
    {"pdf", "chart.pdf", false, false, nullptr},
    {"csv", "chart.csv", true, true, write_csv},
    {"boundaries", "boundaries.csv", true, false, write_boundaries},
    {"nc", "chart.nc", true, false, write_netcdf},
    {"zarr", "chart.zarr", false, false, write_zarr},
}};

std::vector<ChartFile> files_called(const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const ChartFile& file : all_files)
        known.emplace_back(file.name);
    for (const std::string& name : names)
        if (base::find_named(all_files, name) == nullptr)
            throw Error(ErrorKind::input, {"--files \"" + name + "\" is no file of a chart",
                                           "there are " + base::listed(known), base::did_you_mean(name, known)});
    std::vector<ChartFile> files;
    for (const ChartFile& file : all_files)
        if (std::find(names.begin(), names.end(), file.name) != names.end()) files.push_back(file);
    return files;
}

std::vector<ChartFile> usual_files(bool is_large) {
    std::vector<ChartFile> files;
    for (const ChartFile& file : all_files)
        if (file.is_usual && !(is_large && file.is_for_few)) files.push_back(file);
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

}  // namespace

std::span<const ChartFile> chart_files() {
    return all_files;
}

ChartExports chart_exports(const sweep::Study& study, const ExportTexts& texts) {
    const bool is_large = sweep::cell_count(study) > many_cells;
    ChartExports exports{files_called(texts.files), figures_called(texts.figures), {}};
    if (texts.files.empty()) exports.files = usual_files(is_large);
    if (texts.figures.empty())
        exports.figures = figures_called(is_large ? study.quantities : std::vector<std::string>{"all"});
    if (is_large) exports.left_out = left_out_text(study, texts);
    return exports;
}

bool holds(const ChartExports& exports, std::string_view name) {
    return base::find_named(exports.files, name) != nullptr;
}

std::vector<std::string> picture_endings(const ChartExports& exports) {
    std::vector<std::string> endings;
    for (const ChartFile& file : exports.files)
        if (file.write == nullptr) endings.push_back("." + std::string(file.name));
    return endings;
}

std::vector<std::string> file_names(const ChartExports& exports, const sweep::Study& study) {
    std::vector<std::string> names;
    for (const ChartFile& file : exports.files)
        names.emplace_back(file.file);
    names.insert(names.end(), {"chart.sqlite", "chart.toml"});
    if (sweep::has_one_axis(study) && holds(exports, "csv")) names.emplace_back("diagram.csv");
    return names;
}

void write_chart_tables(const sweep::SweepResult& result, const std::filesystem::path& folder,
                        const ChartExports& exports) {
    for (const ChartFile& file : exports.files)
        if (file.write != nullptr) file.write(result, (folder / file.file).string(), exports);
}

}  // namespace stridor::io
