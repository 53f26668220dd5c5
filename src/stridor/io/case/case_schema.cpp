#include "stridor/io/case/case_schema.hpp"

#include "stridor/base/json.hpp"
#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/io/case/own_structure/toml_structure.hpp"
#include "stridor/io/case/toml_case.hpp"
#include "stridor/io/case/toml_writer.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/fields/spring_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"
#include "stridor/sweep/cell.hpp"
#include "stridor/sweep/starts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace stridor::io {

namespace {

using base::Json;
using parameters::Case;
using parameters::Choice;
using parameters::Quantity;

// does a file have to say it, whatever else it says?
bool is_always_required(const parameters::Field& field) {
    const parameters::Field& kind = *parameters::find_field("drive.kind");
    const auto& choice = std::get<Choice>(kind.kind);
    for (std::size_t index = 0; index < choice.names.size(); ++index) {
        Case c;
        choice.set(c, static_cast<int>(index));
        if (!field.belongs(c)) return false;
    }
    return is_required(field);
}

std::string description(const parameters::Field& field) {
    std::string text(field.sentence);
    if (!field.symbol.empty()) text += " (" + std::string(field.symbol) + ")";
    const std::string values = std::holds_alternative<Quantity>(field.kind) ? describe_values(field) : std::string();
    return values.empty() ? text : text + "; " + values;
}

Json field_schema(const parameters::Field& field) {
    Json schema{{"description", description(field)}};
    if (const auto* quantity = std::get_if<Quantity>(&field.kind)) {
        schema["type"] = {"number", "string"};
        const bool is_open = quantity->range.low_end == parameters::Range::Low::open;
        if (std::isfinite(quantity->range.low)) schema[is_open ? "exclusiveMinimum" : "minimum"] = quantity->range.low;
        if (std::isfinite(quantity->range.high)) schema["maximum"] = quantity->range.high;
        if (quantity->range.zero == parameters::Range::Zero::excluded) schema["not"] = {{"const", 0}};
        const Case defaults;
        if (!is_required(field) && !parameters::is_of_builder(field)) schema["default"] = quantity->get(defaults);
    } else if (const auto* choice = std::get_if<Choice>(&field.kind)) {
        schema["enum"] = choice->names;
    } else {
        schema["type"] = "string";
    }
    return schema;
}

// which further keys [drive] needs for each kind of drive
Json drive_conditions() {
    const auto& kinds = std::get<Choice>(parameters::find_field("drive.kind")->kind);
    Json conditions = Json::array();
    for (std::size_t index = 0; index < kinds.names.size(); ++index) {
        Case c;
        kinds.set(c, static_cast<int>(index));
        Json needed = Json::array();
        for (const parameters::Field& field : parameters::fields())
            if (field.section == "drive" && field.belongs(c)) needed.push_back(field.name);
        conditions.push_back({{"if", {{"properties", {{"kind", {{"const", kinds.names[index]}}}}}}},
                              {"then", {{"required", std::move(needed)}}}});
    }
    return conditions;
}

Json section_schema() {
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", Json::array()},
            {"properties", Json::object()}};
}

Json list_schema(const std::string& about) {
    return {{"description", about}, {"type", "array"}, {"minItems", 2}, {"items", {{"type", {"number", "string"}}}}};
}

// the lists beside temperature.value, under every name that means one property
void add_temperature_lists(Json& section) {
    section["required"] = {"value"};
    Json& properties = section["properties"];
    properties["at"] = list_schema("temperatures at which the lists below have their values, rising; degC");
    for (const std::string_view key : parameters::keys_over_temperature()) {
        const parameters::Field& field = *parameters::find_field(key);
        const Json list = list_schema(std::string(field.sentence) + ", at each temperature");
        properties[std::string(parameters::short_name(field))] = list;
        properties[std::string(field.symbol)] = list;
        Json& nested = properties[std::string(field.section)];
        if (nested.is_null()) nested = {{"type", "object"}, {"additionalProperties", false}};
        nested["properties"][std::string(field.name)] = list;
    }
    // of several joints each by its name
    Json named = properties["joint"];
    named["properties"]["contact"] = properties["contact"];
    for (const std::string_view key : parameters::keys_over_temperature()) {
        const parameters::Field& field = *parameters::find_field(key);
        if (!parameters::is_of_joint(field)) continue;
        for (const std::string_view name : {parameters::short_name(field), field.symbol})
            named["properties"][std::string(name)] = properties[std::string(name)];
    }
    properties["joint"]["additionalProperties"] = std::move(named);
}

// without a pair of materials, that knows temperatures of its own, lists belong to a temperature
Json lists_without_pair() {
    const Json pair{{"required", Json::array({"contact"})},
                    {"properties", {{"contact", {{"required", Json::array({"pair"})}}}}}};
    const Json of_a_joint{{"required", Json::array({"joint"})},
                          {"properties", {{"joint", {{"type", "array"}, {"contains", pair}}}}}};
    return {{"if", {{"not", {{"anyOf", {pair, of_a_joint}}}}}},
            {"then", {{"properties", {{"temperature", {{"required", Json::array({"at"})}}}}}}}};
}

bool may_follow_temperature(const parameters::Field& field) {
    const auto keys = parameters::keys_over_temperature();
    return std::find(keys.begin(), keys.end(), parameters::key_of(field)) != keys.end();
}

// what a file without [temperature] has to say besides
Json without_temperature() {
    Json sections = Json::object();
    for (const std::string_view key : parameters::keys_over_temperature()) {
        const parameters::Field& field = *parameters::find_field(key);
        if (is_always_required(field)) sections[std::string(field.section)]["required"].push_back(field.name);
    }
    // likewise each of several joints
    sections["joint"]["items"] = {{"required", sections["joint"]["required"]},
                                  {"properties", {{"contact", sections["contact"]}}}};
    return {{"properties", std::move(sections)}};
}

Json axis_schema() {
    Json schema = section_schema();
    schema["required"] = {"parameter", "from", "to", "points"};
    schema["properties"] = {{"parameter", {{"enum", parameters::quantity_keys()}}},
                            {"from", {{"type", {"number", "string"}}}},
                            {"to", {{"type", {"number", "string"}}}},
                            {"points", {{"type", "integer"}, {"minimum", 2}}},
                            {"scale", {{"enum", sweep::scale_names}, {"default", "linear"}}}};
    return schema;
}

Json chart_schema() {
    Json quantities = Json::array({"category"});
    for (const sweep::CellFigure& figure : sweep::cell_figures())
        quantities.push_back(figure.name);
    Json schema = section_schema();
    schema["description"] = "a noise chart: two quantities as axes, one cell per pair of values and direction";
    schema["required"] = {"x", "y"};
    schema["properties"] = {
        {"x", axis_schema()},
        {"y", axis_schema()},
        {"directions", {{"type", "array"}, {"minItems", 1}, {"items", {{"enum", parameters::direction_names}}}}},
        {"quantities", {{"type", "array"}, {"items", {{"enum", std::move(quantities)}}}}},
        {"refine", {{"type", "integer"}, {"minimum", 0}, {"maximum", sweep::most_refinement}, {"default", 0}}},
        {"starts", {{"type", "array"}, {"items", {{"enum", sweep::start_names()}}}}}};
    return schema;
}

// [joint] with [contact], or [[joint]] tables, each with its name and its [joint.contact]
void allow_several_joints(Json& document) {
    Json& properties = document["properties"];
    Json contact = properties["contact"];
    Json each = properties["joint"];
    each["properties"]["name"] = {{"type", "string"}, {"pattern", "^[A-Za-z0-9_-]+$"}};
    each["properties"]["contact"] = std::move(contact);
    each["required"].push_back("name");
    each["required"].push_back("contact");
    Json one = properties["joint"];
    properties["joint"] = {
        {"oneOf", {std::move(one), {{"type", "array"}, {"minItems", 1}, {"items", std::move(each)}}}}};
    Json& required = document["required"];
    required.erase(std::find(required.begin(), required.end(), "contact"));
    document["allOf"] = {{{"if", {{"properties", {{"joint", {{"type", "object"}}}}}}},
                          {"then", {{"required", Json::array({"contact"})}}},
                          {"else", {{"not", {{"required", Json::array({"contact"})}}}}}}};
}

Json list_of(Json item) {
    return {{"type", "array"}, {"items", std::move(item)}};
}

// the keys of [structure] and its tables, beside the fields; which belong together the reader says
void add_structure_keys(Json& section) {
    const Json number{{"type", {"number", "string"}}};
    const Json text{{"type", {"string", "number"}}};
    const Json direction{{"oneOf", {{{"type", "string"}}, list_of({{"type", "number"}})}}};
    Json builders = Json::array();
    Json& properties = section["properties"];
    const Json matrix{{"oneOf", {{{"type", {"number", "string"}}}, list_of(list_of({{"type", "number"}}))}}};
    for (const std::string_view key : structure_keys(StructureKeys::numbers))
        properties[std::string(key)] = number;
    for (const StructureBuilder& builder : structure_builders()) {
        builders.push_back(builder.name);
        for (const BuilderKey& key : builder.keys)
            if (key.holds != BuilderKey::Holds::quantity)
                properties[std::string(key.name)] = {{"description", sentence_of(key)}, {"type", {"number", "string"}}};
    }
    for (const std::string_view key : structure_keys(StructureKeys::matrices))
        properties[std::string(key)] = matrix;
    for (const std::string_view key : structure_keys(StructureKeys::lists))
        properties[std::string(key)] = list_of({{"type", "number"}});
    for (const std::string_view key : structure_keys(StructureKeys::texts))
        properties[std::string(key)] = {{"oneOf", {{{"type", "string"}}, list_of({{"type", "string"}})}}};
    properties["builder"] = {{"enum", std::move(builders)}};
    Json contact = section_schema();
    for (const std::string_view key : structure_keys(StructureKeys::of_contact))
        contact["properties"][std::string(key)] = text;
    for (const parameters::ContactField& field : parameters::contact_fields()) {
        Json& property = contact["properties"][std::string(field.key)];
        if (std::holds_alternative<std::vector<double> parameters::OwnContact::*>(field.member)) property = direction;
        if (std::holds_alternative<std::optional<std::array<double, 3>> parameters::OwnContact::*>(field.member))
            property = list_of({{"type", "number"}});
        const bool has_unit = !field.unit.empty() && field.unit != "1";
        property["description"] = std::string(field.sentence) + (has_unit ? "; " + std::string(field.unit) : "");
        if (field.need == parameters::ContactField::Need::required) contact["required"].push_back(field.key);
    }
    properties["contact"] = list_of(std::move(contact));
    Json output = section_schema();
    for (const std::string_view key : structure_keys(StructureKeys::of_output))
        output["properties"][std::string(key)] = text;
    output["properties"]["direction"] = direction;
    output["required"] = {"direction"};
    properties["output"] = list_of(std::move(output));
    Json spring = section_schema();
    for (const std::string_view key : structure_keys(StructureKeys::of_spring))
        spring["properties"][std::string(key)] = text;
    for (const parameters::SpringField& field : parameters::spring_fields()) {
        Json& property = spring["properties"][std::string(field.key)];
        if (field.key == "direction") property = direction;
        if (field.key == "interpolation") property = {{"enum", parameters::interpolation_names}};
        const bool has_unit = !field.unit.empty() && field.unit != "1";
        property["description"] = std::string(field.sentence) + (has_unit ? "; " + std::string(field.unit) : "");
    }
    spring["required"] = {"direction"};
    properties["spring"] = list_of(std::move(spring));
}

// [structure] in the place of [joint] and [plate]
void allow_own_structure(Json& document) {
    add_structure_keys(document["properties"]["structure"]);
    Json& required = document["required"];
    for (const char* section : {"joint", "plate"})
        required.erase(std::find(required.begin(), required.end(), section));
    Json& contact = document["properties"]["contact"]["required"];
    contact.erase(std::find(contact.begin(), contact.end(), "preload"));
    const auto has = [](const char* section) { return Json{{"required", Json::array({section})}}; };
    document["allOf"].push_back(
        {{"if", has("structure")},
         {"then", {{"not", {{"anyOf", {has("joint"), has("plate"), has("temperature")}}}}}},
         {"else", {{"required", {"joint", "plate"}}, {"properties", {{"contact", has("preload")}}}}}});
}

}  // namespace

std::string json_schema() {
    Json document{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                  {"title", "Stridor case"},
                  {"description", "A rubbing system, its drive, run and thresholds; with [chart] a noise chart"}};
    document.update(section_schema());
    Json& properties = document["properties"];
    for (const parameters::Field& field : parameters::fields()) {
        if (field.section.empty()) {
            properties[std::string(field.name)] = field_schema(field);
            continue;
        }
        const std::string name(field.section);
        if (!properties.contains(name)) properties[name] = section_schema();
        Json& section = properties[name];
        section["properties"][std::string(field.name)] = field_schema(field);
        if (is_always_required(field) && !may_follow_temperature(field)) section["required"].push_back(field.name);
    }
    for (const auto& [name, section] : properties.items())
        if (section.contains("required") && !section["required"].empty()) document["required"].push_back(name);
    add_temperature_lists(properties["temperature"]);
    properties["drive"]["allOf"] = drive_conditions();
    properties["chart"] = chart_schema();
    properties["document"] = section_schema();
    for (const char* key : {"author", "part"})
        properties["document"]["properties"][key] = {{"type", "string"}};
    allow_several_joints(document);
    allow_own_structure(document);
    document["allOf"].push_back(lists_without_pair());
    // last: they move what stands before
    document["if"] = {{"not",
                       {{"anyOf",
                         {{{"required", Json::array({"temperature"})}},
                          {{"required", Json::array({"structure"})}},
                          {{"required", Json::array({"contact"})},
                           {"properties", {{"contact", {{"required", Json::array({"pair"})}}}}}}}}}}};
    document["then"] = without_temperature();
    return document.dump(2);
}

}  // namespace stridor::io
