// The tables and netCDF files that Stridor writes, read by the programs people read them with. The line that
// reads a file stands in the page of its format and is executed as it stands there; what it read is held
// against Stridor's own JSON.

#include "support/json_of.hpp"
#include "support/needs.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

using nlohmann::json;
using stridor::support::Finished;
using stridor::support::json_of;
using stridor::support::Launch;
using stridor::support::read_text;
using stridor::support::run;
using stridor::support::ScratchFolder;
using stridor::support::write_text;

namespace {

/// A program that reads tables.
struct Reader {
    std::string name;
    std::vector<std::string> command;  // that runs a script, whose name follows
    std::string needs;                 // a script that ends well where the program can do what is asked
    std::string packages;              // of Debian
};

const Reader pandas{"pandas", {"/usr/bin/python3"}, "import pandas\n", "python3-pandas"};
const Reader xarray{"xarray", {"/usr/bin/python3"}, "import netCDF4, xarray\n", "python3-xarray python3-netcdf4"};
const Reader xarray_zarr{"xarray", {"/usr/bin/python3"}, "import xarray, zarr\n", "python3-xarray python3-zarr"};
const Reader octave{"Octave", {"/usr/bin/octave-cli", "--no-init-file", "--quiet"}, "x = 1;\n", "octave"};
const Reader octave_netcdf{
    "Octave", {"/usr/bin/octave-cli", "--no-init-file", "--quiet"}, "pkg load netcdf\n", "octave-netcdf"};
const Reader r{"R", {"/usr/bin/Rscript", "--vanilla"}, "x <- 1\n", "r-base-core"};
const Reader r_netcdf{"R", {"/usr/bin/Rscript", "--vanilla"}, "library(ncdf4)\n", "r-cran-ncdf4"};

// pandas keeps 17 digits, zeros behind the point among them, unless it is told to take its time; R rounds the last bit
constexpr double tolerance = 1e-11;

/// What was computed once for all: a chart, a trace, and a trace converted.
class OtherPrograms : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new ScratchFolder(stridor::support::Medium::disk);
        write_text(*folder_ / "squeal.toml", stridor({"init", "squeal"}));
        write_text(*folder_ / "pair.toml", stridor({"init", "noise-chart"}));
        chart_ = json_of(stridor({"chart", "pair.toml", "--out", ".", "--json", "--set", "chart.x.points=4", "--set",
                                  "chart.y.points=3", "--set", "run.duration=0.1", "--set", "run.window=0.05",
                                  "--files", "csv,boundaries,nc,zarr"}));
        for (const char* file : {"trace.csv", "trace.nc"})
            stridor({"simulate", "squeal.toml", "--trace", file, "--trace-from", "0.2 s", "--trace-to", "0.21 s"});
        trace_ = json_of(stridor({"convert", "trace.csv", "--json"}));
        stridor({"convert", "trace.csv", "recording.csv"});
    }
    static void TearDownTestSuite() { delete std::exchange(folder_, nullptr); }

    static std::string stridor(const std::vector<std::string>& arguments) {
        const Finished finished = run(arguments, folder_->path());
        EXPECT_EQ(finished.exit_code, 0) << finished.err;
        return finished.out;
    }

    static bool can_run(const Reader& reader) { return executed(reader, reader.needs).exit_code == 0; }

    /// What a script prints: lines of a key and words. `line` must stand in the page as it is.
    static std::map<std::string, std::vector<std::string>> read(const Reader& reader, const std::string& page,
                                                                const std::string& line, const std::string& report) {
        const std::string text = read_text(std::filesystem::path(STRIDOR_SOURCE_DIR) / "docs/formats" / page);
        EXPECT_NE(text.find("`" + line + "`"), std::string::npos) << page << " does not say: " << line;
        const Finished finished = executed(reader, reader.needs + line + "\n" + report);
        EXPECT_EQ(finished.exit_code, 0) << finished.out << finished.err;
        std::map<std::string, std::vector<std::string>> found;
        std::istringstream lines(finished.out);
        for (std::string row; std::getline(lines, row);) {
            std::istringstream words(row);
            std::string key;
            words >> key;
            for (std::string word; words >> word;)
                found[key].push_back(word);
        }
        return found;
    }

    static void expect_chart(std::map<std::string, std::vector<std::string>> found) {
        expect_same(found["x"], [](std::size_t k) { return chart_["chart"]["x"]["values"][k % 4]; });
        expect_same(found["y"], [](std::size_t k) { return chart_["chart"]["y"]["values"][k / 4 % 3]; });
        for (const char* name : {"slip", "joint_rms"})
            expect_same(found[name], [&](std::size_t k) { return chart_["cells"][name][k]; });
    }

    static void expect_categories(const std::vector<std::string>& found) {
        const std::vector<std::string> categories = chart_["cells"]["category"];
        EXPECT_EQ(found, categories);
    }

    static void expect_flags(const std::vector<std::string>& found) {
        const std::vector<std::string> names{"none", "squeal", "squeak", "creak", "undecided"};
        ASSERT_EQ(found.size(), 24U);
        for (std::size_t k = 0; k < found.size(); ++k)
            EXPECT_EQ(names.at(static_cast<std::size_t>(std::stoul(found[k]))), chart_["cells"]["category"][k]);
    }

    /// Samples, and the largest magnitudes of the first channels.
    static void expect_trace(std::map<std::string, std::vector<std::string>> found) {
        EXPECT_EQ(found["samples"], std::vector<std::string>{std::to_string(trace_["frames"].get<int>())});
        ASSERT_EQ(found["peaks"].size(), 3U);
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(std::stod(found["peaks"][k]) / trace_["channels"][k]["peak"].get<double>(), 1.0, tolerance);
    }

    // 24 numbers
    template <typename Wanted>
    static void expect_same(const std::vector<std::string>& found, Wanted wanted) {
        ASSERT_EQ(found.size(), 24U);
        for (std::size_t k = 0; k < found.size(); ++k) {
            const double number = wanted(k);
            EXPECT_NEAR(std::stod(found[k]), number, tolerance * std::abs(number)) << k;
        }
    }

    static json chart_;
    static json trace_;
    static ScratchFolder* folder_;

private:
    static Finished executed(const Reader& reader, const std::string& script) {
        const std::filesystem::path path = *folder_ / "script";
        write_text(path, script);
        if (!std::filesystem::exists(reader.command[0])) return {};
        Launch launch{{reader.command.begin() + 1, reader.command.end()}, folder_->path(), {}, {}, {}, {}};
        launch.arguments.push_back(path.string());
        launch.program = reader.command[0];
        return run(launch);
    }
};

json OtherPrograms::chart_;
json OtherPrograms::trace_;
ScratchFolder* OtherPrograms::folder_ = nullptr;

const std::string python_chart = R"(
for name in ["x [N]", "y", "slip", "joint_rms [m/s]"]:
    assert chart[name].dtype == float, name
    print(name.split()[0], *map(repr, chart[name]))
print("category", *chart["category"])
print("level", chart["joint_level [dB re 1e-9 m/s]"].dtype)
)";
const std::string python_peaks = R"(
print("samples", len(table))
print("peaks", *[repr(abs(table[name]).max()) for name in table.columns[1:4]])
)";
const std::string octave_chart = R"(
names = {"x", "y", "slip", "joint_rms"}; columns = [1 2 6 20];
for k = 1:4, printf("%s", names{k}); printf(" %.17g", chart(:, columns(k))); printf("\n"); end
)";
const std::string octave_peaks = R"(
printf("samples %d\npeaks", rows(table)); printf(" %.17g", max(abs(table(:, 2:4)))); printf("\n");
)";
const std::string r_chart = R"(
for (name in c("x [N]", "y", "slip", "joint_rms [m/s]")) {
    stopifnot(is.numeric(chart[[name]]))
    cat(sub(" .*", "", name), sprintf("%.17g", chart[[name]]), "\n")
}
cat("category", chart$category, "\n")
)";
const std::string r_peaks = R"(
cat("samples", nrow(table), "\n")
cat("peaks", sprintf("%.17g", sapply(table[2:4], function(x) max(abs(x)))), "\n")
)";

}  // namespace

#define NEEDS(reader) STRIDOR_NEEDS(can_run(reader), (reader).name, (reader).packages)

TEST_F(OtherPrograms, PandasReadsCharts) {
    NEEDS(pandas);
    const auto found = read(pandas, "chart.md", R"(chart = pandas.read_csv("chart.csv", comment="#"))", python_chart);
    expect_chart(found);
    expect_categories(found.at("category"));
    EXPECT_EQ(found.at("level"), std::vector<std::string>{"float64"}) << "-inf is a number";
}

// of every table that Stridor writes, each column that is not of words
TEST_F(OtherPrograms, PandasReadsEveryTableAsNumbers) {
    NEEDS(pandas);
    stridor({"chart", "pair.toml", "--out", "starts", "--set", "chart.x.points=3", "--set", "chart.y.points=3", "--set",
             "run.duration=0.1", "--set", "run.window=0.05", "--set", "chart.starts=[\"rest\",\"sliding\"]"});
    stridor({"chart", "squeal.toml", "--x", "mu_d=0:0.9:4", "--out", "line", "--files", "csv,boundaries"});
    stridor({"simulate", "squeal.toml", "--history", "history.csv"});
    stridor({"evaluate", "pair.toml", "--set", "chart.x.points=2", "--set", "chart.y.points=2", "--perturb-every", "0",
             "--csv", "evaluate.csv"});
    stridor({"library", "add", "recording.csv", "--library", "noises.db", "--preload", "10 N"});
    write_text(*folder_ / "library.csv", stridor({"library", "list", "--csv", "--library", "noises.db"}));
    const auto found = read(pandas, "chart.md", R"(chart = pandas.read_csv("chart.csv", comment="#"))", R"(
words = """direction status category quiet_because source agreement start_rest start_sliding message reproduce
first second form state contact_states by_ear reason plane system parts materials operation recorded
denomination velocity_profile sensor calibration date author licence notes file format audio""".split()
for name in """chart.csv boundaries.csv starts/chart.csv line/chart.csv line/boundaries.csv line/diagram.csv history.csv
trace.csv recording.csv evaluate.csv library.csv""".split():
    table = pandas.read_csv(name, comment="#")
    assert len(table) > 0, name
    for column in table.columns:
        if column not in words and table[column].dtype.kind not in "fi":
            print("words", name, column)
    print("numbers", sum(table[column].dtype.kind in "fi" for column in table.columns if column not in words))
)");
    EXPECT_FALSE(found.contains("words")) << found.at("words")[0] << " " << found.at("words")[1];
}

TEST_F(OtherPrograms, OctaveReadsCharts) {
    NEEDS(octave);
    expect_chart(
        read(octave, "chart.md", R"(chart = dlmread("chart.csv", ",", 2, 0, "emptyvalue", NaN);)", octave_chart));
}

TEST_F(OtherPrograms, RReadsCharts) {
    NEEDS(r);
    const auto found =
        read(r, "chart.md", R"(chart <- read.csv("chart.csv", comment.char = "#", check.names = FALSE))", r_chart);
    expect_chart(found);
    expect_categories(found.at("category"));
}

TEST_F(OtherPrograms, PandasReadsTracesAndRecordings) {
    NEEDS(pandas);
    expect_trace(read(pandas, "results.md", R"(table = pandas.read_csv("trace.csv", comment="#"))", python_peaks));
    expect_trace(read(pandas, "signals.md", R"(table = pandas.read_csv("recording.csv", comment="#"))", python_peaks));
}

TEST_F(OtherPrograms, OctaveReadsTracesAndRecordings) {
    NEEDS(octave);
    expect_trace(read(octave, "results.md", R"(table = dlmread("trace.csv", ",", 2, 0);)", octave_peaks));
    expect_trace(read(octave, "signals.md", R"(table = dlmread("recording.csv", ",", 2, 0);)", octave_peaks));
}

TEST_F(OtherPrograms, RReadsTracesAndRecordings) {
    NEEDS(r);
    expect_trace(
        read(r, "results.md", R"(table <- read.csv("trace.csv", comment.char = "#", check.names = FALSE))", r_peaks));
    expect_trace(read(r, "signals.md", R"(table <- read.csv("recording.csv", comment.char = "#", check.names = FALSE))",
                      r_peaks));
}

TEST_F(OtherPrograms, XarrayReadsChartsAndTraces) {
    NEEDS(xarray);
    const auto chart = read(xarray, "chart.md", R"(chart = xarray.open_dataset("chart.nc"))", R"(
for name in ["category", "quiet_because", "status", "source"]:
    assert chart[name].dtype.kind == "i", name
assert chart.slip.attrs["units"] == "1"
print("category", *chart.category.values.ravel())
print("meanings", *chart.category.attrs["flag_meanings"].split())
)");
    expect_flags(chart.at("category"));
    EXPECT_EQ(chart.at("meanings").back(), "not_done");
    expect_trace(read(xarray, "results.md", R"(trace = xarray.open_dataset("trace.nc"))", R"(
assert trace.state.dtype.kind == "i" and trace.time.dtype == float
print("samples", trace.sizes["time"])
print("peaks", *[repr(float(abs(trace.displacement.sel(dof=dof)).max())) for dof in ["x1", "y1", "y2"]])
)"));
}

TEST_F(OtherPrograms, XarrayReadsZarr) {
    NEEDS(xarray_zarr);
    const auto chart = read(xarray_zarr, "chart.md",
                            R"(chart = xarray.open_dataset("chart.zarr", engine="zarr", consolidated=False))", R"(
for name in ["category", "quiet_because", "status", "source", "direction"]:
    assert chart[name].dtype.kind == "i", name
assert chart.joint_rms.dims == ("direction", "kinetic_friction", "preload") and chart.joint_rms.attrs["units"] == "m/s"
print("category", *chart.category.values.ravel())
print("slip", *map(repr, chart.slip.values.ravel().tolist()))
)");
    expect_flags(chart.at("category"));
    expect_same(chart.at("slip"), [&](std::size_t k) { return chart_["cells"]["slip"][k]; });
}

TEST_F(OtherPrograms, OctaveReadsNetcdf) {
    NEEDS(octave_netcdf);
    expect_flags(read(octave_netcdf, "chart.md", R"(category = ncread("chart.nc", "category");)", R"(
assert(isinteger(category)); printf("category"); printf(" %d", category); printf("\n");
)")
                     .at("category"));
    expect_trace(read(octave_netcdf, "results.md", R"(displacement = ncread("trace.nc", "displacement");)", R"(
printf("samples %d\npeaks", rows(displacement)); printf(" %.17g", max(abs(displacement))); printf("\n");
)"));
}

TEST_F(OtherPrograms, RReadsNetcdf) {
    NEEDS(r_netcdf);
    expect_flags(read(r_netcdf, "chart.md", R"(category <- ncvar_get(nc_open("chart.nc"), "category"))", R"(
stopifnot(is.integer(category))
cat("category", category, "\n")
)")
                     .at("category"));
    expect_trace(read(r_netcdf, "results.md", R"(displacement <- ncvar_get(nc_open("trace.nc"), "displacement"))", R"(
cat("samples", nrow(displacement), "\n")
cat("peaks", sprintf("%.17g", apply(abs(displacement), 2, max)), "\n")
)"));
}
