#include "stridor/io/case/toml_temperature.hpp"

#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/field_name.hpp"
#include "stridor/parameters/joints.hpp"
#include "stridor/parameters/tables/temperature_table.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace stridor::io {

namespace {

using parameters::Field;
using parameters::TemperatureColumn;

constexpr std::string_view section = "temperature.";
constexpr std::string_view value_key = "temperature.value";
constexpr std::string_view nodes_key = "temperature.at";

std::string_view name_in_table(const TomlEntry& entry) {
    return std::string_view(entry.key).substr(section.size());
}

bool may_follow(const Field& field) {
    const auto keys = parameters::keys_over_temperature();
    return std::find(keys.begin(), keys.end(), parameters::key_of(field)) != keys.end();
}

// the field whose list this is; nullptr if no such thing follows the temperature
const Field* follower(const TomlEntry& entry) {
    const std::vector<const Field*> called = parameters::fields_called(name_in_table(entry));
    return called.size() == 1 && may_follow(*called.front()) ? called.front() : nullptr;
}

// "joint" of "joint.axial_stiffness = [...]"
bool opens_names(const TomlEntry& entry) {
    const auto keys = parameters::keys_over_temperature();
    const std::string prefix = std::string(name_in_table(entry)) + ".";
    return std::holds_alternative<TomlTable>(entry.value) &&
           std::any_of(keys.begin(), keys.end(), [&](std::string_view key) { return key.starts_with(prefix); });
}

Error unknown(const TomlEntry& entry) {
    std::vector<std::string_view> names{nodes_key.substr(section.size()), value_key.substr(section.size())};
    for (const std::string_view key : parameters::keys_over_temperature()) {
        names.push_back(key);
        names.push_back(parameters::short_name(*parameters::find_field(key)));
    }
    const std::string_view near = base::nearest_name(name_in_table(entry), names);
    return {ErrorKind::input,
            {"unknown key " + entry.key, "stiffnesses, dampings and friction coefficients follow the temperature",
             near.empty() ? "" : "Did you mean " + std::string(section) + std::string(near) + "?"},
            entry.key_place};
}

// does it stand in the table, and is no temperature?
bool is_list(const TomlEntry& entry) {
    return is_temperature_list(entry.key) && entry.key != nodes_key;
}

// a joint of which nothing follows the temperature has no table: other ones' may have taken all lists
bool has_table(const DocumentView& view) {
    const std::vector<TomlEntry>& all = view.document.entries;
    return std::none_of(all.begin(), all.end(), [](const TomlEntry& entry) { return is_list(entry) && entry.joint; }) ||
           std::any_of(all.begin(), all.end(), [&](const TomlEntry& entry) {
               return is_list(entry) && view.has(entry) && !std::holds_alternative<TomlTable>(entry.value);
           });
}

// what stands in a list, as text
std::vector<std::string> items(const TomlEntry& entry) {
    if (const auto* texts = std::get_if<std::vector<std::string>>(&entry.value)) return *texts;
    if (const auto* text = std::get_if<std::string>(&entry.value); text != nullptr && entry.origin != TomlOrigin::file)
        return listed(*text);
    const auto* numbers = std::get_if<std::vector<double>>(&entry.value);
    if (numbers == nullptr)
        throw Error(ErrorKind::input,
                    {entry.key + " is " + std::string(type_name(entry.value)),
                     "expected a list: one value per temperature", ""},
                    entry.value_place);
    std::vector<std::string> texts;
    for (const double number : *numbers)
        texts.push_back(base::shortest(number));
    return texts;
}

// an error about a list, with its place
template <typename Part>
auto at_its_place(const TomlEntry& entry, Part&& part) {
    try {
        return part();
    } catch (const Error& error) {
        if (error.place()) throw;
        throw located(error, entry.key, entry.value_place);
    }
}

// the lists of a document, the one that counts for each property
std::vector<std::pair<const Field*, const TomlEntry*>> lists_of(const DocumentView& view, Complaints& complaints) {
    std::vector<std::pair<const Field*, const TomlEntry*>> lists;
    for (const TomlEntry& entry : view.document.entries) {
        if (!view.has(entry) || !is_list(entry) || opens_names(entry)) continue;
        const Field* field = follower(entry);
        const auto known =
            std::find_if(lists.begin(), lists.end(), [&](const auto& list) { return list.first == field; });
        if (field == nullptr)
            complaints.add(unknown(entry));
        else if (known == lists.end())
            lists.emplace_back(field, &entry);
        else if (entry.origin == TomlOrigin::file)
            complaints.add({ErrorKind::input,
                            {entry.key + " is " + parameters::key_of(*field) + " again",
                             "a table has one list of each property", "Remove one of the two."},
                            entry.key_place});
        else
            known->second = &entry;
    }
    return lists;
}

}  // namespace

bool is_temperature_list(std::string_view key) {
    return key.starts_with(section) && key != value_key;
}

bool has_temperature_list(const TomlDocument& document) {
    return std::any_of(document.entries.begin(), document.entries.end(),
                       [](const TomlEntry& entry) { return is_temperature_list(entry.key); });
}

const TomlEntry* find_temperature_list(const DocumentView& view, std::string_view key) {
    const TomlEntry* found = nullptr;
    for (const TomlEntry& entry : view.document.entries)
        if (view.has(entry) && is_temperature_list(entry.key) && follower(entry) == parameters::find_field(key))
            found = &entry;
    return found;
}

namespace {

struct NamedList {
    const Field* field;
    const TomlEntry* entry;
    std::optional<std::size_t> joint;
};

// of each joint its own and those of all; of the plate once
std::vector<NamedList> lists_of_joints(const TomlDocument& document, std::size_t joints, Complaints& complaints) {
    std::vector<NamedList> lists;
    for (std::size_t joint = 0; joint < joints; ++joint) {
        if (!has_table({document, joint})) continue;
        for (const auto& [field, entry] : lists_of({document, joint}, complaints)) {
            const bool is_shared = !parameters::is_of_joint(*field);
            const bool is_there = std::any_of(lists.begin(), lists.end(), [&, followed = field](const NamedList& list) {
                return is_shared && list.field == followed;
            });
            if (!is_there) lists.push_back({field, entry, is_shared ? std::nullopt : std::optional(joint)});
        }
    }
    return lists;
}

}  // namespace

std::vector<Untold> read_temperature_table(const TomlDocument& document, parameters::Case& c, Complaints& complaints) {
    if (!has_temperature_list(document)) return {};
    Complaints own;
    const TomlEntry* nodes = document.find(nodes_key);
    const std::vector<NamedList> lists = lists_of_joints(document, c.joints.size(), own);
    std::vector<double> at;
    if (nodes == nullptr)
        own.add({ErrorKind::input,
                 {"missing key " + std::string(nodes_key), "it says at which temperatures the lists are",
                  "Write for example at = [\"-30 degC\", \"23 degC\", \"80 degC\"] in [temperature]."},
                 base::Place{document.name, 0, 0, ""}});
    else
        own.keep([&] { at = at_its_place(*nodes, [&] { return parameters::read_temperature_nodes(items(*nodes)); }); });
    std::vector<TemperatureColumn> columns;
    for (const NamedList& list : lists)
        own.keep([&] {
            columns.push_back(at_its_place(
                *list.entry, [&] { return parameters::read_temperature_column(*list.field, items(*list.entry)); }));
            if (!at.empty()) at_its_place(*list.entry, [&] { parameters::check_length(columns.back(), at.size()); });
            if (list.joint) columns.back().key = parameters::key_at({c, *list.joint}, *list.field);
        });
    if (own.empty())
        own.keep([&] {
            at_its_place(*nodes, [&] { parameters::set_temperature_table(c, std::move(at), std::move(columns)); });
        });
    std::vector<Untold> unread;
    if (complaints.keep([&] { own.throw_any(); })) return unread;
    for (const NamedList& list : lists)
        unread.push_back({parameters::key_of(*list.field), list.joint});
    return unread;
}

}  // namespace stridor::io
