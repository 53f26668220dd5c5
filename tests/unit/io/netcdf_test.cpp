#include "invented_chart.hpp"
#include "io_support.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/chart/chart_netcdf.hpp"
#include "stridor/io/chart/toml_study.hpp"
#include "stridor/io/simulation/simulation_tables.hpp"
#include "stridor/storage/atomic_file.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>

namespace stridor::io {
namespace {

/// A file opened with the C library, for reading.
class Opened {
public:
    explicit Opened(const std::string& path) { check(nc_open(path.c_str(), NC_NOWRITE, &id_)); }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened() { nc_close(id_); }

    int variable(const std::string& name) const {
        int number = -1;
        check(nc_inq_varid(id_, name.c_str(), &number));
        return number;
    }
    std::string text(int variable, const std::string& name) const {
        std::size_t size = 0;
        check(nc_inq_attlen(id_, variable, name.c_str(), &size));
        std::string value(size, '\0');
        check(nc_get_att_text(id_, variable, name.c_str(), value.data()));
        return value;
    }
    std::string text(const std::string& variable_name, const std::string& name) const {
        return text(variable(variable_name), name);
    }
    std::string global(const std::string& name) const { return text(NC_GLOBAL, name); }

    // "direction kinetic_friction preload"
    std::string dimensions(const std::string& name) const {
        int count = 0;
        check(nc_inq_varndims(id_, variable(name), &count));
        std::vector<int> numbers(static_cast<std::size_t>(count));
        check(nc_inq_vardimid(id_, variable(name), numbers.data()));
        std::string names;
        for (const int number : numbers) {
            char dimension[NC_MAX_NAME + 1] = {};
            check(nc_inq_dimname(id_, number, dimension));
            names += (names.empty() ? "" : " ") + std::string(dimension);
        }
        return names;
    }
    std::vector<double> doubles(const std::string& name, std::size_t size) const {
        std::vector<double> values(size);
        check(nc_get_var_double(id_, variable(name), values.data()));
        return values;
    }
    std::vector<signed char> bytes(const std::string& name, std::size_t size) const {
        std::vector<signed char> values(size);
        check(nc_get_var_schar(id_, variable(name), values.data()));
        return values;
    }
    std::vector<signed char> byte_attribute(const std::string& variable_name, const std::string& name) const {
        std::size_t size = 0;
        check(nc_inq_attlen(id_, variable(variable_name), name.c_str(), &size));
        std::vector<signed char> values(size);
        check(nc_get_att_schar(id_, variable(variable_name), name.c_str(), values.data()));
        return values;
    }
    // of a variable of letters
    std::string letters(const std::string& name) const {
        int dimension = -1;
        std::size_t size = 0;
        check(nc_inq_vardimid(id_, variable(name), &dimension));
        check(nc_inq_dimlen(id_, dimension, &size));
        std::string text(size, '\0');
        check(nc_get_var_text(id_, variable(name), text.data()));
        return text;
    }
    // the boxes it is packed in, and how: "1 256 256 deflate 1 shuffle"
    std::string packing(const std::string& name) const {
        std::array<std::size_t, NC_MAX_VAR_DIMS> chunk{};
        int storage = 0, shuffle = 0, deflate = 0, level = 0, count = 0;
        check(nc_inq_varndims(id_, variable(name), &count));
        check(nc_inq_var_chunking(id_, variable(name), &storage, chunk.data()));
        check(nc_inq_var_deflate(id_, variable(name), &shuffle, &deflate, &level));
        std::string text;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
            text += std::to_string(chunk[k]) + " ";
        return text + (deflate != 0 ? "deflate " + std::to_string(level) : "") + (shuffle != 0 ? " shuffle" : "");
    }
    bool has(const std::string& name) const {
        int number = -1;
        return nc_inq_varid(id_, name.c_str(), &number) == NC_NOERR;
    }
    bool has_attribute(const std::string& variable_name, const std::string& name) const {
        int number = 0;
        return nc_inq_attid(id_, variable(variable_name), name.c_str(), &number) == NC_NOERR;
    }
    std::vector<std::string> words(const std::string& name, std::size_t size) const {
        std::vector<char*> pointers(size);
        check(nc_get_var_string(id_, variable(name), pointers.data()));
        std::vector<std::string> values(pointers.begin(), pointers.end());
        check(nc_free_string(size, pointers.data()));
        return values;
    }

private:
    static void check(int code) { EXPECT_EQ(code, NC_NOERR) << nc_strerror(code); }
    int id_ = -1;
};

// equal bits, or both NaN
void expect_same(const std::vector<double>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_TRUE(found[k] == expected[k] || (std::isnan(found[k]) && std::isnan(expected[k]))) << k;
}

TEST(ChartNetcdf, HoldsEveryFigureOfEveryCell) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = small_chart();
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    for (const sweep::CellFigure& figure : sweep::cell_figures()) {
        const std::string name(figure.name);
        std::vector<double> expected;
        for (const sweep::Cell& cell : small_cells())
            expected.push_back(figure_of(cell, figure));
        expect_same(file.doubles(name, chart.cells.size()), expected);
        EXPECT_EQ(file.text(name, "units"), figure.unit);
        EXPECT_EQ(file.text(name, "long_name"), figure.sentence);
        EXPECT_EQ(file.dimensions(name), "direction kinetic_friction preload");
    }
}

TEST(ChartNetcdf, NamesItsAxesByTheirParameters) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = small_chart();
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    std::vector<double> preloads;
    for (int ix = 0; ix < chart.study.x.points; ++ix)
        preloads.push_back(sweep::value_at(chart.study.x, ix));
    expect_same(file.doubles("preload", preloads.size()), preloads);
    EXPECT_EQ(file.text("preload", "units"), "N");
    EXPECT_EQ(file.text("preload", "axis"), "X");
    EXPECT_EQ(file.dimensions("preload"), "preload");
    EXPECT_EQ(file.words("direction", 2), (std::vector<std::string>{"going", "coming"}));
    EXPECT_EQ(file.global("x"), "contact.preload");
    EXPECT_EQ(file.global("y"), "contact.kinetic_friction");
}

TEST(ChartNetcdf, KeepsCategoriesAsFlags) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = small_chart();
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    const std::vector<signed char> categories = file.bytes("category", chart.cells.size());
    for (std::size_t index = 0; index < chart.cells.size(); ++index) {
        const bool is_done = chart.cells[index].status == sweep::Status::done;
        EXPECT_EQ(categories[index], is_done ? static_cast<int>(chart.cells[index].category) : -1);
    }
    EXPECT_EQ(file.text("category", "flag_meanings"), "none squeal squeak creak undecided not_done");
    EXPECT_EQ(file.byte_attribute("category", "flag_values"), (std::vector<signed char>{0, 1, 2, 3, 4, -1}));
    for (const char* name : {"category", "quiet_because", "status", "source"})
        EXPECT_FALSE(file.has_attribute(name, "_FillValue")) << name << ": xarray would read numbers with a point";
    EXPECT_EQ(file.text("status", "flag_meanings"), "done invalid step_limit diverged failed");
    EXPECT_EQ(file.bytes("status", chart.cells.size())[1], 1);
}

TEST(ChartNetcdf, TellsComputedCellsFromInferredOnes) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = refined_chart();
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    EXPECT_EQ(file.text("source", "flag_meanings"), "computed inferred");
    const std::vector<signed char> sources = file.bytes("source", chart.cells.size());
    EXPECT_EQ(sources[0], 0);
    EXPECT_EQ(sources[1], 1);
    std::vector<double> slips;
    for (std::size_t index = 0; index < chart.cells.size(); ++index)
        slips.push_back(sweep::is_inferred(chart, index) ? sweep::Cell::unknown
                                                         : figure_of(sweep::computed_cell(chart, index), "slip"));
    expect_same(file.doubles("slip", chart.cells.size()), slips);
}

TEST(ChartNetcdf, KeepsTheVerdictOfEachStart) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = chart_of_starts();
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    const std::size_t size = chart.cells.size();
    EXPECT_EQ(file.words("start", 2), (std::vector<std::string>{"rest", "sliding"}));
    EXPECT_EQ(file.dimensions("start_verdict"), "start direction kinetic_friction preload");
    EXPECT_EQ(file.text("start_verdict", "flag_meanings"),
              "none squeal squeak creak undecided invalid step_limit diverged failed locks inferred");
    const std::vector<signed char> verdicts = file.bytes("start_verdict", 2 * size);
    EXPECT_EQ(verdicts[5], 0);
    EXPECT_EQ(verdicts[size + 5], 1);
    EXPECT_EQ(verdicts[size + 6], 5);
    EXPECT_EQ(file.bytes("agreement", size)[5], 2);
    EXPECT_EQ(file.text("agreement", "flag_meanings"), "agree differ quiet_unless_disturbed");
}

TEST(ChartNetcdf, CarriesTheStudyThatMadeIt) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = small_chart();
    const std::string canonical = sweep::canonical_text(chart.study);
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    EXPECT_EQ(file.global("Conventions"), "CF-1.10");
    EXPECT_EQ(file.global("source"),
              "stridor " + std::string(base::version()) + " (" + std::string(base::commit()) + ")");
    EXPECT_EQ(file.global("study"), canonical);
    EXPECT_EQ(file.global("study_hash"), base::hash_text(canonical));
    const sweep::Study again = read_study(TomlSource{file.global("case"), "attribute", {}});
    EXPECT_EQ(sweep::canonical_text(again), canonical);
}

// HDF5 refuses attributes of 64 KiB: after all computing a chart of a part with its matrices had no file
TEST(ChartNetcdf, HoldsALongTextAsAVariable) {
    const ScratchFolder scratch;
    sweep::SweepResult chart = small_chart();
    chart.study.base.title = std::string(100'000, 'x');
    const std::string text = study_toml(chart.study, {.comments = Comments::none, .heading = ""});
    write_chart_netcdf((scratch / "chart.nc").string(), chart);
    write_chart_zarr((scratch / "chart.zarr").string(), chart);
    const Opened file((scratch / "chart.nc").string());
    EXPECT_EQ(file.letters("case"), text);
    EXPECT_EQ(file.text("case", "_Encoding"), "utf-8");
    EXPECT_EQ(file.dimensions("case"), "case_length");
    EXPECT_EQ(file.global("study"), sweep::canonical_text(chart.study));
    const Opened zarr("file://" + (scratch / "chart.zarr").string() + "#mode=zarr,file");
    EXPECT_EQ(zarr.global("case"), text);
}

TEST(ChartNetcdf, KeepsNamesApartThatWouldBeAlike) {
    const ScratchFolder scratch;
    sweep::SweepResult chart = small_chart();
    chart.study.base = parameters::paper_case(parameters::PaperCase::squeal);
    chart.study.x.parameter = "drive.frequency";  // there is a figure "frequency"
    chart.study.y.parameter = "joint.mass";
    write_chart_netcdf((scratch / "a.nc").string(), chart);
    EXPECT_EQ(Opened((scratch / "a.nc").string()).dimensions("category"), "direction mass drive_frequency");
    chart.study.x.parameter = "plate.mass";
    write_chart_netcdf((scratch / "b.nc").string(), chart);
    EXPECT_EQ(Opened((scratch / "b.nc").string()).dimensions("category"), "direction joint_mass plate_mass");
}

TEST(ChartNetcdf, HasTheSameBytesForTheSameChart) {
    const ScratchFolder scratch;
    write_chart_netcdf((scratch / "a.nc").string(), small_chart());
    write_chart_netcdf((scratch / "b.nc").string(), small_chart());
    EXPECT_EQ(storage::read_file((scratch / "a.nc").string()), storage::read_file((scratch / "b.nc").string()));
}

// rows and columns that fill boxes, and some that do not
TEST(ChartNetcdf, HoldsChartsOfManyBoxes) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = invented_chart(invented_study(300, 260));
    const std::string path = (scratch / "chart.nc").string();
    const std::vector<sweep::CellFigure> figures{sweep::cell_figure("slip"), sweep::cell_figure("proof_time")};
    for (const std::size_t largest_in_memory : {std::size_t{1} << 30U, std::size_t{0}}) {
        write_chart_netcdf(path, chart, {figures, largest_in_memory});
        const Opened file(path);
        for (const sweep::CellFigure& figure : figures) {
            std::vector<double> expected;
            for (std::size_t index = 0; index < chart.cells.size(); ++index)
                expected.push_back(figure_of(invented_cell(chart.study, index), figure));
            expect_same(file.doubles(std::string(figure.name), chart.cells.size()), expected);
        }
        const std::vector<signed char> categories = file.bytes("category", chart.cells.size());
        for (std::size_t index = 0; index < chart.cells.size(); ++index)
            ASSERT_EQ(categories[index], chart.cells[index].status == sweep::Status::done
                                             ? static_cast<int>(chart.cells[index].category)
                                             : -1);
        for (const char* name : {"slip", "proof_time", "category", "quiet_because", "status", "source"})
            EXPECT_EQ(file.packing(name), "1 256 256 deflate 1 shuffle") << name;
        EXPECT_FALSE(file.has("frequency")) << "not asked for";
    }
}

TEST(ChartNetcdf, HasTheSameBytesInEveryRun) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = invented_chart(invented_study(300, 260));
    const std::string first = (scratch / "first.nc").string();
    const std::string second = (scratch / "second.nc").string();
    for (const std::string& path : {first, second})
        write_chart_netcdf(path, chart, {sweep::cell_figures().first(3), 0});
    EXPECT_EQ(storage::read_file(first), storage::read_file(second));
}

// a chart too large for the memory is written by a process of its own: whoever reads it sees no difference
TEST(ChartNetcdf, IsTheSameWrittenApart) {
    const ScratchFolder scratch;
    for (const sweep::SweepResult& chart : {small_chart(), refined_chart(), chart_of_starts()}) {
        const std::string in_memory = (scratch / "memory.nc").string();
        const std::string apart = (scratch / "apart.nc").string();
        write_chart_netcdf(in_memory, chart);
        write_chart_netcdf(apart, chart, {.largest_in_memory = 0});
        const Opened first(in_memory);
        const Opened second(apart);
        const std::size_t size = chart.cells.size();
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            expect_same(second.doubles(std::string(figure.name), size), first.doubles(std::string(figure.name), size));
        for (const char* name : {"category", "status", "source"})
            EXPECT_EQ(second.bytes(name, size), first.bytes(name, size));
        if (!chart.study.starts.empty()) {
            EXPECT_EQ(second.bytes("start_verdict", 2 * size), first.bytes("start_verdict", 2 * size));
        }
        for (const char* name : {"study", "study_hash", "case", "schema"})
            EXPECT_EQ(second.global(name), first.global(name));
        EXPECT_EQ(scratch.files(), 2);
    }
}

TEST(ChartZarr, HoldsWhatTheNetcdfFileHolds) {
    const ScratchFolder scratch;
    // characters with a meaning in addresses
    const std::filesystem::path odd = scratch / "a #b%20c";
    std::filesystem::create_directory(odd);
    sweep::SweepResult large = invented_chart(invented_study(300, 260));
    large.study.base.title = "Gummi \"quietscht\" bei 5 °C [μ]";
    for (const sweep::SweepResult& chart : {large, refined_chart(), chart_of_starts()}) {
        write_chart_netcdf((scratch / "chart.nc").string(), chart);
        write_chart_zarr((odd / "chart.zarr").string(), chart);
        std::filesystem::rename(odd / "chart.zarr", scratch / "chart.zarr");
        const Opened first((scratch / "chart.nc").string());
        const Opened second("file://" + (scratch / "chart.zarr").string() + "#mode=zarr,file");
        const std::size_t size = chart.cells.size();
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            expect_same(second.doubles(std::string(figure.name), size), first.doubles(std::string(figure.name), size));
        for (const char* name : {"category", "quiet_because", "status", "source"}) {
            EXPECT_EQ(second.bytes(name, size), first.bytes(name, size));
            EXPECT_EQ(second.text(name, "flag_meanings"), first.text(name, "flag_meanings"));
        }
        if (!chart.study.starts.empty()) {
            EXPECT_EQ(second.bytes("start_verdict", 2 * size), first.bytes("start_verdict", 2 * size));
            EXPECT_EQ(second.text("start", "flag_meanings"), "rest sliding");
        }
        EXPECT_EQ(second.bytes("direction", 2), (std::vector<signed char>{0, 1}));
        EXPECT_EQ(second.text("direction", "flag_meanings"), "going coming");
        EXPECT_EQ(second.dimensions("slip"), first.dimensions("slip"));
        for (const char* name : {"title", "study", "study_hash", "case", "schema"})
            EXPECT_EQ(second.global(name), first.global(name));
        std::filesystem::remove_all(scratch / "chart.zarr");
    }
}

// larger than what the library is let to hold at a time: it is closed and opened in between
TEST(ChartZarr, HoldsALargeChartToo) {
    const ScratchFolder scratch;
    const sweep::SweepResult chart = invented_chart(invented_study(400, 300));
    const std::vector<sweep::CellFigure> figures(sweep::cell_figures().begin(), sweep::cell_figures().begin() + 12);
    write_chart_zarr((scratch / "chart.zarr").string(), chart, figures);
    const Opened file("file://" + (scratch / "chart.zarr").string() + "#mode=zarr,file");
    for (const std::size_t k : {std::size_t{0}, figures.size() - 1}) {
        const std::vector<double> values = file.doubles(std::string(figures[k].name), chart.cells.size());
        for (std::size_t index = 0; index < values.size(); ++index) {
            const double wanted = figure_of(invented_cell(chart.study, index), figures[k]);
            ASSERT_TRUE(values[index] == wanted || (std::isnan(values[index]) && std::isnan(wanted))) << index;
        }
        EXPECT_EQ(file.text(std::string(figures[k].name), "units"), figures[k].unit);
    }
    const std::vector<signed char> categories = file.bytes("category", chart.cells.size());
    for (std::size_t index = 0; index < categories.size(); ++index)
        ASSERT_EQ(categories[index] == -1, chart.cells[index].status != sweep::Status::done) << index;
    EXPECT_EQ(file.global("study"), sweep::canonical_text(chart.study));
}

TEST(ChartZarr, HasTheSameBytesInEveryRunAndReplacesTheFormer) {
    const ScratchFolder scratch;
    const auto write_and_read = [&] {
        write_chart_zarr((scratch / "chart.zarr").string(), invented_chart(invented_study(300, 260)),
                         sweep::cell_figures().first(2));
        std::map<std::string, std::string> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(scratch / "chart.zarr"))
            if (entry.is_regular_file()) files[entry.path().string()] = storage::read_file(entry.path().string());
        return files;
    };
    const std::map<std::string, std::string> first = write_and_read();
    EXPECT_TRUE(first.contains((scratch / "chart.zarr/slip/1.1.1").string()));
    write_chart_zarr((scratch / "chart.zarr").string(), small_chart());
    EXPECT_EQ(write_and_read(), first);
    EXPECT_EQ(scratch.files(), 1);
}

TEST(ChartNetcdf, SaysWhyItCannotBeWritten) {
    const ScratchFolder scratch;
    const auto error = error_of([&] { write_chart_netcdf((scratch / "no/chart.nc").string(), small_chart()); });
    ASSERT_TRUE(error);
    EXPECT_EQ(error->kind(), ErrorKind::io);
}

TEST(TraceNetcdf, HoldsTraceAndHistory) {
    const ScratchFolder scratch;
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    record::Record record;
    record.trace = record::empty_trace(3);
    record.trace.time = {0.0, 0.5};
    record.trace.displacement = record.trace.velocity = record.trace.acceleration = {{1, 2}, {3, 4}, {5, 6}};
    record.trace.surface_velocity = {7, 8};
    record.trace.contacts = {{{7, 8}, {7, 8}, {7, 8}, {model::ContactState::slip, model::ContactState::separation}}};
    record.histories = {{{model::ContactState::stick, 0.0, 0.25, 0.1, -0.2}}};
    write_trace_netcdf((scratch / "t.nc").string(), c, record);
    const Opened file((scratch / "t.nc").string());
    EXPECT_EQ(file.dimensions("velocity"), "dof time");
    EXPECT_EQ(file.words("dof", 3), (std::vector<std::string>{"x1", "y1", "y2"}));
    EXPECT_EQ(file.doubles("velocity", 6), (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(file.bytes("state", 2), (std::vector<signed char>{0, 2}));
    EXPECT_EQ(file.text("state", "flag_meanings"), "slip stick separation");
    EXPECT_EQ(file.doubles("interval_gap_velocity", 1), std::vector<double>{-0.2});
    EXPECT_EQ(file.bytes("interval_state", 1), std::vector<signed char>{1});
    EXPECT_EQ(file.dimensions("normal_force"), "time");
}

TEST(TraceNetcdf, HasADimensionForSeveralContacts) {
    const ScratchFolder scratch;
    const parameters::Case c = parameters::paper_case(parameters::PaperCase::squeal);
    using model::ContactState;
    record::Record record;
    record.trace = record::empty_trace(4, 2);
    const std::array<double, 4> still{};
    for (const double time : {0.0, 0.5}) {
        const std::array contacts{record::ContactSample{1.0 + time, 0.0, 0.0, ContactState::slip},
                                  record::ContactSample{3.0 + time, 0.0, 0.0, ContactState::stick}};
        record::append(record.trace, {time, still, still, still, 0.1, contacts});
    }
    record.histories = {{{ContactState::slip, 0.0, 0.5}},
                        {{ContactState::stick, 0.0, 0.25}, {ContactState::slip, 0.25, 0.5}}};
    write_trace_netcdf((scratch / "t.nc").string(), c, record);
    const Opened file((scratch / "t.nc").string());
    EXPECT_EQ(file.dimensions("normal_force"), "contact time");
    EXPECT_EQ(file.doubles("normal_force", 4), (std::vector<double>{1.0, 1.5, 3.0, 3.5}));
    EXPECT_EQ(file.bytes("state", 4), (std::vector<signed char>{0, 0, 1, 1}));
    EXPECT_EQ(file.doubles("interval_contact", 3), (std::vector<double>{1.0, 2.0, 2.0}));
}

}  // namespace
}  // namespace stridor::io
