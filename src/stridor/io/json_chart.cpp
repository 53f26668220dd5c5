#include "stridor/io/json_chart.hpp"

#include "stridor/io/json_parts.hpp"

#include <utility>

namespace stridor::io {

namespace {

using namespace json_parts;
using parameters::Field;
using parameters::Quantity;

std::string_view unit_of(const std::string& parameter) {
    const Field* field = parameters::find_field(parameter);
    const auto* quantity = field == nullptr ? nullptr : std::get_if<Quantity>(&field->kind);
    return quantity == nullptr ? std::string_view("1") : quantity->unit;
}

Json axis_object(const sweep::Axis& axis) {
    Json values = Json::array();
    for (int index = 0; index < axis.points; ++index)
        values.push_back(sweep::value_at(axis, index));
    return {{"parameter", axis.parameter}, {"unit", unit_of(axis.parameter)},
            {"from", axis.from},           {"to", axis.to},
            {"points", axis.points},       {"scale", name_of(sweep::scale_names, axis.scale)},
            {"values", std::move(values)}};
}

Json cells_object(const sweep::SweepResult& result) {
    Json object = Json::object();
    Json& status = object["status"] = Json::array();
    for (const sweep::Cell& cell : result.cells)
        status.push_back(name_of(sweep::status_names, cell.status));
    Json& category = object["category"] = Json::array();
    for (const sweep::Cell& cell : result.cells) {
        const bool is_done = cell.status == sweep::Status::done;
        category.push_back(is_done ? Json(classification::name(cell.category)) : Json());
    }
    for (const sweep::CellFigure& figure : sweep::cell_figures()) {
        Json& values = object[std::string(figure.name)] = Json::array();
        for (const sweep::Cell& cell : result.cells)
            values.push_back(cell.*figure.member);
    }
    Json& message = object["message"] = Json::array();
    for (const sweep::Cell& cell : result.cells)
        message.push_back(cell.message.empty() ? Json() : Json(cell.message));
    return object;
}

}  // namespace

std::string chart_json(const sweep::SweepResult& result) {
    const sweep::Study& study = result.study;
    Json document = opening("chart", study.base);
    Json directions = Json::array();
    for (const parameters::Direction direction : study.directions)
        directions.push_back(name_of(parameters::direction_names, direction));
    document["chart"] = {{"x", axis_object(study.x)},
                         {"y", axis_object(study.y)},
                         {"directions", std::move(directions)},
                         {"quantities", study.quantities}};
    document["shape"] = {{"direction", study.directions.size()}, {"y", study.y.points}, {"x", study.x.points}};
    document["cells"] = cells_object(result);
    Json units = case_units(study.base);
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        units["cells." + std::string(figure.name)] = figure.unit;
    document["units"] = std::move(units);
    return text_of(document);
}

}  // namespace stridor::io
