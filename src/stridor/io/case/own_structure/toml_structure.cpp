#include "stridor/io/case/own_structure/toml_structure.hpp"

#include "stridor/base/decompositions.hpp"
#include "stridor/base/text.hpp"
#include "stridor/io/case/own_structure/built_structure.hpp"
#include "stridor/io/case/own_structure/contacts_csv.hpp"
#include "stridor/io/case/own_structure/structure_springs.hpp"
#include "stridor/io/case/own_structure/toml_section.hpp"
#include "stridor/parameters/fields/field.hpp"
#include "stridor/parameters/tables/force_table.hpp"
#include "stridor/reduction/lowest_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stridor::io {

namespace {

using parameters::ContactField;
using parameters::OwnStructure;
using reduction::ElasticPart;

constexpr std::string_view section_name = "structure";
constexpr std::string_view opening = "structure.";
constexpr std::string_view contact_opening = "structure.contact.";
constexpr std::string_view output_opening = "structure.output.";

constexpr std::array<std::string_view, 3> matrix_keys{"mass", "stiffness", "damping"};
constexpr std::array<std::string_view, 5> number_keys{"damping_ratio", "loss_factor", "rayleigh_mass",
                                                      "rayleigh_stiffness", "left_out_above"};
constexpr std::array<std::string_view, 4> list_keys{"load", "force", "initial_displacement", "initial_velocity"};
constexpr std::array<std::string_view, 5> text_keys{"file", "units", "labels", "rows", "contacts"};
// what a builder leaves to others
constexpr std::array<std::string_view, 4> common_keys{"builder", "force", "initial_displacement", "initial_velocity"};
constexpr std::array<std::string_view, 3> output_keys{"name", "node", "direction"};

bool stands_below(std::string_view key, std::string_view prefix) {
    return key.size() > prefix.size() && key.starts_with(prefix);
}

// is it read with the fields of the case, not here?
bool is_read_as_field(std::string_view key) {
    const parameters::Field* field = parameters::find_field(key);
    return field != nullptr && !parameters::is_of_builder(*field);
}

std::vector<std::string_view> joined_keys(std::initializer_list<std::span<const std::string_view>> lists) {
    std::vector<std::string_view> all;
    for (const auto& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

const StructureBuilder* builder_of(const TomlSection& section) {
    if (!section.has("builder")) return nullptr;
    const std::string name = section.text("builder");
    std::string names;
    for (const StructureBuilder& builder : structure_builders()) {
        if (builder.name == name) return &builder;
        names += (names.empty() ? "\"" : ", \"") + std::string(builder.name) + "\"";
    }
    throw Error(ErrorKind::input, {"\"" + name + "\" builds no structure", "there are " + names, ""},
                section.need("builder").value_place);
}

void refuse_unknown(const TomlEntry& entry, std::string_view name, std::span<const std::string_view> known,
                    Complaints& complaints) {
    if (std::find(known.begin(), known.end(), name) != known.end()) return;
    const std::string near(base::nearest_name(name, known));
    const std::string section = entry.key.substr(0, entry.key.size() - name.size());
    complaints.add({ErrorKind::input,
                    {"unknown key " + entry.key, "", near.empty() ? "" : "Did you mean " + section + near + "?"},
                    entry.key_place});
}

// a list of tables, as [[structure.contact]]
struct ListedTable {
    std::string_view opening;  // "structure.contact."
    std::span<const std::string_view> keys;
};

bool is_of(const ListedTable& table, std::string_view key) {
    return key == table.opening.substr(0, table.opening.size() - 1) || stands_below(key, table.opening);
}

// keys that [structure] does not have, or not with this builder
void check_keys(const TomlDocument& document, const StructureBuilder* builder) {
    Complaints complaints;
    std::vector<std::string_view> known = joined_keys({common_keys});
    if (builder == nullptr) known = joined_keys({common_keys, matrix_keys, number_keys, list_keys, text_keys});
    for (std::size_t k = 0; builder != nullptr && k < builder->keys.size(); ++k)
        known.push_back(builder->keys[k].name);
    const std::array<ListedTable, 3> tables{
        ListedTable{contact_opening, contact_keys()}, {output_opening, output_keys}, {spring_opening, spring_keys()}};
    for (const TomlEntry& entry : document.entries) {
        if (!stands_below(entry.key, opening) || is_read_as_field(entry.key)) continue;
        const auto table =
            std::find_if(tables.begin(), tables.end(), [&](const ListedTable& each) { return is_of(each, entry.key); });
        if (table == tables.begin() && builder != nullptr) {
            complaints.add({ErrorKind::input,
                            {"[[structure.contact]] stands beside a builder", "a builder makes its own contacts", ""},
                            entry.key_place});
            break;
        }
        if (table == tables.end()) {
            refuse_unknown(entry, std::string_view(entry.key).substr(opening.size()), known, complaints);
            continue;
        }
        const std::string_view inner =
            std::string_view(entry.key).substr(std::min(table->opening.size(), entry.key.size()));
        const std::size_t point = inner.find('.');
        if (point != std::string_view::npos) refuse_unknown(entry, inner.substr(point + 1), table->keys, complaints);
    }
    complaints.throw_any();
}

NamedDirection direction_in(const TomlSection& table, std::string_view key) {
    const TomlEntry& entry = table.need(key);
    if (const auto* text = std::get_if<std::string>(&entry.value)) return *text;
    return table.numbers(key);
}

/// What a [[structure.contact]] table says, for `named_contact`.
struct TomlContact {
    const TomlSection& table;

    std::optional<std::string> text(std::string_view key) const {
        return table.has(key) ? std::optional(table.text(key)) : std::nullopt;
    }
    std::optional<double> number(const ContactField& field) const {
        return table.find_quantity(field.key, field.unit, field.range.low < 0.0 ? Bound::any : Bound::not_negative);
    }
    std::optional<NamedDirection> direction(const ContactField& field) const {
        const bool may_lack = field.need == ContactField::Need::optional;
        return may_lack && !table.has(field.key) ? std::nullopt : std::optional(direction_in(table, field.key));
    }
    std::optional<std::array<double, 3>> position(const ContactField& field) const {
        if (!table.has(field.key)) return std::nullopt;
        const std::vector<double> numbers = table.numbers(field.key, 3);
        return std::array{numbers[0], numbers[1], numbers[2]};
    }
};

std::vector<NamedContact> named_contacts(const TomlDocument& document, const TomlSection& section) {
    std::vector<NamedContact> named;
    if (section.has("contacts")) {
        const TomlEntry& entry = section.need("contacts");
        named = read_contacts_csv(opened(section.path(entry, section.text("contacts")), entry));
    }
    for (int number = 1;; ++number) {
        const TomlSection table(document, std::string(contact_opening) + std::to_string(number) + ".");
        if (document.find(std::string(contact_opening) + std::to_string(number)) == nullptr) break;
        named.push_back(named_contact(TomlContact{table}, table.place()));
    }
    if (named.empty())
        throw Error(ErrorKind::input,
                    {"the structure has no contact", "a case is about what rubs",
                     "Add [[structure.contact]] tables, or contacts = \"contacts.csv\"."},
                    section.place());
    return named;
}

std::vector<NamedOutput> named_outputs(const TomlDocument& document) {
    std::vector<NamedOutput> named;
    for (int number = 1;; ++number) {
        const std::string key = std::string(output_opening) + std::to_string(number);
        if (document.find(key) == nullptr) return named;
        const TomlSection table(document, key + ".");
        named.push_back(
            {table.text_or("name", ""), table.text_or("node", ""), direction_in(table, "direction"), table.place()});
    }
}

std::vector<double> dense_numbers(const reduction::SparseMatrix& matrix) {
    const Eigen::MatrixXd dense(matrix);
    const Eigen::MatrixXd both = 0.5 * (dense + dense.transpose());
    return {both.data(), both.data() + both.size()};
}

void expect_solvable(const ElasticPart& part, const TomlSection& section) {
    const auto rows = static_cast<std::size_t>(rows_of(part));
    if (rows > parameters::most_rows)
        throw Error(ErrorKind::input,
                    {"the structure has " + std::to_string(rows) + " rows",
                     "its motion is solved in dense matrices, of at most " + std::to_string(parameters::most_rows),
                     "Reduce it with `stridor structure reduce`."},
                    section.place());
    // rows of zeros have no mass: what may be done with them is checked with the case
    const Eigen::MatrixXd mass(part.mass);
    std::vector<Eigen::Index> inert;
    for (Eigen::Index row = 0; row < mass.rows(); ++row)
        if (!mass.row(row).isZero(0.0)) inert.push_back(row);
    const Eigen::MatrixXd inertial = mass(inert, inert);
    const Eigen::LLT<Eigen::MatrixXd> factor{inertial};
    if (inert.empty() || factor.info() != Eigen::Success)
        throw Error(
            ErrorKind::input,
            {"the mass is not positive definite", "some motion of the structure would have no inertia",
             "Give each row a mass, or take out those without. A finite-element part: reduce it by Craig-Bampton."},
            section.place());
    try {
        reduction::expect_no_buckling(part.stiffness, part.mass);
    } catch (const Error& error) {
        const TomlEntry* entry = section.find("file");
        if (entry == nullptr) entry = section.find("stiffness");
        throw Error(error.kind(), error.problem(), entry != nullptr ? entry->value_place : section.place());
    }
}

OwnStructure from_part(const TomlDocument& document, const TomlSection& section) {
    const NamedPart named = part_in(section);
    const ElasticPart& part = named.part;
    expect_solvable(part, section);
    OwnStructure own{
        .origin = named.origin, .mass = dense_numbers(part.mass), .stiffness = dense_numbers(part.stiffness)};
    for (const reduction::RowLabel& label : part.labels)
        own.row.push_back(describe(label));
    if (part.damping.rows() != 0) own.damping = dense_numbers(part.damping);
    own.following = {section.find_quantity("damping_ratio", "1", Bound::not_negative).value_or(0.0),
                     section.find_quantity("loss_factor", "1", Bound::not_negative).value_or(0.0),
                     section.find_quantity("rayleigh_mass", "1/s", Bound::not_negative).value_or(0.0),
                     section.find_quantity("rayleigh_stiffness", "s", Bound::not_negative).value_or(0.0)};
    own.left_out_above =
        section.find_quantity("left_out_above", "Hz", Bound::not_negative).value_or(named.left_out_above);
    if (section.has("initial_velocity")) own.initial_velocity = section.numbers("initial_velocity", own.row.size());
    if (section.has("load")) own.load = section.numbers("load", own.row.size());
    const std::vector<NamedContact> contacts = named_contacts(document, section);
    own.contacts = contacts_at(part, contacts);
    share_preload(own, contacts, section.place());
    own.springs = springs_in(document, part, own);
    reduction::Reduction recovered;
    recovered.part.labels = part.labels;
    recovered.part.sets = part.sets;
    recovered.recovered = named.recovered;
    recovered.recovery = named.recovery;
    own.outputs = outputs_at(recovered, named_outputs(document), own.contacts);
    return own;
}

OwnStructure from_builder(const StructureBuilder& builder, const TomlDocument& document, const TomlSection& section) {
    OwnStructure own = built_structure(builder, section);
    reduction::Reduction rows;
    for (const std::string& row : own.row)
        rows.part.labels.push_back({row, 0});
    own.outputs = outputs_at(rows, named_outputs(document), own.contacts);
    own.springs = springs_in(document, rows.part, own);
    return own;
}

bool starts_where_given(const TomlDocument& document) {
    const TomlEntry* initial = document.find("run.initial");
    const auto* name = initial == nullptr ? nullptr : std::get_if<std::string>(&initial->value);
    return name != nullptr && *name == "given";
}

// a start that opens or closes gaps would be none of the preloaded rest
void expect_closed(const OwnStructure& own, const TomlSection& section) {
    for (const parameters::OwnContact& contact : own.contacts) {
        double gap = 0.0, size = 0.0;
        for (std::size_t row = 0; row < own.row.size(); ++row) {
            gap += contact.normal[row] * own.initial_displacement[row];
            size += std::abs(contact.normal[row] * own.initial_displacement[row]);
        }
        constexpr double rounding = 1e-12;
        if (std::abs(gap) > rounding * size)
            throw Error(ErrorKind::input,
                        {"structure.initial_displacement moves contact \"" + contact.name + "\" along its normal",
                         "a motion starts with the gaps of the rest", ""},
                        section.need("initial_displacement").value_place);
    }
}

}  // namespace

std::span<const std::string_view> structure_keys(StructureKeys kind) {
    switch (kind) {
        case StructureKeys::matrices:
            return matrix_keys;
        case StructureKeys::numbers:
            return number_keys;
        case StructureKeys::lists:
            return list_keys;
        case StructureKeys::texts:
            return text_keys;
        case StructureKeys::of_contact:
            return contact_keys();
        case StructureKeys::of_output:
            return output_keys;
        case StructureKeys::of_spring:
            return spring_keys();
    }
    return {};
}

bool has_own_structure(const TomlDocument& document) {
    return std::any_of(document.entries.begin(), document.entries.end(), [](const TomlEntry& entry) {
        return entry.key == section_name && entry.origin == TomlOrigin::file &&
               std::holds_alternative<TomlTable>(entry.value);
    });
}

TomlDocument without_structure(const TomlDocument& document, Complaints& complaints) {
    TomlDocument rest{document.name, {}};
    for (const TomlEntry& entry : document.entries) {
        if (stands_below(entry.key, opening) && !is_read_as_field(entry.key)) continue;
        bool is_of_joint = false;
        for (const std::string_view section : {"joint", "plate", "temperature"}) {
            if (entry.key != section && !stands_below(entry.key, std::string(section) + ".")) continue;
            is_of_joint = true;
            if (entry.key == section || entry.origin == TomlOrigin::override)
                complaints.add({ErrorKind::input,
                                {entry.key + " stands beside [structure]",
                                 "a case has a joint on a plate or a structure of its own", "Remove one of them."},
                                entry.key_place});
        }
        if (!is_of_joint) rest.entries.push_back(entry);
    }
    return rest;
}

std::shared_ptr<const OwnStructure> read_own_structure(const TomlDocument& document) {
    const TomlSection section(document, std::string(opening));
    const StructureBuilder* builder = builder_of(section);
    check_keys(document, builder);
    OwnStructure own = builder != nullptr ? from_builder(*builder, document, section) : from_part(document, section);
    if (section.has("force")) own.force = section.numbers("force", own.row.size());
    if (section.has("initial_displacement")) {
        own.initial_displacement = section.numbers("initial_displacement", own.row.size());
        if (!starts_where_given(document)) expect_closed(own, section);
    }
    if (builder != nullptr && section.has("initial_velocity"))
        own.initial_velocity = section.numbers("initial_velocity", own.row.size());
    return std::make_shared<const OwnStructure>(std::move(own));
}

NamedPart part_of_case(const TomlDocument& document) {
    const TomlSection section(document, std::string(opening));
    if (!has_own_structure(document) || section.has("builder"))
        base::refuse("the case has no finite-element part", "only a part has nodes at places of their own",
                     "Name one: [structure] file = \"part.nc\".");
    return part_in(section);
}

std::shared_ptr<const OwnStructure> read_enclosed_structure(const TomlDocument& document) {
    const TomlSection section(document, std::string(opening));
    for (const TomlEntry& entry : document.entries)
        if (const auto* text = std::get_if<std::string>(&entry.value);
            text != nullptr && is_of({spring_opening, {}}, entry.key) && entry.key.ends_with(".table") &&
            !parameters::parse_force_table(*text).file.empty())
            throw Error(
                ErrorKind::input,
                {entry.key + " names a file", "of a case that is not your own file none is opened", "Give its rows."},
                entry.value_place);
    // a builder has numbers under its keys
    if (section.has("builder")) return read_own_structure(document);
    const auto is_matrix = [](std::string_view key) {
        return std::find(matrix_keys.begin(), matrix_keys.end(), key) != matrix_keys.end();
    };
    for (const std::string_view key : {"file", "labels", "contacts", "mass", "stiffness", "damping"}) {
        const TomlEntry* entry = section.find(key);
        if (entry == nullptr) continue;
        if (!is_matrix(key) || !std::holds_alternative<TomlRows>(entry->value))
            throw Error(ErrorKind::input,
                        {"structure." + std::string(key) + " names a file",
                         "of a case that is not your own file none is opened", ""},
                        entry->value_place);
    }
    return read_own_structure(document);
}

}  // namespace stridor::io
