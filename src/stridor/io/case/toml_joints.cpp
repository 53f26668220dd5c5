#include "stridor/io/case/toml_joints.hpp"

#include "stridor/base/escapes.hpp"
#include "stridor/base/text.hpp"
#include "stridor/parameters/fields/case_key.hpp"
#include "stridor/parameters/joints.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

namespace stridor::io {

namespace {

constexpr std::string_view list_key = "joint";
constexpr std::string_view table_opening = "temperature.";

// "joint.2" of a list; its own entry says where the table opens
std::string table_key(std::size_t number) {
    return std::string(list_key) + "." + std::to_string(number);
}

bool is_below(std::string_view key, std::string_view section) {
    return key.size() > section.size() && key.starts_with(section) && key[section.size()] == '.';
}

std::string name_of_joint(const TomlDocument& document, std::size_t number, const TomlEntry& table,
                          Complaints& complaints) {
    const TomlEntry* entry = document.find(table_key(number) + ".name");
    const auto* name = entry == nullptr ? nullptr : std::get_if<std::string>(&entry->value);
    if (name == nullptr) {
        complaints.add({ErrorKind::input,
                        {"this joint has no name", "each of several joints is called by one",
                         "Write for example name = \"lip" + std::to_string(number) + "\"."},
                        entry == nullptr ? table.key_place : entry->value_place});
        return {};
    }
    if (!parameters::names_a_joint(*name))
        complaints.add({ErrorKind::input,
                        {"\"" + base::visible(*name) + "\" cannot name a joint",
                         "a name has letters, digits, _ and - only, and is no key of [joint]", ""},
                        entry->value_place});
    return *name;
}

// "temperature.joint.lip2.axial_stiffness": a list of one joint, or the table that opens its lists
std::optional<parameters::JointKey> joint_over_temperature(const TomlEntry& entry) {
    if (!entry.key.starts_with(table_opening)) return std::nullopt;
    const std::string_view key = std::string_view(entry.key).substr(table_opening.size());
    if (const auto named = parameters::joint_key(key)) return named;
    const bool opens = std::holds_alternative<TomlTable>(entry.value) && is_below(key, list_key);
    return opens ? std::optional(parameters::JointKey{std::string(key.substr(list_key.size() + 1)), ""}) : std::nullopt;
}

// which joint has that name
std::optional<std::size_t> number_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
}

// its list, called as that of the only joint
std::optional<TomlEntry> list_for(TomlEntry entry, const parameters::JointKey& key,
                                  const std::vector<std::string>& names) {
    entry.joint = number_of(names, key.joint);
    if (!entry.joint || std::holds_alternative<TomlTable>(entry.value)) return std::nullopt;
    try {
        const std::string called = parameters::key_called(parameters::key_of_joint(key));
        entry.key = std::string(table_opening) + parameters::joint_key(called)->key;
    } catch (const Error& error) {
        throw Error(error.kind(), error.problem(), entry.key_place);
    }
    return entry;
}

// "joint.2.contact.preload": the number of its table
std::optional<std::size_t> table_of(std::string_view key, std::size_t count) {
    for (std::size_t number = 1; number <= count; ++number)
        if (key == table_key(number) || is_below(key, table_key(number))) return number;
    return std::nullopt;
}

// an entry as a file with one joint has it; nothing for one that is no value of a joint, or of one that is not there
std::optional<TomlEntry> renamed(const TomlEntry& entry, const std::vector<std::string>& names) {
    TomlEntry own = entry;
    if (const auto named = joint_over_temperature(entry)) return list_for(entry, *named, names);
    if (entry.origin == TomlOrigin::override) {
        const auto key = parameters::joint_key(entry.key);
        if (!key) return own;
        own.key = key->key;
        own.joint = number_of(names, key->joint);
        return own.joint ? std::optional(own) : std::nullopt;
    }
    if (entry.key == list_key) return std::nullopt;
    if (!is_below(entry.key, list_key)) return own;
    const std::optional<std::size_t> number = table_of(entry.key, names.size());
    if (!number) return std::nullopt;
    own.joint = *number - 1;
    const std::string table = table_key(*number);
    const std::string inner = entry.key == table ? "" : entry.key.substr(table.size() + 1);
    if (inner == "name") return std::nullopt;
    const bool is_of_contact = inner == "contact" || is_below(inner, "contact");
    own.key = inner.empty() ? std::string(list_key) : is_of_contact ? inner : std::string(list_key) + "." + inner;
    return own;
}

// "joint.preload": a key of the contact that stands with those of the joint itself
bool is_misplaced(const TomlEntry& own) {
    return is_below(own.key, list_key) && parameters::find_field(own.key) == nullptr &&
           parameters::find_field("contact." + own.key.substr(list_key.size() + 1)) != nullptr;
}

void check_names(const TomlDocument& document, const std::vector<std::string>& joints, Complaints& complaints) {
    const std::vector<std::string_view> names(joints.begin(), joints.end());
    for (const TomlEntry& entry : document.entries) {
        const auto over_temperature = joint_over_temperature(entry);
        const auto key = over_temperature                       ? over_temperature
                         : entry.origin == TomlOrigin::override ? parameters::joint_key(entry.key)
                                                                : std::nullopt;
        if (!key || std::holds_alternative<TomlTable>(entry.value)) continue;
        if (std::find(names.begin(), names.end(), key->joint) != names.end()) continue;
        const std::string near(base::nearest_name(key->joint, names));
        complaints.add({ErrorKind::input,
                        {"there is no joint \"" + base::visible(key->joint) + "\"", "",
                         near.empty() ? "" : "Did you mean joint." + near + "?"},
                        entry.key_place});
    }
}

}  // namespace

bool lists_joints(const TomlDocument& document) {
    return document.find(table_key(1)) != nullptr;
}

JointsDocument joints_document(const TomlDocument& document, Complaints& complaints) {
    JointsDocument joints{{}, {document.name, {}}};
    const TomlEntry* common = document.find("contact");
    if (common != nullptr && common->origin == TomlOrigin::file)
        complaints.add({ErrorKind::input,
                        {"[contact] stands beside [[joint]]", "each of several joints has a contact of its own",
                         "Move its keys to [joint.contact] below each joint."},
                        common->key_place});
    for (std::size_t number = 1; const TomlEntry* table = document.find(table_key(number)); ++number) {
        if (number > parameters::most_joints) {
            complaints.add({ErrorKind::input,
                            {"there are more than " + std::to_string(parameters::most_joints) + " joints",
                             "the motion between events is solved for all of them at once", ""},
                            table->key_place});
            break;
        }
        std::string name = name_of_joint(document, number, *table, complaints);
        if (!name.empty() && number_of(joints.names, name))
            complaints.add(
                {ErrorKind::input,
                 {"two joints are called \"" + base::visible(name) + "\"", "", "Give each a name of its own."},
                 document.find(table_key(number) + ".name")->value_place});
        joints.names.push_back(std::move(name));
    }
    for (const TomlEntry& entry : document.entries)
        complaints.keep([&] {
            auto own = renamed(entry, joints.names);
            if (own && is_misplaced(*own))
                complaints.add({ErrorKind::input,
                                {"unknown key " + own->key, "what presses and rubs has a section in each joint",
                                 "Write it below [joint.contact] of this joint."},
                                own->key_place});
            else if (own)
                joints.document.entries.push_back(std::move(*own));
        });
    check_names(document, joints.names, complaints);
    return joints;
}

}  // namespace stridor::io
