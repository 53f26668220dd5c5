#include "stridor/io/chart/chart_netcdf.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/base/separate_process.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/io/netcdf_library.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Field;

// a coordinate's name must be its own among the variables: drive.frequency beside the figure "frequency"
std::string coordinate_name(const sweep::Axis& axis, const sweep::Axis& other) {
    const std::string& key = axis.parameter;
    const auto underscored = [](std::string name) {
        std::replace(name.begin(), name.end(), '.', '_');
        return name;
    };
    const auto short_name = [&](const std::string& full) { return underscored(full.substr(full.find('.') + 1)); };
    const std::string name = short_name(key);
    constexpr std::array<std::string_view, 8> fixed{"direction", "category",  "quiet_because", "status",
                                                    "source",    "agreement", "start",         "start_verdict"};
    const bool is_taken = name == short_name(other.parameter) || sweep::find_cell_figure(name) != nullptr ||
                          std::find(fixed.begin(), fixed.end(), name) != fixed.end();
    return is_taken ? underscored(key) : name;
}

// the conventions spell the degree out
std::string_view units_of(const Field& field) {
    const std::string_view unit = parameters::unit_of(field);
    return unit == "deg" ? "degree" : unit;
}

int put_axis(NetcdfDataset& file, const std::string& name, const sweep::Axis& axis, const std::string& letter) {
    const int dimension = file.dimension(name, static_cast<std::size_t>(axis.points));
    std::vector<double> values;
    for (int index = 0; index < axis.points; ++index)
        values.push_back(sweep::value_at(axis, index));
    const Field& field = *parameters::field_of(axis.parameter);
    const int variable =
        file.doubles(name, std::array{dimension}, values, {units_of(field), field.sentence, MissingNumbers::no});
    file.attribute(variable, "axis", letter);
    file.attribute(variable, "scale", std::string(sweep::scale_names[static_cast<std::size_t>(axis.scale)]));
    file.attribute(letter == "X" ? "x" : "y", axis.parameter);
    return dimension;
}

int put_directions(NetcdfDataset& file, const sweep::Study& study) {
    std::vector<std::string> names;
    for (const parameters::Direction direction : study.directions)
        names.emplace_back(parameters::direction_names[static_cast<std::size_t>(direction)]);
    const int dimension = file.dimension("direction", names.size());
    file.words("direction", std::array{dimension}, names,
               {"", "which way the plate moves: going is V > 0, coming V < 0"});
    return dimension;
}

// the numbers of some verdict of all cells, as bytes
template <typename NumberOf>
std::vector<signed char> numbers_of(const sweep::SweepResult& result, NumberOf number_of) {
    std::vector<signed char> numbers;
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        numbers.push_back(static_cast<signed char>(number_of(index)));
    return numbers;
}

void put_verdicts(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const int> dimensions) {
    const auto category = [&](std::size_t index) {
        const sweep::CellVerdict& cell = result.cells[index];
        return cell.status == sweep::Status::done ? static_cast<int>(cell.category) : -1;
    };
    file.flags("category", dimensions, numbers_of(result, category), classification::category_names,
               {"", "category of the motion; -1 where the cell is not done"}, "not_done");
    const auto quiet = [&](std::size_t index) {
        const sweep::CellVerdict& cell = result.cells[index];
        return cell.status == sweep::Status::done ? static_cast<int>(cell.quiet) : -1;
    };
    file.flags("quiet_because", dimensions, numbers_of(result, quiet), classification::quiet_names,
               {"", "is it quiet, and because the contact slides or sticks? -1 where the cell is not done"},
               "not_done");
    const auto status = [&](std::size_t index) { return result.cells[index].status; };
    file.flags("status", dimensions, numbers_of(result, status), sweep::status_names, {"", "how the cell ended"});
    const auto source = [&](std::size_t index) { return sweep::is_inferred(result, index) ? 1 : 0; };
    file.flags("source", dimensions, numbers_of(result, source), sweep::source_names,
               {"", "was the cell computed, or inferred from neighbours that agree?"});
}

/// The figures of a row of the chart; NaN where a cell was not computed.
struct FigureRow {
    std::size_t row = 0;           // counted through all directions
    std::vector<double> values{};  // shape [figure][column]
};

using TakeRow = std::function<void(const FigureRow&)>;

// shows the rows one after the other; rows without a computed cell are left out
void visit_rows(const sweep::SweepResult& result, const TakeRow& take) {
    const std::span<const sweep::CellFigure> figures = sweep::cell_figures();
    const auto columns = static_cast<std::size_t>(result.study.x.points);
    const std::vector<double> unknown(figures.size() * columns, sweep::Cell::unknown);
    FigureRow row{0, unknown};
    result.computed->visit(0, result.cells.size(), [&](const sweep::IndexedCell& computed) {
        if (computed.index / columns != row.row) {
            take(row);
            row = {computed.index / columns, unknown};
        }
        for (std::size_t k = 0; k < figures.size(); ++k)
            row.values[k * columns + computed.index % columns] = figure_of(computed.cell, figures[k]);
    });
    take(row);
}

/// The figures in the file, a row of the chart at a time.
class FigureWriter {
public:
    FigureWriter(NetcdfDataset& file, const sweep::Study& study, std::span<const int> dimensions)
        : file_(file),
          columns_(static_cast<std::size_t>(study.x.points)),
          rows_(static_cast<std::size_t>(study.y.points)) {
        // of a refined chart most are missing
        const VariablePacking packing = study.refine > 0 ? VariablePacking::deflate : VariablePacking::none;
        for (const sweep::CellFigure& figure : sweep::cell_figures())
            variables_.push_back(
                file.doubles(std::string(figure.name), dimensions, packing, {figure.unit, figure.sentence}));
    }

    void put(const FigureRow& row) {
        const std::array start{row.row / rows_, row.row % rows_, std::size_t{0}};
        const std::array count{std::size_t{1}, std::size_t{1}, columns_};
        for (std::size_t k = 0; k < variables_.size(); ++k)
            file_.put(variables_[k], start, count, std::span(row.values).subspan(k * columns_, columns_));
    }

private:
    NetcdfDataset& file_;
    std::size_t columns_;
    std::size_t rows_;
    std::vector<int> variables_;
};

// what each start led to; shape [start][cell], -1 where a cell was inferred
std::vector<signed char> verdicts_of_starts(const sweep::SweepResult& result) {
    const std::size_t cells = result.cells.size();
    std::vector<signed char> verdicts(result.study.starts.size() * cells, -1);
    if (verdicts.empty()) return verdicts;
    result.computed->visit(0, cells, [&](const sweep::IndexedCell& computed) {
        for (std::size_t start = 0; start < computed.cell.starts.size(); ++start)
            verdicts[start * cells + computed.index] =
                static_cast<signed char>(sweep::number_of(computed.cell.starts[start]));
    });
    return verdicts;
}

// that, and whether the starts agree
void put_starts(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const int> dimensions,
                std::span<const signed char> verdicts) {
    std::vector<std::string> names;
    for (const parameters::Initial start : result.study.starts)
        names.emplace_back(sweep::start_names()[static_cast<std::size_t>(start)]);
    std::vector<int> with_start{file.dimension("start", names.size())};
    file.words("start", with_start, names, {"", "how the motion starts"});
    with_start.insert(with_start.end(), dimensions.begin(), dimensions.end());
    file.flags("start_verdict", with_start, verdicts, sweep::verdict_words,
               {"", "category, or status without one, from this start; -1 where the cell was inferred"}, "inferred");
    const auto agreement = [&](std::size_t index) { return result.cells[index].agreement; };
    file.flags("agreement", dimensions, numbers_of(result, agreement), sweep::agreement_names,
               {"", "do all starts lead to the same verdict?"});
}

/// Makes the chart's file; the figures come from `rows`, which calls its argument with each row.
void put_chart(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const signed char> starts,
               const std::function<void(const TakeRow&)>& rows) {
    const sweep::Study& study = result.study;
    const std::string canonical = sweep::canonical_text(study);
    put_origin(file, "chart", study.base.title.empty() ? "noise chart" : study.base.title);
    const int direction = put_directions(file, study);
    const int y = put_axis(file, coordinate_name(study.y, study.x), study.y, "Y");
    const int x = put_axis(file, coordinate_name(study.x, study.y), study.x, "X");
    const std::array dimensions{direction, y, x};
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", study_toml(study, {.comments = Comments::none, .heading = ""}));
    put_verdicts(file, result, dimensions);
    FigureWriter figures(file, study, dimensions);
    rows([&](const FigureRow& row) { figures.put(row); });
    if (!study.starts.empty()) put_starts(file, result, dimensions, starts);
}

// the rows that another process sends, each its number and its values
void receive_rows(const base::Receive& receive, std::size_t values, const TakeRow& take) {
    FigureRow row{0, std::vector<double>(values)};
    while (receive(std::as_writable_bytes(std::span(&row.row, 1)))) {
        receive(std::as_writable_bytes(std::span(row.values)));
        take(row);
    }
}

/// HDF5 writes the temporary file by itself, in a process of its own.
///
/// That process has of the chart what is in memory; the figures are sent to it, for the database they lie in may not
/// be used by two processes.
void write_apart(const std::string& path, const std::string& temporary, const sweep::SweepResult& result,
                 std::span<const signed char> starts) {
    const std::size_t values = sweep::cell_figures().size() * static_cast<std::size_t>(result.study.x.points);
    netcdf();  // opened here: in the copy, another thread's use of the loader would never end
    base::SeparateProcess writer("cannot write \"" + path + "\"", [&](const base::Receive& receive) {
        // it is a file of ours, locked by us
        ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
        NetcdfDataset file(path, temporary);
        put_chart(file, result, starts, [&](const TakeRow& take) { receive_rows(receive, values, take); });
        file.finish();
    });
    visit_rows(result, [&](const FigureRow& row) {
        writer.send(std::as_bytes(std::span(&row.row, 1)));
        writer.send(std::as_bytes(std::span(row.values)));
    });
    writer.finish();
}

// what a chart takes on the disk at most [bytes], generously
std::size_t room_of(const sweep::SweepResult& result) {
    constexpr std::size_t frame = std::size_t{1} << 20U;
    const std::size_t bytes_of_figures = sweep::cell_figures().size() * sizeof(double);
    const std::size_t filled = result.study.refine > 0 ? sweep::computed_count(result) : result.cells.size();
    return frame + filled * bytes_of_figures + result.cells.size() * (5 + result.study.starts.size());
}

}  // namespace

void write_chart_netcdf(const std::string& path, const sweep::SweepResult& result, std::size_t largest_in_memory) {
    const std::vector<signed char> starts = verdicts_of_starts(result);
    const std::size_t room = room_of(result);
    storage::PiecewiseFile whole(path);
    if (room <= largest_in_memory) {
        NetcdfDataset file(path);
        put_chart(file, result, starts, [&](const TakeRow& take) { visit_rows(result, take); });
        file.finish([&](std::string_view bytes) { whole.write(bytes); });
    } else {
        write_apart(path, whole.temporary_name(room), result, starts);
    }
    whole.commit();
}

}  // namespace stridor::io
