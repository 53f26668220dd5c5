#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/explorer/answers.hpp"
#include "stridor/explorer/bytes.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/simulation/dof_names.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/parameters/case_key.hpp"
#include "stridor/parameters/field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/record/columns.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

constexpr double most_samples = 1e6;     // of a trace
constexpr double least_interval = 1e-7;  // [s] between them
constexpr std::size_t most_complaints =
    12;  // of one error that the page has room for; a request may hold 200 wrong values

// {"drive.kind": ["constant", "trapezoidal"]}: the choices without which a field means nothing; none if it always does
Json homes_object(const parameters::Field& field) {
    std::map<const parameters::Field*, std::vector<std::string_view>> names;
    for (const parameters::Home& home : parameters::homes_of({}, field))
        names[home.choice].push_back(home.name);
    Json object = Json::object();
    for (const auto& [choice, all] : names)
        if (all.size() < std::get<parameters::Choice>(choice->kind).names.size())
            object[parameters::key_of(*choice)] = all;
    return object;
}

Json field_object(const parameters::Field& field) {
    Json object{{"key", parameters::key_of(field)},
                {"section", field.section},
                {"symbol", field.symbol},
                {"sentence", field.sentence},
                {"belongs_to", homes_object(field)}};
    if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind)) {
        object["kind"] = "quantity";
        object["unit"] = quantity->unit;
        object["low"] = quantity->range.low;  // null where it is open to infinity
        object["high"] = quantity->range.high;
        // what a choice that needs it begins with; other fields have their values without saying
        if (io::is_required(field)) object["default"] = quantity->get({});
        if (quantity->usual)
            object["usual"] = {{"from", quantity->usual->from},
                               {"to", quantity->usual->to},
                               {"scale", quantity->usual->scale == parameters::Scale::linear ? "linear" : "log"}};
    } else if (const auto* choice = std::get_if<parameters::Choice>(&field.kind)) {
        object["kind"] = "choice";
        object["choices"] = choice->names;
    } else {
        object["kind"] = "text";
    }
    return object;
}

Json preset_object(const Preset& preset) {
    const parameters::Case c = io::read_case(io::parse_toml(source_of(preset)), readers_of(preset));
    Json object{{"name", preset.name}, {"title", c.title}, {"case", Json::parse(io::case_json(c))}};
    if (preset.study) object["chart"] = chart_of(*preset.study);
    return object;
}

/// A column of the motion that is sent: numbers of the trace, under the names that the page knows.
struct SentColumn {
    std::string name;
    std::string_view unit;
    std::string sentence;
    std::function<const std::vector<double>&(const record::Trace&)> values;
};

/// A degree of freedom as the page knows it.
struct SentDof {
    std::string name;  // x1 and y1 of the first joint, y2 of the plate; x_lip2 and y_lip2 of a further joint
    std::string whose;
};

std::vector<SentDof> dofs_of(const parameters::Case& c) {
    std::vector<std::string> names = io::dof_names(parameters::Case{});
    std::vector<SentDof> dofs;
    for (std::size_t dof = 0; dof < names.size(); ++dof)
        dofs.push_back({names[dof], std::string(io::dof_sentences[dof])});
    if (c.further_joints.empty()) return dofs;
    names = io::dof_names(c);
    const SentDof plate = dofs.back();
    dofs.pop_back();
    for (std::size_t dof = dofs.size(); dof + 1 < names.size(); ++dof)
        dofs.push_back({names[dof], dofs[dof % 2].whose});
    for (std::size_t dof = 0; dof < dofs.size(); ++dof)
        dofs[dof].whose.replace(0, std::string_view("of the joint").size(), "of " + parameters::joint_name(c, dof / 2));
    dofs.push_back(plate);
    return dofs;
}

// displacements and velocities of the rubbing system ("x1", "x1_velocity"), the surface's velocity, each contact's
std::vector<SentColumn> columns_of(const parameters::Case& c) {
    std::vector<SentColumn> columns;
    const std::size_t contacts = parameters::joint_count(c);
    const std::vector<SentDof> dofs = dofs_of(c);
    for (const record::DofColumn& column : std::span(record::dof_columns).first(2))
        for (std::size_t dof = 0; dof < dofs.size(); ++dof) {
            const bool is_place = column.samples == &record::Trace::displacement;
            columns.push_back(
                {dofs[dof].name + (is_place ? "" : "_" + std::string(column.name)), column.unit,
                 std::string(is_place ? "displacement" : column.name) + " " + dofs[dof].whose,
                 [member = column.samples, dof](const record::Trace& trace) -> const std::vector<double>& {
                     return (trace.*member)[dof];
                 }});
        }
    columns.push_back({std::string(record::surface_column.name), record::surface_column.unit,
                       std::string(record::surface_column.sentence),
                       [](const record::Trace& trace) -> const std::vector<double>& {
                           return trace.*record::surface_column.samples;
                       }});
    for (std::size_t contact = 0; contact < contacts; ++contact)
        for (const record::ContactColumn& column : record::contact_columns)
            columns.push_back(
                {std::string(column.name) + record::contact_ending(contact, contacts), column.unit,
                 std::string(column.sentence),
                 [member = column.samples, contact](const record::Trace& trace) -> const std::vector<double>& {
                     return trace.contacts[contact].*member;
                 }});
    return columns;
}

record::TraceRequest trace_in(const Json& body, const parameters::Case& c) {
    const double from = std::max(0.0, number_in(body, "from", 0.0));
    const double to = std::min(c.run.duration, number_in(body, "to", c.run.duration));
    const double interval = number_in(body, "interval", std::max(least_interval, (to - from) / most_samples));
    const bool is_possible = from < to && interval >= least_interval && (to - from) / interval <= 1.01 * most_samples;
    if (!is_possible)
        throw Error(ErrorKind::input, {"there is no such trace",
                                       "its times must rise within the run, and a million samples "
                                       "are the most",
                                       ""});
    record::TraceRequest request;
    request.from = from;
    request.to = to;
    request.interval = interval;
    return request;
}

void pad(std::string& bytes) {
    bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
}

std::string motion_header(const parameters::Case& c, const record::TraceRequest& trace,
                          const std::vector<SentColumn>& columns, std::size_t samples,
                          const std::vector<record::ContactHistory>& histories) {
    Json header{{"schema", "stridor.explorer.motion/1"},
                {"samples", samples},
                {"start", trace.from},
                {"interval", trace.interval},
                {"columns", Json::array()}};
    for (const SentColumn& column : columns)
        header["columns"].push_back({{"name", column.name}, {"unit", column.unit}, {"sentence", column.sentence}});
    header["contacts"] = Json::array();
    for (std::size_t k = 0; k < histories.size(); ++k)
        header["contacts"].push_back({{"name", parameters::joint_name(c, k)}, {"intervals", histories[k].size()}});
    header["states"] = model::contact_state_names;
    std::string text = header.dump();
    text.resize((text.size() + 4 + 7) / 8 * 8 - 4, ' ');  // the arrays after it begin at a multiple of 8
    return text;
}

std::string history_bytes(const record::ContactHistory& history) {
    std::vector<double> times;
    std::vector<std::uint8_t> states;
    for (const record::ContactInterval& interval : history) {
        times.push_back(interval.from);
        states.push_back(static_cast<std::uint8_t>(interval.state));
    }
    times.push_back(history.empty() ? 0.0 : history.back().to);
    return bytes_of<double>(times) + bytes_of<std::uint8_t>(states);
}

// the key of the field that a message is about; empty if it names none
std::string key_in(const std::string& message) {
    // of one of several joints it is longer: "joint.lip2.contact.preload"
    constexpr std::string_view of_keys = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-";
    if (const std::size_t begin = message.find("joint."); begin != std::string::npos) {
        const std::size_t end = std::min(message.find_first_not_of(of_keys, begin), message.size());
        std::string key = message.substr(begin, end - begin);
        while (key.ends_with('.'))
            key.pop_back();
        if (parameters::field_of(key) != nullptr) return key;
    }
    for (const parameters::Field& field : parameters::fields())
        if (!field.section.empty() && message.find(parameters::key_of(field)) != std::string::npos)
            return parameters::key_of(field);
    return {};
}

Json problem_object(const base::Problem& problem) {
    return {{"what", problem.what},
            {"why", problem.why},
            {"suggestion", problem.suggestion},
            {"key", key_in(problem.what)}};
}

}  // namespace

integration::Motion run_case(const parameters::Case& c, const record::Request& request, const std::stop_token& stop) {
    integration::Workspace workspace;
    std::optional<sweep::Attempt> attempt = sweep::attempt(c, request, stop, workspace);
    if (!attempt) throw Error(ErrorKind::interrupted, {"the run was stopped", "", ""});
    if (attempt->status != sweep::Status::done) throw Error(ErrorKind::numerical, {attempt->message, "", ""});
    return std::move(attempt->motion);
}

Response json(std::string document) {
    return {200, "application/json", std::move(document) + "\n"};
}

std::string error_document(const Error& error) {
    const std::size_t told = std::min(error.complaints().size(), most_complaints);
    Json first = problem_object(error.problem());
    first["others"] = Json::array();
    for (const base::Complaint& complaint : std::span(error.complaints()).first(told).subspan(1))
        first["others"].push_back(problem_object(complaint.problem));
    first["untold"] = error.complaints().size() - told;
    const Json document{{"schema", "stridor.explorer.error/1"}, {"error", std::move(first)}};
    return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Response start(const World& world) {
    Json document{{"schema", "stridor.explorer.start/1"},
                  {"version", base::version()},
                  {"presets", Json::array()},
                  {"fields", Json::array()},
                  {"figures", Json::array()},
                  {"chart", default_chart()},
                  {"library", !world.library.empty()}};
    for (const Preset& preset : world.presets)
        document["presets"].push_back(preset_object(preset));
    for (const parameters::Field& field : parameters::fields())
        document["fields"].push_back(field_object(field));
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        document["figures"].push_back({{"name", figure.name}, {"unit", figure.unit}, {"sentence", figure.sentence}});
    return json(document.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Response simulate(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    const integration::Motion motion = run_case(c, {}, stop);
    const auto verdicts = classification::classify_phases(motion.record.phases, c.verdict);
    return json(io::simulation_json(c, motion, integration::cost(c), verdicts));
}

Response motion(const World& world, const Json& body, const std::stop_token& stop) {
    const parameters::Case c = case_in(world, body);
    record::Request request{record::KeepHistory::yes, trace_in(body, c)};
    const std::vector<SentColumn> columns = columns_of(c);
    std::vector<std::vector<float>> values(columns.size());
    // block by block into the half as large numbers that are sent: a trace of doubles would be 100 MB
    request.trace.taker = [&](const record::Trace& trace) {
        for (std::size_t k = 0; k < columns.size(); ++k)
            for (const double value : columns[k].values(trace))
                values[k].push_back(static_cast<float>(value));
    };
    const integration::Motion motion = run_case(c, request, stop);
    const std::string header = motion_header(c, request.trace, columns, values.front().size(), motion.record.histories);
    const auto length = static_cast<std::uint32_t>(header.size());
    std::string bytes = bytes_of<std::uint32_t>({&length, 1}) + header;
    for (const std::vector<float>& column : values) {
        bytes += bytes_of<float>(column);
        pad(bytes);
    }
    for (const record::ContactHistory& history : motion.record.histories) {
        bytes += history_bytes(history);
        pad(bytes);
    }
    return {200, "application/octet-stream", std::move(bytes)};
}

Response stability(const World& world, const Json& body, const std::stop_token&) {
    const parameters::Case c = case_in(world, body);
    std::optional<analysis::ScanRange> range;
    if (body.contains("over")) {
        constexpr int most = 2000;
        constexpr int usual = 201;  // fewer leave a kink where modes begin to couple
        const Json& over = object_in(body, "over");
        range = {text_in(over, "key"), number_in(over, "from"), number_in(over, "to"),
                 std::min(most, whole_in(over, "points", usual))};
    }
    return json(io::stability_json(analysis::scan_stability(c, range)));
}

Response toml(const World& world, const Json& body, const std::stop_token&) {
    const bool is_chart = body.contains("chart");
    return {200, "text/plain; charset=utf-8",
            is_chart ? io::study_toml(study_in(world, body)) : io::case_toml(case_in(world, body))};
}

}  // namespace stridor::explorer
