#include "stridor/io/netcdf.hpp"

#include "stridor/base/hash.hpp"
#include "stridor/base/version.hpp"
#include "stridor/io/atomic_file.hpp"
#include "stridor/io/dof_names.hpp"
#include "stridor/io/netcdf_dataset.hpp"
#include "stridor/io/toml_writer.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Field;

void put_origin(NetcdfDataset& file, std::string_view schema, const std::string& title) {
    file.attribute("Conventions", "CF-1.10");
    file.attribute("title", title);
    file.attribute("source", "stridor " + std::string(base::version()) + " (" + std::string(base::commit()) + ")");
    file.attribute("schema", "stridor." + std::string(schema) + "/1");
}

// a coordinate's name must be its own among the variables: drive.frequency beside the figure "frequency"
std::string coordinate_name(const sweep::Axis& axis, const sweep::Axis& other) {
    const std::string& key = axis.parameter;
    const auto short_name = [](const std::string& full) { return full.substr(full.find('.') + 1); };
    const std::string name = short_name(key);
    constexpr std::array<std::string_view, 7> fixed{"direction", "category", "status",       "source",
                                                    "agreement", "start",    "start_verdict"};
    const bool is_taken = name == short_name(other.parameter) || sweep::find_cell_figure(name) != nullptr ||
                          std::find(fixed.begin(), fixed.end(), name) != fixed.end();
    std::string full = key;
    std::replace(full.begin(), full.end(), '.', '_');
    return is_taken ? full : name;
}

// the conventions spell the degree out
std::string_view units_of(const Field& field) {
    const std::string_view unit = std::get<parameters::Quantity>(field.kind).unit;
    return unit == "deg" ? "degree" : unit;
}

int put_axis(NetcdfDataset& file, const std::string& name, const sweep::Axis& axis, const std::string& letter) {
    const int dimension = file.dimension(name, static_cast<std::size_t>(axis.points));
    std::vector<double> values;
    for (int index = 0; index < axis.points; ++index)
        values.push_back(sweep::value_at(axis, index));
    const Field& field = *parameters::find_field(axis.parameter);
    const int variable =
        file.doubles(name, std::array{dimension}, values, {units_of(field), field.sentence, Missing::no});
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

void put_cells(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const int> dimensions) {
    std::vector<signed char> category;
    std::vector<signed char> status;
    for (const sweep::Cell& cell : result.cells) {
        const bool is_done = cell.status == sweep::Status::done;
        category.push_back(static_cast<signed char>(is_done ? static_cast<int>(cell.category) : -1));
        status.push_back(static_cast<signed char>(cell.status));
    }
    file.flags("category", dimensions, category, classification::category_names,
               {"", "category of the motion; missing where the cell is not done"});
    file.flags("status", dimensions, status, sweep::status_names, {"", "how the cell ended"});
    std::vector<signed char> source;
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        source.push_back(sweep::is_inferred(result, index) ? 1 : 0);
    file.flags("source", dimensions, source, sweep::source_names,
               {"", "was the cell computed, or inferred from neighbours that agree?"});
    std::vector<double> values(result.cells.size());
    for (const sweep::CellFigure& figure : sweep::cell_figures()) {
        std::transform(result.cells.begin(), result.cells.end(), values.begin(),
                       [&](const sweep::Cell& cell) { return cell.*figure.member; });
        file.doubles(std::string(figure.name), dimensions, values, {figure.unit, figure.sentence});
    }
}

// what each start led to, and whether they agree
void put_starts(NetcdfDataset& file, const sweep::SweepResult& result, std::span<const int> dimensions) {
    std::vector<std::string> names;
    std::vector<signed char> verdicts;
    for (std::size_t start = 0; start < result.study.starts.size(); ++start) {
        names.emplace_back(sweep::start_names()[static_cast<std::size_t>(result.study.starts[start])]);
        for (const sweep::Cell& cell : result.cells)
            verdicts.push_back(static_cast<signed char>(
                start < cell.starts.size() ? static_cast<int>(sweep::number_of(cell.starts[start])) : -1));
    }
    std::vector<int> with_start{file.dimension("start", names.size())};
    file.words("start", with_start, names, {"", "how the motion starts"});
    with_start.insert(with_start.end(), dimensions.begin(), dimensions.end());
    file.flags("start_verdict", with_start, verdicts, sweep::verdict_words,
               {"", "category, or status without one, from this start; missing where the cell was inferred"});
    std::vector<signed char> agreement;
    for (const sweep::Cell& cell : result.cells)
        agreement.push_back(static_cast<signed char>(cell.agreement));
    file.flags("agreement", dimensions, agreement, sweep::agreement_names,
               {"", "do all starts lead to the same verdict?"});
}

void put_trace(NetcdfDataset& file, const record::Trace& trace) {
    const std::vector<std::string> names = dof_names(trace.displacement.size());
    const int time = file.dimension("time", trace.time.size());
    const int dof = file.dimension("dof", names.size());
    file.doubles("time", std::array{time}, trace.time, {"s", "time", Missing::no});
    file.words("dof", std::array{dof}, names, {"", "degree of freedom"});

    const auto put_motion = [&](const std::string& name, const std::vector<std::vector<double>>& motion,
                                const Description& description) {
        std::vector<double> values;
        for (const std::vector<double>& row : motion)
            values.insert(values.end(), row.begin(), row.end());
        file.doubles(name, std::array{dof, time}, values, description);
    };
    put_motion("displacement", trace.displacement, {"m", "displacement from the preloaded rest position"});
    put_motion("velocity", trace.velocity, {"m/s", "velocity"});
    put_motion("acceleration", trace.acceleration, {"m/s^2", "acceleration"});

    const std::array along{time};
    file.doubles("surface_velocity", along, trace.surface_velocity, {"m/s", "imposed velocity of the plate"});
    file.doubles("normal_force", along, trace.normal_force, {"N", "normal contact force on the joint"});
    file.doubles("friction_force", along, trace.friction_force, {"N", "friction force on the joint"});
    file.doubles("gap", along, trace.gap, {"m", "gap between joint and plate"});
    std::vector<signed char> states;
    for (const model::ContactState state : trace.state)
        states.push_back(static_cast<signed char>(state));
    file.flags("state", along, states, model::contact_state_names, {"", "contact state"});
}

void put_history(NetcdfDataset& file, const record::ContactHistory& history) {
    const std::array along{file.dimension("interval", history.size())};
    std::vector<signed char> states;
    for (const record::ContactInterval& interval : history)
        states.push_back(static_cast<signed char>(interval.state));
    file.flags("interval_state", along, states, model::contact_state_names, {"", "contact state"});
    const auto put = [&](const std::string& name, double record::ContactInterval::*member,
                         const Description& description) {
        std::vector<double> values;
        for (const record::ContactInterval& interval : history)
            values.push_back(interval.*member);
        file.doubles(name, along, values, description);
    };
    put("interval_from", &record::ContactInterval::from, {"s", "time at which the state began", Missing::no});
    put("interval_to", &record::ContactInterval::to, {"s", "time at which it ended", Missing::no});
    put("interval_slip_velocity", &record::ContactInterval::slip_velocity, {"m/s", "slip velocity at its beginning"});
    put("interval_gap_velocity", &record::ContactInterval::gap_velocity,
        {"m/s", "velocity of the gap at its beginning; negative: the surfaces met"});
}

}  // namespace

void write_chart_netcdf(const std::string& path, const sweep::SweepResult& result) {
    const sweep::Study& study = result.study;
    const std::string canonical = sweep::canonical_text(study);
    NetcdfDataset file(path);
    put_origin(file, "chart", study.base.title.empty() ? "noise chart" : study.base.title);
    const int direction = put_directions(file, study);
    const int y = put_axis(file, coordinate_name(study.y, study.x), study.y, "Y");
    const int x = put_axis(file, coordinate_name(study.x, study.y), study.x, "X");
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", study_toml(study, {.comments = Comments::none, .heading = ""}));
    put_cells(file, result, std::array{direction, y, x});
    if (!study.starts.empty()) put_starts(file, result, std::array{direction, y, x});
    write_file(path, file.finish());
}

void write_trace_netcdf(const std::string& path, const parameters::Case& c, const record::Record& record) {
    const std::string canonical = parameters::canonical_text(c);
    NetcdfDataset file(path);
    put_origin(file, "trace", c.title.empty() ? "simulated motion" : c.title);
    file.attribute("study", canonical);
    file.attribute("study_hash", base::hash_text(canonical));
    file.attribute("case", case_toml(c, {.comments = Comments::none, .heading = ""}));
    if (!record.trace.time.empty()) put_trace(file, record.trace);
    if (!record.history.empty()) put_history(file, record.history);
    write_file(path, file.finish());
}

}  // namespace stridor::io
