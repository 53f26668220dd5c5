#include "stridor/io/case/own_structure/structure_springs.hpp"

#include "stridor/base/error.hpp"
#include "stridor/parameters/fields/spring_field.hpp"
#include "stridor/parameters/tables/force_table.hpp"
#include "stridor/recordings/table/sampled_csv.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace stridor::io {

namespace {

using parameters::ForceTable;
using parameters::Interpolation;
using parameters::OwnSpring;
using parameters::SpringField;

ForceTable table_in(const TomlSection& table, std::string_view key) {
    const TomlEntry& entry = table.need(key);
    try {
        ForceTable found = parameters::parse_force_table(table.text(key));
        if (found.file.empty()) return found;
        recordings::SampledForce rows = recordings::read_force_file(table.path(entry, found.file));
        found = {"", std::move(rows.deflections), std::move(rows.forces)};
        parameters::expect_rising(found);
        return found;
    } catch (const Error& error) {
        if (error.place()) throw;
        throw located(error, entry.key, entry.value_place);
    }
}

Interpolation interpolation_in(const TomlSection& table, std::string_view key) {
    const std::string name = table.text(key);
    const auto& names = parameters::interpolation_names;
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw Error(ErrorKind::input,
                    {"\"" + name + "\" is no interpolation", "there are \"cubic\" and \"linear\"", ""},
                    table.need(key).value_place);
    return static_cast<Interpolation>(found - names.begin());
}

// all but its direction
OwnSpring said_in(const TomlSection& table) {
    OwnSpring spring;
    for (const SpringField& field : parameters::spring_fields()) {
        if (!table.has(field.key)) continue;
        const auto read = [&](auto& into) {
            using Value = std::decay_t<decltype(into)>;
            if constexpr (std::is_same_v<Value, std::string>)
                into = table.text(field.key);
            else if constexpr (std::is_same_v<Value, double>)
                into = table.quantity(field.key, field.unit, field.range.low < 0.0 ? Bound::any : Bound::not_negative);
            else if constexpr (std::is_same_v<Value, ForceTable>)
                into = table_in(table, field.key);
            else if constexpr (std::is_same_v<Value, Interpolation>)
                into = interpolation_in(table, field.key);
        };
        std::visit([&](auto member) { read(spring.*member); }, field.member);
    }
    return spring;
}

NamedOutput where_in(const TomlSection& table, const std::string& name, std::string_view node) {
    const TomlEntry& entry = table.need("direction");
    const auto* words = std::get_if<std::string>(&entry.value);
    NamedDirection direction;
    if (words != nullptr)
        direction = *words;
    else
        direction = table.numbers("direction");
    return {name, table.text_or(node, ""), std::move(direction), table.place()};
}

// between two nodes, along one direction at both
void subtract_other_node(OwnSpring& spring, const TomlSection& table, const reduction::ElasticPart& part) {
    if (!table.has("node"))
        throw Error(
            ErrorKind::input,
            {"the spring is against a node, and at none", "", "Say between which rows it is: direction = \"y1 -y2\"."},
            table.need("against").value_place);
    const std::vector<double> other = rows_along(part, where_in(table, "", "against"));
    for (std::size_t row = 0; row < other.size(); ++row)
        spring.direction[row] -= other[row];
    if (std::all_of(spring.direction.begin(), spring.direction.end(), [](double d) { return d == 0.0; }))
        throw Error(ErrorKind::input, {"the spring is from a node to itself", "nothing stretches it", ""},
                    table.need("against").value_place);
}

bool is_pressed_otherwise(const parameters::OwnStructure& own) {
    return std::none_of(own.contacts.begin(), own.contacts.end(),
                        [](const parameters::OwnContact& contact) { return contact.preload_share > 0.0; });
}

}  // namespace

std::span<const std::string_view> spring_keys() {
    static const std::vector<std::string_view> keys = [] {
        std::vector<std::string_view> all{"node", "against"};
        for (const SpringField& field : parameters::spring_fields())
            all.push_back(field.key);
        return all;
    }();
    return keys;
}

std::vector<OwnSpring> springs_in(const TomlDocument& document, const reduction::ElasticPart& part,
                                  const parameters::OwnStructure& own) {
    std::vector<OwnSpring> springs;
    for (std::size_t number = 1;; ++number) {
        const std::string key = std::string(spring_opening) + std::to_string(number);
        if (document.find(key) == nullptr) return springs;
        const TomlSection table(document, key + ".");
        const auto refuse = [&](const base::Problem& problem) {
            return Error(ErrorKind::input, problem, table.place());
        };
        OwnSpring spring = said_in(table);
        const NamedOutput where = where_in(table, spring.name, "node");
        spring.name = name_of(where, "spring" + std::to_string(number));
        spring.direction = rows_along(part, where);
        if (table.has("against")) subtract_other_node(spring, table, part);
        if (const std::optional<base::Problem> problem = parameters::problem_of(spring)) throw refuse(*problem);
        if (spring.preload_share > 0.0 && is_pressed_otherwise(own))
            throw refuse({"spring \"" + spring.name + "\" has a share of the preload, and there is none",
                          "a load or negative gaps press the structure", "Take the share out."});
        for (const OwnSpring& other : springs)
            if (other.name == spring.name)
                throw refuse({"two springs are called \"" + spring.name + "\"", "", "Give each a name of its own."});
        springs.push_back(std::move(spring));
    }
}

}  // namespace stridor::io
