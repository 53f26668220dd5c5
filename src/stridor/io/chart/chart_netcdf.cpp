#include "stridor/io/chart/chart_netcdf.hpp"

#include "stridor/base/child_process.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/hash.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/chart/chart_bands.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/storage/atomic_file.hpp"
#include "stridor/storage/new_file.hpp"
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

/// A verdict of the cells as bytes: its name in the file, and what it is of a cell.
struct VerdictVariable {
    std::string name;
    FlagNames names;
    std::string_view sentence;
    int (*number)(const sweep::SweepResult& result, std::size_t index);
};

std::vector<VerdictVariable> verdict_variables(const sweep::Study& study) {
    using sweep::SweepResult;
    std::vector<VerdictVariable> variables{
        {"category",
         {classification::category_names, "not_done"},
         "category of the motion; -1 where the cell is not done",
         [](const SweepResult& result, std::size_t index) {
             const sweep::CellVerdict& cell = result.cells[index];
             return cell.status == sweep::Status::done ? static_cast<int>(cell.category) : -1;
         }},
        {"quiet_because",
         {classification::quiet_names, "not_done"},
         "is it quiet, and because the contact slides, sticks or locks? -1 where the cell is not done",
         [](const SweepResult& result, std::size_t index) {
             const sweep::CellVerdict& cell = result.cells[index];
             return cell.status == sweep::Status::done ? static_cast<int>(cell.quiet) : -1;
         }},
        {"status",
         {sweep::status_names},
         "how the cell ended",
         [](const SweepResult& result, std::size_t index) { return static_cast<int>(result.cells[index].status); }},
        {"source",
         {sweep::source_names},
         "was the cell computed, or inferred from neighbours that agree?",
         [](const SweepResult& result, std::size_t index) { return sweep::is_inferred(result, index) ? 1 : 0; }}};
    if (!study.starts.empty())
        variables.push_back({"agreement",
                             {sweep::agreement_names},
                             "do all starts lead to the same verdict?",
                             [](const SweepResult& result, std::size_t index) {
                                 return static_cast<int>(result.cells[index].agreement);
                             }});
    return variables;
}

using TakeBand = std::function<void(const BandValues&)>;

/// The cells in the file, a band at a time.
class CellWriter {
public:
    CellWriter(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const sweep::CellFigure> figures,
               const std::array<int, 3>& dimensions)
        : file_(file),
          result_(result),
          variables_(verdict_variables(result.study)) {
        const sweep::Study& study = result.study;
        const auto within = [](int points) { return std::min(chunk_points, static_cast<std::size_t>(points)); };
        const std::array chunk{std::size_t{1}, within(study.y.points), within(study.x.points)};
        for (const VerdictVariable& variable : variables_)
            verdicts_.push_back(file.flags(variable.name, dimensions, chunk, variable.names, {"", variable.sentence}));
        if (!study.starts.empty()) start_verdict_ = define_starts(dimensions, chunk);
        for (const sweep::CellFigure& figure : figures)
            figures_.push_back(
                file.doubles(std::string(figure.name), dimensions, chunk, {figure.unit, figure.sentence}));
    }

    void put_verdicts() {
        for (std::size_t k = 0; k < variables_.size(); ++k)
            for (const ChartBand& band : bands_of(result_.study)) {
                const std::size_t first = first_cell(result_.study, band);
                numbers_.resize(cell_count(result_.study, band));
                for (std::size_t place = 0; place < numbers_.size(); ++place)
                    numbers_[place] = static_cast<signed char>(variables_[k].number(result_, first + place));
                put(verdicts_[k], band, std::span<const signed char>(numbers_));
            }
    }

    void put(const BandValues& values) {
        const std::size_t cells = cell_count(result_.study, values.band);
        const std::span<const double> figures(values.figures);
        for (std::size_t k = 0; k * cells < figures.size(); ++k)
            put(figures_[values.first_figure + k], values.band, figures.subspan(k * cells, cells));
        const std::span<const signed char> starts(values.starts);
        for (std::size_t start = 0; start * cells < starts.size(); ++start) {
            const std::array corner{start, values.band.direction, values.band.row, std::size_t{0}};
            const std::array shape{std::size_t{1}, std::size_t{1}, values.band.rows, columns()};
            file_.put(start_verdict_, corner, shape, starts.subspan(start * cells, cells));
        }
    }

private:
    std::size_t columns() const { return static_cast<std::size_t>(result_.study.x.points); }

    template <typename Number>
    void put(int variable, const ChartBand& band, std::span<const Number> numbers) {
        const std::array corner{band.direction, band.row, std::size_t{0}};
        const std::array shape{std::size_t{1}, band.rows, columns()};
        file_.put(variable, corner, shape, numbers);
    }

    int define_starts(const std::array<int, 3>& dimensions, const std::array<std::size_t, 3>& chunk) {
        std::vector<std::string> names;
        for (const parameters::Initial start : result_.study.starts)
            names.emplace_back(sweep::start_names()[static_cast<std::size_t>(start)]);
        const int start = file_.dimension("start", names.size());
        file_.words("start", std::array{start}, names, {"", "how the motion starts"});
        const std::array with_start{start, dimensions[0], dimensions[1], dimensions[2]};
        const std::array chunk_with_start{std::size_t{1}, chunk[0], chunk[1], chunk[2]};
        return file_.flags("start_verdict", with_start, chunk_with_start, {sweep::verdict_words, "inferred"},
                           {"", "category, or status without one, from this start; -1 where the cell was inferred"});
    }

    NetcdfDataset& file_;
    const sweep::SweepResult& result_;
    std::vector<VerdictVariable> variables_;
    std::vector<int> verdicts_;
    int start_verdict_ = -1;
    std::vector<int> figures_;
    std::vector<signed char> numbers_;
};

/// Makes the chart's file; what is kept elsewhere comes from `bands`, which calls its argument with each part.
void put_chart(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const sweep::CellFigure> figures,
               const std::function<void(const TakeBand&)>& bands) {
    const sweep::Study& study = result.study;
    const std::string canonical = sweep::canonical_text(study);
    put(file, origin_attributes("chart", study.base.title.empty() ? "noise chart" : study.base.title));
    const int direction = put_directions(file, study);
    const int y = put_axis(file, coordinate_name(study.y, study.x), study.y, "Y");
    const int x = put_axis(file, coordinate_name(study.x, study.y), study.x, "X");
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", study_toml(study, {.comments = Comments::none, .heading = ""}));
    CellWriter cells(file, result, figures, {direction, y, x});
    cells.put_verdicts();
    bands([&](const BandValues& values) { cells.put(values); });
}

// how many values of a part follow
struct BandSize {
    ChartBand band;
    std::size_t first_figure = 0;
    std::size_t figures = 0;  // [1] numbers
    std::size_t starts = 0;   // [1] numbers
};

// the parts that another process sends
void receive_bands(const base::ChildProcess::Channel& channel, const TakeBand& take) {
    BandSize size;
    BandValues values;
    while (channel.receive(std::as_writable_bytes(std::span(&size, 1)))) {
        values.band = size.band;
        values.first_figure = size.first_figure;
        values.figures.resize(size.figures);
        values.starts.resize(size.starts);
        channel.receive(std::as_writable_bytes(std::span(values.figures)));
        channel.receive(std::as_writable_bytes(std::span(values.starts)));
        take(values);
    }
}

/// HDF5 writes the temporary file by itself, in a process of its own.
///
/// That process has of the chart what is in memory; the figures are sent to it, for the database they lie in may not
/// be used by two processes.
void write_apart(const std::string& path, const std::string& temporary, const sweep::SweepResult& result,
                 std::span<const sweep::CellFigure> figures) {
    const auto failure = [&](const std::string& reason) {
        return Error(ErrorKind::io, {"cannot write \"" + path + "\"", reason, "Make room, or write elsewhere."});
    };
    base::ChildProcess writer({}, [&](const base::ChildProcess::Channel& channel) {
        // it is a file of ours, locked by us
        ::setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
        NetcdfDataset file(path, temporary);
        put_chart(file, result, figures, [&](const TakeBand& take) { receive_bands(channel, take); });
        file.finish();
    });
    visit_bands(result, {figures}, [&](const BandValues& values) {
        const BandSize size{values.band, values.first_figure, values.figures.size(), values.starts.size()};
        const bool is_heard = writer.send(std::as_bytes(std::span(&size, 1))) &&
                              writer.send(std::as_bytes(std::span(values.figures))) &&
                              writer.send(std::as_bytes(std::span(values.starts)));
        if (!is_heard) throw failure(writer.finish());
    });
    if (const std::string reason = writer.finish(); !reason.empty()) throw failure(reason);
}

// what a chart takes on the disk at most [bytes], generously
std::size_t room_of(const sweep::SweepResult& result, std::size_t figures) {
    // matrices stand in the text of a case
    const std::size_t frame = (std::size_t{1} << 20U) + 4 * sweep::canonical_text(result.study).size();
    const std::size_t filled = result.study.refine > 0 ? sweep::computed_count(result) : result.cells.size();
    return frame + filled * figures * sizeof(double) + result.cells.size() * (5 + result.study.starts.size());
}

}  // namespace

void write_chart_netcdf(const std::string& path, const sweep::SweepResult& result, const NetcdfOptions& options) {
    const std::size_t room = room_of(result, options.figures.size());
    storage::PiecewiseFile whole(path);
    if (room <= options.largest_in_memory) {
        NetcdfDataset file(path);
        put_chart(file, result, options.figures,
                  [&](const TakeBand& take) { visit_bands(result, {options.figures}, take); });
        file.finish([&](std::string_view bytes) { whole.write(bytes); });
    } else {
        write_apart(path, whole.temporary_name(room), result, options.figures);
    }
    whole.commit();
}

void write_chart_zarr(const std::string& path, const sweep::SweepResult& result,
                      std::span<const sweep::CellFigure> figures) {
    storage::WholeFolder folder(path);
    {
        NetcdfDataset file(path, folder.temporary().string(), DatasetFormat::zarr);
        put_chart(file, result, figures, [&](const TakeBand& take) { visit_bands(result, {figures}, take); });
        file.finish();
    }
    folder.commit();
}

}  // namespace stridor::io
