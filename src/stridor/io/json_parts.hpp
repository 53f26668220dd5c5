#pragma once

// What all JSON documents share. Private to this folder, so that nlohmann's types stay out of other headers.

#include "stridor/base/json.hpp"
#include "stridor/base/version.hpp"
#include "stridor/classification/verdict.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/sound_thresholds.hpp"
#include "stridor/parameters/fields/spring_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/system.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"
#include "stridor/sweep/study.hpp"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::io::json_parts {

using base::Json;

/// Returns the word of an enumerator: `names` are in the order of the enumeration.
template <typename Enumeration>
std::string_view name_of(std::span<const std::string_view> names, Enumeration value) {
    return names[static_cast<std::size_t>(value)];
}

/// Returns the items of a list, each as `object` makes it.
template <typename Items, typename Object>
Json array_of(const Items& items, const Object& object) {
    Json array = Json::array();
    for (const auto& item : items)
        array.push_back(object(item));
    return array;
}

/// Returns values by their names, in the order of these.
template <typename Values>
Json named(std::span<const std::string_view> names, const Values& values) {
    Json object = Json::object();
    for (std::size_t k = 0; k < names.size(); ++k)
        object[std::string(names[k])] = values[k];
    return object;
}

/// Returns the beginning of every document: schema, version, commit.
inline Json opening(std::string_view what) {
    return {
        {"schema", "stridor." + std::string(what) + "/1"}, {"version", base::version()}, {"commit", base::commit()}};
}

/// Returns why a contact is quiet; null if it is not.
inline Json quiet_word(classification::Quiet quiet) {
    return quiet == classification::Quiet::no ? Json() : Json(classification::name(quiet));
}

// the members of a section, or of all but [joint] and [contact], that belong to a case
inline void put_fields(Json& object, parameters::CaseView at, bool (*is_wanted)(const parameters::Field&)) {
    for (const parameters::Field& field : parameters::fields()) {
        if (!field.belongs(at) || !is_wanted(field)) continue;
        Json& section = field.section.empty() ? object : object[std::string(field.section)];
        const std::string name(field.name);
        if (std::holds_alternative<parameters::Quantity>(field.kind))
            section[name] = parameters::get_quantity(at, field);
        else
            section[name] = parameters::value_text(at, field);
    }
}

// of several joints a list, each with its name and its contact
inline Json joints_array(const parameters::Case& c) {
    Json joints = Json::array();
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        Json parts = Json::object();
        put_fields(parts, {c, k}, parameters::is_of_joint);
        Json joint{{"name", parameters::joint_name(c, k)}};
        joint.update(parts["joint"]);
        joint["contact"] = parts["contact"];
        joints.push_back(std::move(joint));
    }
    return joints;
}

// what an own structure is, beside its fields: not its matrices, but their hash
inline void put_own_structure(Json& object, const parameters::Case& c) {
    const parameters::OwnStructure& own = *c.own_structure;
    Json contacts = Json::array();
    const std::vector<double> places = parameters::places_along_line(own);
    for (std::size_t k = 0; k < own.contacts.size(); ++k) {
        const parameters::Contact laws = parameters::contact_of(c, k);
        Json contact = Json::object();
        for (const parameters::ContactField& field : parameters::contact_fields()) {
            if (!is_shown(field)) continue;
            const std::string key(field.key);
            const parameters::ContactValue value = value_of(own.contacts[k], field);
            const auto* words = std::get_if<std::string>(&value);
            if (field.key == "preload_share") {
                if (parameters::is_preloaded(c)) contact["preload"] = laws.preload;
            } else if (field.in_place_of != nullptr) {
                contact[key] = laws.*field.in_place_of;  // the case's, where the contact has none of its own
            } else if (const auto* number = std::get_if<double>(&value)) {
                contact[key] = *number;
            } else if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
                contact[key] = *numbers;
            } else if (words != nullptr && (field.key == "name" || !words->empty())) {
                contact[key] = *words;
            }
        }
        if (!places.empty()) contact["along_line"] = places[k];
        contacts.push_back(std::move(contact));
    }
    object["origin"] = own.origin;
    object["content"] = parameters::content_hash(own);
    object["rows"] = own.row;
    object["contacts"] = std::move(contacts);
    for (const parameters::OwnOutput& output : own.outputs)
        object["outputs"].push_back(output.name);
    for (const parameters::OwnSpring& each : own.springs) {
        Json spring = Json::object();
        for (const parameters::SpringField& field : parameters::spring_fields())
            if (field.key != "direction" && !is_usual(each, field))
                std::visit([&](const auto& value) { spring[std::string(field.key)] = value; }, value_of(each, field));
        object["springs"].push_back(std::move(spring));
    }
}

/// Returns a case by sections and names: quantities as numbers in their units, all else as text. Fields without a
/// meaning for the case are left out.
inline Json case_object(const parameters::Case& c) {
    Json object = Json::object();
    if (!parameters::has_several_joints(c)) {
        put_fields(object, c, [](const parameters::Field&) { return true; });
    } else {
        put_fields(object, c, [](const parameters::Field& field) { return !parameters::is_of_joint(field); });
        object["joint"] = joints_array(c);
    }
    if (c.own_structure) put_own_structure(object["structure"], c);
    if (!parameters::has_temperature_table(c)) return object;
    object["temperature"]["at"] = c.temperature.at;
    for (const parameters::TemperatureColumn& column : c.temperature.columns) {
        Json& values = object["temperature"][column.key];
        if (column.holds == parameters::TemperatureColumn::Holds::damping_ratio)
            values = parameters::value_texts(column);
        else
            values = column.values;
    }
    return object;
}

/// Returns the units of a case by their place in a document: "case.joint.mass": "kg".
inline Json case_units(const parameters::Case& c) {
    Json units = Json::object();
    for (const parameters::Field& field : parameters::fields())
        if (const auto* quantity = std::get_if<parameters::Quantity>(&field.kind);
            quantity != nullptr && field.belongs(c))
            units["case." + parameters::key_of(field)] = quantity->unit;
    if (c.own_structure) {
        const std::string contacts = "case.structure.contacts.";
        for (const parameters::ContactField& field : parameters::contact_fields()) {
            const bool has_unit = !field.unit.empty() && field.unit != "1";
            if (field.key == "preload_share") units[contacts + "preload"] = "N";
            if (has_unit && is_shown(field)) units[contacts + std::string(field.key)] = field.unit;
        }
        units[contacts + "along_line"] = "m";
    }
    if (parameters::has_temperature_table(c)) units["case.temperature.at"] = parameters::unit_of("temperature.value");
    for (const parameters::TemperatureColumn& column : c.temperature.columns)
        if (column.holds == parameters::TemperatureColumn::Holds::quantity)
            units["case.temperature." + column.key] = parameters::unit_of(column.key);
    return units;
}

/// Returns margins, each figure beside its threshold.
inline Json margins_array(std::span<const classification::Margin> margins) {
    return array_of(margins, [](const classification::Margin& margin) {
        Json object{{"threshold", margin.threshold_name},
                    {"figure", margin.figure_name},
                    {"value", margin.figure},
                    {"threshold_value", margin.threshold},
                    {"distance", margin.distance}};
        if (margin.error) object["error"] = *margin.error;
        return object;
    });
}

/// Returns thresholds by ear, by their names.
inline Json thresholds_object(const parameters::SoundThresholds& thresholds) {
    Json object = Json::object();
    for (const parameters::SoundThreshold& threshold : parameters::sound_thresholds())
        object[std::string(threshold.name)] = thresholds.*(threshold.member);
    return object;
}

/// Returns an axis with its unit and all its values.
inline Json axis_object(const sweep::Axis& axis) {
    Json values = Json::array();
    for (int index = 0; index < axis.points; ++index)
        values.push_back(sweep::value_at(axis, index));
    return {{"parameter", axis.parameter}, {"unit", parameters::unit_of(axis.parameter)},
            {"from", axis.from},           {"to", axis.to},
            {"points", axis.points},       {"scale", name_of(sweep::scale_names, axis.scale)},
            {"values", std::move(values)}};
}

/// Returns the beginning of every document about a case: schema, version, commit, case.
inline Json opening(std::string_view what, const parameters::Case& c) {
    Json document = opening(what);
    document["case"] = case_object(c);
    return document;
}

}  // namespace stridor::io::json_parts
