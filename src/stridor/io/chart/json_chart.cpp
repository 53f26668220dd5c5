#include "stridor/io/chart/json_chart.hpp"

#include "stridor/io/json_parts.hpp"
#include "stridor/sweep/boundaries.hpp"
#include "stridor/sweep/starts.hpp"

#include <utility>

namespace stridor::io {

namespace {

using namespace json_parts;
using parameters::Field;
using parameters::Quantity;

Json boundaries_array(const sweep::SweepResult& result) {
    Json array = Json::array();
    for (const sweep::Boundary& boundary : sweep::boundaries(result)) {
        const auto values = [&](double sweep::BoundaryVertex::*member) {
            return array_of(boundary.vertices, [&](const sweep::BoundaryVertex& vertex) { return vertex.*member; });
        };
        array.push_back(
            {{"direction", name_of(parameters::direction_names, result.study.directions[boundary.direction])},
             {"between", {boundary.first, boundary.second}},
             {"form", name_of(sweep::line_form_names, boundary.form)},
             {"x", values(&sweep::BoundaryVertex::x)},
             {"y", values(&sweep::BoundaryVertex::y)},
             {"x_resolution", values(&sweep::BoundaryVertex::x_resolution)},
             {"y_resolution", values(&sweep::BoundaryVertex::y_resolution)}});
    }
    return array;
}

// fills in what an inferred cell has not: figures, message, and the verdicts of single starts
void put_computed(Json& object, const sweep::SweepResult& result) {
    std::vector<std::pair<Json*, sweep::CellFigure>> figures;
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        figures.emplace_back(&object[std::string(figure.name)], figure);
    std::vector<Json*> starts;
    for (const parameters::Initial start : result.study.starts)
        starts.push_back(&object["starts"][std::string(name_of(sweep::start_names(), start))]);
    Json& message = object["message"];
    result.computed->visit(0, result.cells.size(), [&](const sweep::IndexedCell& computed) {
        const auto& [index, cell] = computed;
        for (const auto& [values, figure] : figures)
            (*values)[index] = figure_of(cell, figure);
        for (std::size_t start = 0; start < cell.starts.size(); ++start)
            (*starts[start])[index] = sweep::word(cell.starts[start]);
        if (!cell.message.empty()) message[index] = cell.message;
    });
}

Json cells_object(const sweep::SweepResult& result) {
    Json object = Json::object();
    const auto put = [&](const std::string& name, const auto& value_of) {
        object[name] = array_of(result.cells, value_of);
    };
    const Json nulls(Json::array_t(result.cells.size()));
    put("status", [](const sweep::CellVerdict& cell) { return name_of(sweep::status_names, cell.status); });
    put("category", [](const sweep::CellVerdict& cell) {
        return cell.status == sweep::Status::done ? Json(classification::name(cell.category)) : Json();
    });
    put("quiet_because", [](const sweep::CellVerdict& cell) { return quiet_word(cell.quiet); });
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        object[std::string(figure.name)] = nulls;
    Json& source = object["source"] = Json::array();
    for (std::size_t index = 0; index < result.cells.size(); ++index)
        source.push_back(sweep::source_names[sweep::is_inferred(result, index) ? 1 : 0]);
    if (!result.study.starts.empty())
        put("agreement",
            [](const sweep::CellVerdict& cell) { return name_of(sweep::agreement_names, cell.agreement); });
    for (const parameters::Initial start : result.study.starts)
        object["starts"][std::string(name_of(sweep::start_names(), start))] = nulls;
    object["message"] = nulls;
    put_computed(object, result);
    return object;
}

}  // namespace

std::string axis_json(const sweep::Axis& axis) {
    return base::text_of(axis_object(axis));
}

std::string chart_json(const sweep::SweepResult& result) {
    const sweep::Study& study = result.study;
    Json document = json_parts::opening("chart", study.base);
    const auto way = [](parameters::Direction each) { return name_of(parameters::direction_names, each); };
    const auto start = [](parameters::Initial each) { return name_of(sweep::start_names(), each); };
    document["chart"] = {{"x", axis_object(study.x)},
                         {"y", axis_object(study.y)},
                         {"directions", array_of(study.directions, way)},
                         {"quantities", study.quantities},
                         {"refine", study.refine}};
    if (!study.starts.empty()) document["chart"]["starts"] = array_of(study.starts, start);
    document["shape"] = {{"direction", study.directions.size()}, {"y", study.y.points}, {"x", study.x.points}};
    document["cells"] = cells_object(result);
    document["boundaries"] = boundaries_array(result);
    Json units = case_units(study.base);
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        units["cells." + std::string(figure.name)] = figure.unit;
    document["units"] = std::move(units);
    return base::text_of(document);
}

}  // namespace stridor::io
