#include "stridor/io/case/case_document.hpp"

#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/fields/contact_field.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/fields/spring_field.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/own_structure.hpp"
#include "stridor/parameters/tables/material_pair.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace stridor::io {

namespace {

using parameters::Case;
using parameters::CaseView;
using parameters::ContactField;
using parameters::Field;
using parameters::OwnStructure;

TomlValue value_in(CaseView at, const Field& field) {
    const bool is_number = std::holds_alternative<parameters::Quantity>(field.kind);
    if (is_number && !damping_ratio(at, field)) return get_quantity(at, field);
    return value_text(at, field);
}

TomlValue value_in(const parameters::OwnContact& contact, const ContactField& field) {
    const parameters::ContactValue value = value_of(contact, field);
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* words = std::get_if<std::string>(&value)) return *words;
    return std::get<std::vector<double>>(value);
}

TomlValue value_in(const parameters::OwnSpring& spring, const parameters::SpringField& field) {
    return std::visit([](auto value) { return TomlValue(std::move(value)); }, value_of(spring, field));
}

TomlRows rows_of(std::span<const double> matrix, std::size_t rows) {
    TomlRows lists;
    for (std::size_t row = 0; row < rows; ++row) {
        const auto numbers = matrix.subspan(row * rows, rows);
        lists.emplace_back(numbers.begin(), numbers.end());
    }
    return lists;
}

/// Puts one entry of a case behind the other.
class Entries {
public:
    Entries(const Case& c, CaseDepth depth) : c_(c), depth_(depth) {}

    TomlDocument all() {
        // behind the title, several joints come first
        add_fields([](const Field& field) { return field.section.empty(); });
        add_fields([](const Field& field) { return !field.section.empty(); });
        if (c_.own_structure && (c_.own_structure->recipe || depth_ != CaseDepth::fields))
            add_tables(*c_.own_structure);
        return std::move(document_);
    }

private:
    void add(std::string_view key, TomlValue value) {
        document_.entries.push_back({table_ + std::string(key), std::move(value), TomlOrigin::file, {}, {}});
    }

    void open(const std::string& table) {
        table_ = table;
        add("", TomlTable{});
        table_ += ".";
    }

    // the next of a list of tables
    void open_next(const std::string& list, std::size_t number) {
        if (number == 0) open(list);
        open(list + "." + std::to_string(number + 1));
    }

    // what a builder takes is said by its recipe; what follows the temperature, by its table
    bool has_entry(CaseView at, const Field& field) const {
        if (parameters::follows_table(at, field) || is_of_builder(field)) return false;
        // an empty title of several joints is none
        if (field.section.empty() && parameters::has_several_joints(c_) && c_.title.empty()) return false;
        if (depth_ == CaseDepth::whole_and_idle && !field.belongs(at)) return !home_of(at, field).empty();
        return field.belongs(at) && (depth_ == CaseDepth::whole_and_idle || !goes_without_saying(at, field));
    }

    void add_fields(bool (*is_wanted)(const Field&)) {
        std::string_view section;
        for (const auto& [field, at, key] : parameters::fields_of(c_)) {
            if (!is_wanted(field) || !has_entry(at, field)) continue;
            joint_ = parameters::has_key_of_joint(c_, field) ? std::optional(at.joint) : std::nullopt;
            if (field.section != section) open_section(field.section);
            section = field.section;
            add(field.name, value_in(at, field));
            if (section == "temperature") add_temperature_table();
        }
    }

    void open_section(std::string_view section) {
        if (!joint_) return open_shared(std::string(section));
        if (section == "contact") return open("joint." + std::to_string(*joint_ + 1) + ".contact");
        open_next("joint", *joint_);
        add("name", c_.joints[*joint_].name);
    }

    void open_shared(const std::string& section) {
        open(section);
        if (section != "structure") return;
        const OwnStructure& own = *c_.own_structure;
        if (own.recipe)
            add_recipe(own);
        else if (depth_ != CaseDepth::fields)
            add_matrices(own);
    }

    void add_temperature_table() {
        if (!parameters::has_temperature_table(c_)) return;  // a pair follows the temperature
        add("at", c_.temperature.at);
        for (const parameters::TemperatureColumn& column : c_.temperature.columns)
            if (column.holds == parameters::TemperatureColumn::Holds::damping_ratio)
                add(column.key, parameters::value_texts(column));
            else
                add(column.key, column.values);
    }

    void add_list(std::string_view key, const std::vector<double>& numbers) {
        if (!numbers.empty()) add(key, numbers);
    }

    void add_recipe(const OwnStructure& own) {
        add("builder", own.recipe->builder);
        for (const BuilderKey& key : builder_keys(own.recipe->builder)) {
            if (const auto found = own.recipe->numbers.find(key.name); found != own.recipe->numbers.end())
                add(key.name, found->second);
            if (const auto found = own.recipe->words.find(key.name); found != own.recipe->words.end())
                add(key.name, found->second);
        }
        add_list("force", own.force);
        add_list("initial_displacement", own.initial_displacement);
        if (parameters::has_given_velocity(own)) add_list("initial_velocity", own.initial_velocity);
    }

    void add_matrices(const OwnStructure& own) {
        const std::pair<std::string_view, const std::vector<double>&> matrices[] = {
            {"mass", own.mass}, {"stiffness", own.stiffness}, {"damping", own.damping}};
        const std::pair<std::string_view, double> numbers[] = {{"damping_ratio", own.following.ratio},
                                                               {"loss_factor", own.following.loss_factor},
                                                               {"rayleigh_mass", own.following.rayleigh_mass},
                                                               {"rayleigh_stiffness", own.following.rayleigh_stiffness},
                                                               {"left_out_above", own.left_out_above}};
        add("rows", own.row);
        for (const auto& [key, matrix] : matrices)
            if (!matrix.empty()) add(key, rows_of(matrix, own.row.size()));
        for (const auto& [key, number] : numbers)
            if (number != 0.0) add(key, number);
        add_list("load", own.load);
        add_list("force", own.force);
        add_list("initial_displacement", own.initial_displacement);
        add_list("initial_velocity", own.initial_velocity);
    }

    // a builder makes its contacts, and neither outputs nor springs
    void add_tables(const OwnStructure& own) {
        for (std::size_t k = 0; !own.recipe && k < own.contacts.size(); ++k) {
            open_next("structure.contact", k);
            for (const ContactField& field : parameters::contact_fields()) {
                const bool is_always_there = field.key == "name" || field.need == ContactField::Need::required;
                if (is_always_there || !is_usual(own.contacts[k], field))
                    add(field.key, value_in(own.contacts[k], field));
            }
        }
        for (std::size_t k = 0; k < own.outputs.size(); ++k) {
            open_next("structure.output", k);
            add("name", own.outputs[k].name);
            add("direction", own.outputs[k].weights);
        }
        for (std::size_t k = 0; k < own.springs.size(); ++k) {
            open_next("structure.spring", k);
            for (const parameters::SpringField& field : parameters::spring_fields())
                if (!is_usual(own.springs[k], field)) add(field.key, value_in(own.springs[k], field));
        }
    }

    const Case& c_;
    CaseDepth depth_;
    TomlDocument document_{"the case", {}};
    std::string table_;                   // that is open, with a point behind it
    std::optional<std::size_t> joint_{};  // of several, whose fields are added
};

}  // namespace

TomlDocument document_of(const Case& c, CaseDepth depth) {
    return Entries(c, depth).all();
}

}  // namespace stridor::io
