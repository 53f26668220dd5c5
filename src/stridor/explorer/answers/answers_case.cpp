#include "stridor/analysis/stability_scan.hpp"
#include "stridor/base/error.hpp"
#include "stridor/base/version.hpp"
#include "stridor/classification/contact_rules.hpp"
#include "stridor/explorer/answers/answers.hpp"
#include "stridor/integration/cost.hpp"
#include "stridor/integration/simulate.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_document.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/io/simulation/json_simulation.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/usual_range.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace stridor::explorer {

namespace {

// of one error that the page has room for; a request may hold 200 wrong values
constexpr std::size_t most_complaints = 12;

// {"drive.kind": ["constant", "trapezoidal"]}: the choices without which a field means nothing; none if it always does
Json homes_object(const parameters::Field& field) {
    std::map<const parameters::Field*, std::vector<std::string_view>> names;
    for (const parameters::Home& home : parameters::homes_of(parameters::Case{}, field))
        names[home.choice].push_back(home.name);
    Json object = Json::object();
    for (const auto& [choice, all] : names)
        if (all.size() < std::get<parameters::Choice>(choice->kind).names.size())
            object[parameters::key_of(*choice)] = all;
    return object;
}

Json range_object(const parameters::UsualRange& range) {
    return {{"from", range.from},
            {"to", range.to},
            {"scale", parameters::scale_names[static_cast<std::size_t>(range.scale)]}};
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
        if (io::is_required(field)) object["default"] = quantity->get(parameters::Case{});
        if (quantity->usual) object["usual"] = range_object(*quantity->usual);
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
    Json object{{"name", preset.name},
                {"title", c.title},
                {"case", Json::parse(io::case_json(c))},
                {"ranges", ranges_object(c)}};
    if (preset.study) object["chart"] = chart_of(*preset.study);
    return object;
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

// eigenvalues take the cube of the rows, and are not stopped: so many values of a quantity take some ten seconds
int most_stability_points(const parameters::Case& c) {
    constexpr int most = 2000;
    constexpr int least = 5;         // fewer are no curve
    constexpr double cubes = 2.5e7;  // [1] of rows, in that time
    const auto rows = static_cast<double>(parameters::coordinate_count(c));
    const double points = cubes / (rows * rows * rows);
    if (points < least)
        throw Error(ErrorKind::input, {"the stability of " + std::to_string(parameters::coordinate_count(c)) +
                                           " rows is not computed while you wait",
                                       "it takes the cube of them", "Run it on the command line: stridor stability."});
    return static_cast<int>(std::min(points, static_cast<double>(most)));
}

Json problem_object(const base::Problem& problem) {
    return {{"what", problem.what},
            {"why", problem.why},
            {"suggestion", problem.suggestion},
            {"key", key_in(problem.what)}};
}

}  // namespace

Json ranges_object(const parameters::Case& c) {
    Json object = Json::object();
    for (const std::string& key : parameters::quantity_keys(c)) {
        std::optional<parameters::UsualRange> range = parameters::usual_range(c, key);
        // of a velocity the magnitude: its sign is the direction
        if (range && range->to < 0.0) range = parameters::UsualRange{-range->to, -range->from, range->scale};
        if (range && range->from < range->to) object[key] = range_object(*range);
    }
    return object;
}

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
    const auto verdicts =
        classification::classify_phases(motion.record.phases, c.verdict, classification::contact_names(c));
    return json(io::simulation_json(c, motion, integration::cost(c), verdicts));
}

Response stability(const World& world, const Json& body, const std::stop_token&) {
    const parameters::Case c = case_in(world, body);
    const int most = most_stability_points(c);
    std::optional<analysis::ScanRange> range;
    if (body.contains("over")) {
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
